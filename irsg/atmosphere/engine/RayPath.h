#pragma once

#include <optional>
#include <vector>

#include "irsg/atmosphere/engine/Profile.h"
#include "irsg/atmosphere/engine/RayLayers.h"
#include "irsg/atmosphere/path/AtmosphericQuery.h"
#include "irsg/atmosphere/path/Earth.h"

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
    double length_m = 0.0;          ///< along the ray, inside the atmosphere: of all segments
    double endElevation_rad = 0.0;  ///< elevation of the outgoing direction at the far end
    double tangentAltitude_m = 0.0; ///< the lowest point of the ray
};

/// Paths over a spherical earth through a refracting profile. `gridAltitudes_m`, ascending from 0
/// to at most the profile's top, are where a ray is cut, so that every segment lies in one layer; a
/// segment that holds the tangent point is cut there.
///
/// Rays follow the spherical Snell invariant n r cos(elevation) = const. The refractivity n - 1 at
/// the grid altitudes is that of dry air and of water vapour at 4 um (Ciddor 1996, Appl. Opt. 35,
/// 1566, dispersion left out: 2.7272e-4 at 288.15 K and 1013.25 hPa, 3.019e-6 at 293.15 K and 13.33
/// hPa, both as density; the dispersion of dry air is below 0.5 % beyond 2 um) and falls
/// exponentially between them. Layers whose refractivity changes so fast that rays would bend by
/// more than 0.8 of the earth's curvature, up or down, are given that limit: a surface inversion
/// then bends strongly but traps no ray. Above the top the index is that of the top and rays are
/// straight.
///
/// A finite path joins its two ends: the elevation at the lower end is searched until the ray has
/// `range_m` between the two altitudes; both directions of a path are the same ray. Where it would
/// dip below the ground (both ends low, the scene is flat), it goes down to the ground, runs along
/// altitude 0 for what remains of the range and goes up again. Lengths hold to about 1e-10, from
/// 1 cm on. All members may be called from several threads.
class RayTracer {
  public:
    /// LogicError for a grid that breaks the rule above or has fewer than two altitudes.
    RayTracer(const Profile& profile, std::vector<double> gridAltitudes_m,
              double earthRadius_m = irsg::earthRadius_m);

    const std::vector<double>& gridAltitudes_m() const { return altitudes_m_; }
    double earthRadius_m() const { return earthRadius_m_; }

    /// A finite path. Its parts above the top of the atmosphere are left out. A range shorter than
    /// the difference of the altitudes by at most a millionth is vertical. Throws InputError for
    /// altitudes below ground, for a range still shorter, and for ends that the earth hides: their
    /// straight line in space lies more than 500 m below ground at its lowest point.
    RayPath between(const AtmosphericPath& path) const;
    /// How the target of such a path is seen; also of one that the earth hides.
    TargetView targetView(const AtmosphericPath& path) const;
    /// Altitude, at a distance along the ray that grazes the ground, below which the earth hides
    /// what a sensor looks for; 0 where the ray has not touched the ground yet.
    double hiddenBelow_m(double sensorAltitude_m, double range_m) const;
    /// To space or to the ground. A sensor above the atmosphere enters it where the line meets the
    /// top, or sees nothing (no segments, end space).
    RayPath along(const LineOfSight& sight) const;
    /// Towards the sun from an altitude (true, unrefracted elevation: the apparent one is
    /// searched); no segments and end `ground` where the earth hides it.
    RayPath towardsSun(double altitude_m, double trueElevation_rad) const;

    /// Apparent elevation below which lines of sight from an altitude end on the ground, and the
    /// true elevation of what is seen there.
    double horizonElevation_rad(double altitude_m) const;
    double trueHorizonElevation_rad(double altitude_m) const;
    /// Apparent elevation of what stands at a true elevation; below the horizon of the altitude,
    /// as far below it as it truly is.
    double apparentElevation_rad(double altitude_m, double trueElevation_rad) const;

    /// Light from what the horizon of an altitude leaves of the sun's disc, along the ray from the
    /// middle of that part (see SunDiscGeometry.h). A disc that is hidden has part 0 and the ray
    /// that grazes the ground.
    struct Sunbeam {
        double part = 0.0;
        RayPath ray;
    };
    Sunbeam sunbeam(double altitude_m, double trueElevation_rad) const;

    /// The index that rays see at an altitude of 0 or more.
    double refractiveIndex(double altitude_m) const;

  private:
    struct Chord;
    double elevationOver(const Chord& chord, double range_m, double& length_m) const;
    /// The same of any path, the vertical ones too.
    double elevationAtLow(const Chord& chord, double range_m, double& length_m) const;
    Chord chordOf(const AtmosphericPath& path) const;
    double lengthOf(const Chord& chord, double elevation_rad) const;
    double trueElevation(double altitude_m, double apparent_rad) const;
    /// Apparent elevation of a true one; nothing below the horizon.
    std::optional<double> apparentOf(double altitude_m, double trueElevation_rad) const;
    /// Elevation below which a ray from there meets the ground.
    double groundElevation(const RayLayers::Place& place) const;

    std::vector<double> altitudes_m_;
    double earthRadius_m_;
    RayLayers layers_;
};

} // namespace irsg
