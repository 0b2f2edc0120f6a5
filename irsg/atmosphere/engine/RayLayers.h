#pragma once

#include <cstddef>
#include <vector>

#include "irsg/radiometry/GaussLegendre.h"

namespace irsg {

/// Refraction in spherical shells: between grid altitudes n - 1 falls exponentially, above the top
/// n is constant. With w = n r (it must grow with altitude) a ray is C = w cos(elevation), and
/// u = w - C = w (1 - cos(elevation)) says how far it is from horizontal. Everything is written in
/// differences of altitude, so that a path of 1 cm keeps its digits.
class RayLayers {
  public:
    /// A point by its layer and its height above the layer's base, with w - w(ground).
    struct Place {
        int layer = 0;
        double height_m = 0.0;
        double w_m = 0.0;
    };
    /// A piece of a ray that rises within one layer, from where u is `lowU_m`.
    struct Rise {
        int layer = 0;
        double lowHeight_m = 0.0; ///< above the layer's base
        double height_m = 0.0;    ///< of the piece itself
        double lowU_m = 0.0;
    };
    struct Measures {
        double length_m = 0.0;
        double meanHeight_m = 0.0; ///< above the layer's base, averaged along the piece
        double angle_rad = 0.0;    ///< at the earth's centre
    };

    /// `refractivity` holds n - 1 at the grid altitudes. Its steps are held between those whose
    /// rays bend by 0.8 of the earth's curvature down and up, so that no layer traps rays.
    RayLayers(std::vector<double> altitudes_m, std::vector<double> refractivity,
              double earthRadius_m);

    /// The number of layers inside the atmosphere; this is also the number of the shell above.
    int top() const { return static_cast<int>(altitudes_m_.size()) - 1; }
    double base_m(int layer) const { return altitudes_m_[static_cast<std::size_t>(layer)]; }
    double thickness_m(int layer) const { return base_m(layer + 1) - base_m(layer); }

    Place place(double altitude_m) const;
    double altitude_m(const Place& place) const { return base_m(place.layer) + place.height_m; }
    double index(const Place& place) const;
    /// n r, in m.
    double w_m(const Place& place) const { return groundW_m_ + place.w_m; }
    double groundW_m() const { return groundW_m_; }
    /// w at `high` minus w at `low`, without loss of digits where both are in one layer.
    double difference_m(const Place& low, const Place& high) const;
    /// The place where w is smaller than at `from` by `fall_m`, and how far below it is. The fall
    /// must not lead below ground.
    Place below(const Place& from, double fall_m, double& depth_m) const;

    /// Measures of a piece of the ray with invariant C.
    Measures measure(const Rise& rise, double invariant_m) const;

    /// Sine of the elevation in the middle of a piece inside the atmosphere.
    double sineInMiddle(const Rise& rise, double invariant_m) const;

    /// Calls sink(Rise) for every piece from `low`, where u is `lowU_m`, up to `high`, which is
    /// `height_m` above it.
    template <typename Sink>
    void climb(const Place& low, const Place& high, double height_m, double lowU_m,
               Sink&& sink) const {
        const double aboveFirst_m =
            low.layer == high.layer ? 0.0
                                    : base_m(high.layer) - base_m(low.layer + 1) + high.height_m;
        double from_m = low.height_m;
        double u_m = lowU_m;
        for (int layer = low.layer; layer <= high.layer; ++layer) {
            const bool isLast = layer == high.layer;
            const double piece_m = low.layer == high.layer ? height_m
                                   : isLast                ? high.height_m
                                   : layer == low.layer    ? height_m - aboveFirst_m
                                                           : thickness_m(layer);
            if (piece_m > 0.0)
                sink(Rise{layer, from_m, piece_m, u_m});
            if (isLast)
                break;
            from_m = 0.0;
            u_m = lowU_m + (layers_[static_cast<std::size_t>(layer) + 1].w_m - low.w_m);
        }
    }

  private:
    struct Layer {
        double w_m = 0.0; ///< at the base, less that of the ground
        double refractivity = 0.0;
        double perHeight_per_m = 0.0; ///< of its exponential fall
        const GaussRule* rule = nullptr;
    };
    /// w at `rise_m` above a place less w there.
    double rise_m(double radius_m, double refractivity, double perHeight_per_m,
                  double rise_m) const;
    struct Stretch;
    /// In the shell above the top, in closed form.
    Measures measureStraight(const Rise& rise, double invariant_m) const;
    double radius_m(int layer) const { return earthRadius_m_ + base_m(layer); }

    std::vector<double> altitudes_m_;
    double earthRadius_m_;
    double groundW_m_ = 0.0;
    std::vector<Layer> layers_; ///< one more than layers: the shell above the top
};

} // namespace irsg
