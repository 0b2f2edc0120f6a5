#include "apps/smat-batch/CaseTeam.h"

#include <algorithm>
#include <iterator>

namespace smat::batch {

std::vector<std::size_t> CaseDispenser::next() {
    /// Runs that each taker would get of what is left, were all as long as the next.
    constexpr std::size_t runsOfTaker = 4;
    const std::size_t left = open_.size() - given_;
    const std::size_t count = std::min(left, 1 + left / (takers_ * runsOfTaker));
    const auto first = open_.begin() + static_cast<std::ptrdiff_t>(given_);
    given_ += count;
    return {first, first + static_cast<std::ptrdiff_t>(count)};
}

} // namespace smat::batch
