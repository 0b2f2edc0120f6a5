#include "irsg/radiance/exchange/SurfaceWays.h"

#include <algorithm>
#include <cmath>

namespace irsg {

double SurfaceWays::meanEdge_m(std::size_t from) const {
    const auto beside = mesh_.beside(first_ + static_cast<std::uint32_t>(from));
    double sum_m = 0.0;
    for (const std::uint32_t vertex : beside)
        sum_m += plainLength(mesh_.vertices()[vertex].at_m - atOf(from));
    return beside.empty() ? 0.0 : sum_m / static_cast<double>(beside.size());
}

/// Vertices go on in the order of the steps in which their ways end, within one as they came, and
/// again where a shorter way turns up. To order them within a step, as a heap does, took most of
/// the time of large models.
void SurfaceWays::find(std::size_t from, double most_m) {
    const double longest_m = detour * most_m;
    const double step_m =
        std::max(stepOfEdge * meanEdge_m(from), longest_m / static_cast<double>(mostSteps));
    const double stepsPer_m = 1.0 / step_m;
    const Vec3 from_m = atOf(from);
    ++turn_;
    reached_.assign(1, static_cast<std::uint32_t>(from));
    ways_[from] = {0.0, turn_};
    open_.resize(std::max<std::size_t>(open_.size(), 1));
    open_[0].push_back({0.0, static_cast<std::uint32_t>(from)});
    for (std::size_t step = 0, last = 0; step <= last; ++step) {
        for (std::size_t i = 0; i < open_[step].size(); ++i) {
            const Open here = open_[step][i];
            if (here.way_m > ways_[here.place].way_m)
                continue;
            const Vec3& here_m = atOf(here.place);
            for (const std::uint32_t vertex : mesh_.beside(first_ + here.place)) {
                const std::uint32_t next = vertex - first_;
                Way& known = ways_[next];
                const bool isKnown = known.turn == turn_;
                const double shorter_m = known.way_m - here.way_m;
                if (isKnown && shorter_m <= 0.0)
                    continue;
                const Vec3& next_m = atOf(next);
                const Vec3 edge = next_m - here_m;
                const double square_m2 = product(edge, edge);
                if (isKnown && square_m2 > above * shorter_m * shorter_m)
                    continue;
                const double way_m = here.way_m + std::sqrt(square_m2);
                if (way_m > longest_m || (isKnown && way_m >= known.way_m))
                    continue;
                // Who is so far away comes back to nobody that is near enough in the rest of the
                // way.
                const double mostApart_m = most_m + longest_m - way_m;
                const Vec3 apart = next_m - from_m;
                if (product(apart, apart) > above * mostApart_m * mostApart_m)
                    continue;
                if (!isKnown)
                    reached_.push_back(next);
                known = {way_m, turn_};
                const auto to = static_cast<std::size_t>(way_m * stepsPer_m);
                last = std::max(last, to);
                if (to >= open_.size())
                    open_.resize(to + 1);
                open_[to].push_back({way_m, next});
            }
        }
        open_[step].clear();
    }
}

} // namespace irsg
