#include "apps/smat-batch/RunControl.h"

#include "apps/smat-batch/StopSignal.h"

namespace smat::batch {

RunControl::operator JobControl() {
    return {.progress =
                [this](const Progress& progress) {
                    line_.show(progress);
                    if (stopWasAsked())
                        stop_.request_stop();
                },
            .stop = stop_.get_token(),
            .timer = &context_.timer,
            .team = context_.team};
}

void warnOf(const JobOutcome& outcome) {
    for (const std::string& remark : outcome.remarks)
        warn(remark);
}

int endOfRun(bool isComplete) {
    if (isComplete || !stopWasAsked())
        return done;
    warn("stopped; what was done so far is kept");
    return warned;
}

} // namespace smat::batch
