#include "apps/smat-batch/PartOptions.h"

#include "apps/smat-batch/Output.h"
#include "apps/smat-batch/StopSignal.h"

namespace smat::batch {

PartOptions::PartOptions(CLI::App& command, const std::string& of) {
    command
        .add_option("--shard", shard_,
                    "Draw one part of " + of +
                        ", 2/4 for the second of four, into FILE.part2of4; smat-batch merge joins "
                        "the parts")
        ->type_name("I/N");
    command.add_flag("--resume", resumes_, "Go on with a run that was ended before it was done");
}

void PartOptions::refuse(const std::string& expected) const {
    if (isGiven())
        throw refusal(shard_.empty() ? "--resume" : "--shard", "an option", expected);
}

bool renderedByTeam(const CasePlace& place, CaseTeam& team, const CaseWork& work) {
    ProgressLine line;
    return smat::renderedByTeam(place, team, work,
                                [&](const Progress& progress) { line.show(progress); });
}

void workThrough(CaseStore& store, const CaseWork& work) {
    ProgressLine line;
    std::stop_source stop;
    work(
        store,
        [&](const Progress& progress) {
            line.show(progress);
            if (stopWasAsked())
                stop.request_stop();
        },
        stop.get_token());
}

} // namespace smat::batch
