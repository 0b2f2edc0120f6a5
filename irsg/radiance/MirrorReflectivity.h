#pragma once

#include <cstddef>
#include <vector>

#include "irsg/radiance/SceneRadiometry.h"
#include "irsg/signature/SurfaceModel.h"

namespace irsg {

/// How much the surfaces of a scene reflect by direction, at most at any wavelength, which decides
/// what lobes follow from mirror to mirror.
class MirrorReflectivity {
  public:
    MirrorReflectivity() = default;
    MirrorReflectivity(const SceneRadiometry& radiometry, int bounces);

    /// Whether what the lobes of `row` show matters by direction, and not on the whole alone, where
    /// it is seen over so many mirrors. `most`: the most that arrives of what it sends.
    bool isFollowed(double most, int row, int mirrors) const {
        return mirrors < mostFollowed_ &&
               most * of(row) > (mirrors == 0 ? leastFollowed : leastFollowedOn);
    }
    /// Whether a part of what arrives does.
    static bool matters(double part) { return part > leastPart; }
    /// Over the hemisphere.
    double of(int row) const { return hemispherical_[static_cast<std::size_t>(row)]; }
    /// The amount of a component.
    double amountOf(int row, std::size_t component) const {
        return amounts_[static_cast<std::size_t>(row)][component];
    }
    bool isAnyFollowed() const;
    /// Whether a component is, behind the brightest of all.
    bool isComponentFollowed(int row, std::size_t component) const;
    /// What rays of lobes depend on.
    std::vector<double> key() const;

  private:
    static constexpr double leastFollowed = 0.1, leastFollowedOn = 0.3, leastPart = 0.003;
    std::vector<double> hemispherical_;          // by drawn row; 0 for a Lambertian one
    std::vector<SurfaceModel::Amounts> amounts_; // likewise
    double most_ = 0.0;                          // of all rows
    int mostFollowed_ = 0;
};

} // namespace irsg
