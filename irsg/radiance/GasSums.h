#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "irsg/radiance/GasWalk.h"
#include "irsg/radiance/SurfaceRows.h"

namespace irsg {

/// What gas emits in samples that count alike, by what stands before it and by row. Weights of
/// columns are linear in what a line of sight does in gas of many strengths, so that this is summed
/// and columns are left for the end.
class GasSums {
  public:
    struct Place {
        int stack = 0, row = 0;
        const GasColumnsOfEntity* columns = nullptr;
        int firstSet = 0;           ///< of its columns: see GasWalk::Emission
        std::vector<double> values; ///< likewise
        bool isSeen = false;
    };

    /// `share`: what the sample counts beside others of its pixel.
    void add(int stack, const SurfaceRows::Between& between, const GasWalk::Emission& one,
             double share = 1.0) {
        const auto next = static_cast<double>(between.next);
        const double weight = share * one.share * one.before.weight;
        addTo(stack, between.row, one, weight * (1.0 - next));
        if (next > 0.0)
            addTo(stack, between.row + 1, one, weight * next);
    }
    /// Calls visit(number, place) for the places that were seen since the last time, which begin
    /// anew. A place keeps its number.
    template <typename Visit>
    void take(const Visit& visit) {
        for (const std::size_t number : seen_) {
            Place& place = places_[number];
            visit(number, place);
            std::ranges::fill(place.values, 0.0);
            place.isSeen = false;
        }
        seen_.clear();
    }
    const std::vector<Place>& places() const { return places_; }

  private:
    void addTo(int stack, int row, const GasWalk::Emission& one, double weight) {
        const std::size_t number = numberOf(stack, row, one);
        Place& place = places_[number];
        if (!place.isSeen) {
            place.isSeen = true;
            seen_.push_back(number);
        }
        double* const sums = place.values.data();
        for (std::size_t i = 0; i < one.values.size(); ++i)
            sums[i] += weight * one.values[i];
    }
    std::size_t numberOf(int stack, int row, const GasWalk::Emission& one) {
        const auto isIt = [&](const Place& place) {
            return place.stack == stack && place.row == row && place.firstSet == one.firstSet;
        };
        if (last_ < places_.size() && isIt(places_[last_]))
            return last_;
        const auto found = std::ranges::find_if(places_, isIt);
        last_ = static_cast<std::size_t>(found - places_.begin());
        if (found == places_.end())
            places_.push_back({stack, row, one.columns, one.firstSet,
                               std::vector<double>(one.values.size(), 0.0), false});
        return last_;
    }

    std::vector<Place> places_;
    std::vector<std::size_t> seen_;
    std::size_t last_ = 0;
};

} // namespace irsg
