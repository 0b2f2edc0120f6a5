#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "irsg/gas/GasVector.h"

namespace irsg {

/// Places in space, found by their nearness (J. L. Bentley 1975, Commun. ACM 18, 509).
class NearestPoints {
  public:
    struct Found {
        double distance2_m2 = 0.0; ///< square of the distance
        std::uint32_t number = 0;  ///< of the place
    };

    /// Up to 2^32 - 1 of them.
    explicit NearestPoints(std::vector<GasVector> places_m);

    const std::vector<GasVector>& places_m() const { return places_m_; }
    /// Fills `found` with the nearest places, the nearest first, and says how many there are: as
    /// many as it holds, or all places.
    std::size_t nearest(const GasVector& to_m, std::span<Found> found) const;

  private:
    void order(std::size_t first, std::size_t end, int axis);

    std::vector<GasVector> places_m_;
    GasVector least_m_{}, most_m_{}; ///< corners of the box about them
    /// Numbers of places: the middle of a range divides it by the axis of its depth.
    std::vector<std::uint32_t> order_;
};

} // namespace irsg
