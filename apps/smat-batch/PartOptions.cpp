#include "apps/smat-batch/PartOptions.h"

#include <chrono>

#include <fmt/format.h>

#include "apps/smat-batch/CaseTeam.h"
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

bool drawnByTeam(const CasePlace& place, CaseTeam& team, const CaseWork& work) {
    if (!place.share.isAll())
        throw refusal("--shard", "a part of the sweep",
                      "none: the processes take their parts by themselves");
    if (!team.isLeader()) {
        const auto store = team.follow(place.inputs);
        work(*store, {}, {});
        return false;
    }
    CaseFile file(CaseFile::besides(place.result, place.share), place.options());
    const auto start = std::chrono::steady_clock::now();
    ProgressLine line;
    std::size_t total = 0;
    const auto show = [&](std::size_t done) {
        const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
        line.show({done, total, passed.count(), fmt::format("{} processes", team.size())});
    };
    const auto store = team.lead(file);
    work(*store,
         [&](const Progress& progress) {
             total = progress.total;
             show(progress.done);
         },
         {});
    team.finish(show);
    return true;
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
