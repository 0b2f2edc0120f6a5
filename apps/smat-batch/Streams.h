#pragma once

#include <string>

namespace smat::batch {

/// To be called first. A stream that is closed gets a place of its own, so that no file of ours is
/// taken for it; neither a reader of standard output that goes away nor a file that grows beyond
/// the limit of the process (RLIMIT_FSIZE) ends the program.
void openStreams();

/// Whether something that was printed did not arrive; brings out what still waits.
bool outputFailed();
/// In the words of the system.
std::string outputProblem();

} // namespace smat::batch
