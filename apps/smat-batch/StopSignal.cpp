#include "apps/smat-batch/StopSignal.h"

#include <csignal>
#include <initializer_list>

namespace smat::batch {

namespace {

volatile std::sig_atomic_t asked = 0;

void note(int) {
    asked = 1;
}

} // namespace

void catchStopSignal() {
    struct sigaction action {};
    action.sa_handler = note;
    action.sa_flags = SA_RESETHAND; // the second one has its ordinary effect
    for (const int signal : {SIGINT, SIGTERM})
        sigaction(signal, &action, nullptr);
}

bool stopWasAsked() {
    return asked != 0;
}

} // namespace smat::batch
