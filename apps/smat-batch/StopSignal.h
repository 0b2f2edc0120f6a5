#pragma once

namespace smat::batch {

/// From here on Ctrl-C is noted instead of ending the program; a second one ends it.
void catchStopSignal();
/// True once Ctrl-C was pressed.
bool stopWasAsked();

} // namespace smat::batch
