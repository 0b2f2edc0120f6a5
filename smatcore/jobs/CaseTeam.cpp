#include "smatcore/jobs/CaseTeam.h"

#include <algorithm>
#include <chrono>
#include <iterator>

#include <fmt/format.h>

#include "irsg/core/Errors.h"

namespace smat {

std::vector<std::size_t> CaseDispenser::next() {
    /// Runs that each taker would get of what is left, were all as long as the next.
    constexpr std::size_t runsOfTaker = 4;
    const std::size_t left = open_.size() - given_;
    const std::size_t count = std::min(left, 1 + left / (takers_ * runsOfTaker));
    const auto first = open_.begin() + static_cast<std::ptrdiff_t>(given_);
    given_ += count;
    return {first, first + static_cast<std::ptrdiff_t>(count)};
}

bool renderedByTeam(const CasePlace& place, CaseTeam& team, const CaseWork& work,
                    const ProgressCallback& progress) {
    if (!place.share.isAll())
        throw irsg::InputError({.file = "--shard",
                                .position = "",
                                .value = "a part of the sweep",
                                .expected = "none: the processes take their parts by themselves"});
    if (!team.isLeader()) {
        const auto store = team.follow(place.inputs);
        work(*store, {}, {});
        return false;
    }
    CaseFile file(CaseFile::besides(place.result, place.share), place.options());
    const auto start = std::chrono::steady_clock::now();
    std::size_t total = 0;
    const auto show = [&](std::size_t done) {
        const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
        if (progress)
            progress({done, total, passed.count(), fmt::format("{} processes", team.size())});
    };
    const auto store = team.lead(file);
    work(*store,
         [&](const Progress& now) {
             total = now.total;
             show(now.done);
         },
         {});
    team.finish(show);
    return true;
}

} // namespace smat
