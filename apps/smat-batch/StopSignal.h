#pragma once

namespace smat::batch {

/// From here on Ctrl-C and SIGTERM are noted instead of ending the program; a second one of its
/// kind ends it.
void catchStopSignal();
/// True once one of them has come.
bool stopWasAsked();

} // namespace smat::batch
