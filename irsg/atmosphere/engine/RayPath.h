#pragma once

#include <vector>

#include "irsg/atmosphere/Atmosphere.h"
#include "irsg/atmosphere/engine/Profile.h"

namespace irsg {

/// A piece of a ray inside one layer of air.
struct RaySegment {
    int layer = 0; ///< between grid altitudes `layer` and `layer + 1`
    double length_m = 0.0;
    double startAltitude_m = 0.0; ///< at the end that is nearer to the sensor
    double endAltitude_m = 0.0;
    /// Mean over the piece of (z - z[layer]) / (z[layer+1] - z[layer]): what a quantity that is
    /// linear in altitude needs to be integrated exactly.
    double meanFraction = 0.0;
    double sinElevation = 0.0; ///< of the direction away from the sensor, at the middle
};

/// A refracted ray through spherical shells, from the sensor outward.
struct RayPath {
    enum class End { target, ground, space };

    std::vector<RaySegment> segments;
    End end = End::target;
    double length_m = 0.0;          ///< along the ray, inside the atmosphere
    double endElevation_rad = 0.0;  ///< elevation of the outgoing direction at the far end
    double tangentAltitude_m = 0.0; ///< the lowest point of the ray
};

/// Paths over a spherical earth through a refracting profile. `gridAltitudes_m`, ascending from 0,
/// are where a ray is cut, so that every segment lies in one layer; a segment that holds the
/// tangent point is cut there.
///
/// The refractive index falls with altitude as in the profile at a wavelength of the infrared
/// (Edlen/Ciddor dry air without dispersion to first order, and water vapour); rays follow the
/// spherical Snell invariant n r cos(elevation) = const. A finite path joins its two ends: the
/// apparent elevation is searched until the ray arrives at the target's altitude after `range_m`.
/// Where a finite path would dip below the ground (both ends low, the scene is flat), the part
/// below runs along altitude 0.
class RayTracer {
  public:
    RayTracer(const Profile& profile, std::vector<double> gridAltitudes_m,
              double earthRadius_m = 6371.23e3);

    const std::vector<double>& gridAltitudes_m() const { return altitudes_m_; }
    double earthRadius_m() const { return earthRadius_m_; }

    /// A finite path, 0 to 2000 km long. Its parts above the top of the atmosphere are left out.
    /// Throws InputError for altitudes below ground, for a range shorter than the difference of the
    /// altitudes by more than a millionth of it, and for ends that the earth hides by more than
    /// refraction explains.
    RayPath between(const AirPath& path) const;
    /// To space or to the ground. A sensor above the atmosphere enters it where the line meets the
    /// top, or sees nothing (no segments, end space).
    RayPath along(const LineOfSight& sight) const;
    /// Towards the sun from an altitude (true, unrefracted elevation: the apparent one is
    /// searched); no segments and end `ground` where the earth hides it.
    RayPath towardsSun(double altitude_m, double trueElevation_rad) const;

    /// Refractive index of the profile.
    double refractiveIndex(double altitude_m) const;

  private:
    std::vector<double> altitudes_m_;
    std::vector<double> refractivity_; ///< n - 1 at the grid altitudes
    double earthRadius_m_;
};

} // namespace irsg
