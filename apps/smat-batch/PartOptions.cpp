#include "apps/smat-batch/PartOptions.h"

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

} // namespace smat::batch
