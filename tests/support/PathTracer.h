#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "irsg/geometry/view/Vec3.h"

namespace irsg::test {

/// A facet in the world that emits and reflects grey in-band radiation evenly in all directions.
struct TracedTriangle {
    std::array<Vec3, 3> corners_m; ///< counter-clockwise from the front
    /// Else it is seen from its front alone: rays that look at its back pass.
    bool isTwoSided = true;
    double emitted_W_m2_sr = 0.0;
    double reflectivity = 0.0; ///< 0 to 1
    int body = 0;
};

/// What lights the bodies from outside, in-band.
struct TracedSurroundings {
    Vec3 towardsSun{0, 0, 1};
    /// Perpendicular to its rays. The sun is a point. A one-sided facet takes its light away where
    /// the sun sees its front.
    double sun_W_m2 = 0.0;
    double sky_W_m2_sr = 0.0;    ///< everywhere above the horizon, z > 0
    double ground_W_m2_sr = 0.0; ///< everywhere below
};

/// A mean over independent batches, with its standard error.
struct TracedValue {
    double value = 0.0, error = 0.0;
};

/// Radiant intensity in a direction, W/sr, or a radiance, W m-2 sr-1, by what happened to the light
/// before.
struct TracedLight {
    TracedValue total;
    TracedValue emitted;         ///< emission that is seen directly
    TracedValue onceFromOutside; ///< sun, sky and ground, reflected once
    TracedValue onceFromOthers;  ///< emission of other facets, reflected once
    TracedValue more;            ///< whatever was reflected more than once
    /// What light that goes from facet to facet adds: the last two.
    TracedValue between;
    std::uint64_t paths = 0;
    double processor_s = 0.0; ///< of all threads
};

inline constexpr int tracedToTheEnd = -1;

struct TraceSettings {
    /// How often light goes from facet to facet before it is seen, or tracedToTheEnd. What comes
    /// from outside lights every facet of a path.
    int bounces = tracedToTheEnd;
    /// More paths are traced until the standard error of the total is below this part of it...
    double relativeError = 5e-4;
    /// ...and that of `between` below this part of it, where it is above 0...
    double relativeErrorOfBetween = 0.0;
    /// ...or this much processor time has gone.
    double longest_s = 60.0;
    unsigned seed = 1;
    unsigned threads = 2;
    /// Whose intensity: of one body, which others may hide; else of all.
    std::optional<int> body = {};
    /// How far the viewer is from `centre_m`, more than all bodies; 0 stands for infinitely far.
    /// The intensity is radiance times solid angle times the square of this distance.
    double distance_m = 0.0;
    Vec3 centre_m = {};
};

/// An independent witness for inter-reflection: a path tracer in double precision that shares no
/// code with the library but its vectors. Paths start evenly over a rectangle around the bodies as
/// they are seen, in parallel projection or from a viewer, and follow Sobol' points with scrambled
/// digits; Russian roulette ends them late and without bias. Small facets that outshine the others
/// are aimed at, too, and both ways are weighted by the balance heuristic (Veach 1997, ch. 9.2).
class PathTracer {
  public:
    /// Rays start `skin_m` before the facet they leave; 0 stands for 1e-9 of the size of it all.
    /// Facets that lie in one plane but for rounding need a skin above that rounding.
    PathTracer(const std::vector<TracedTriangle>& triangles, const TracedSurroundings& surroundings,
               double skin_m = 0.0);
    ~PathTracer();
    PathTracer(const PathTracer&) = delete;
    PathTracer& operator=(const PathTracer&) = delete;

    /// Seen from this direction, a unit vector.
    TracedLight intensity(const Vec3& towardsViewer, const TraceSettings& settings = {}) const;
    /// What comes from a place on a facet in this direction, in parallel projection.
    TracedLight radiance(const Vec3& place_m, const Vec3& towardsViewer,
                         const TraceSettings& settings = {}) const;

  private:
    struct Impl;
    std::unique_ptr<const Impl> impl_;
};

} // namespace irsg::test
