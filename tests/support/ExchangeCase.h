#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "tests/support/PathTracer.h"
#include "tests/support/SceneFixtures.h"

namespace irsg::test {

/// Grey bodies, their light and who looks: one scene for the library and for the path tracer.
struct ExchangeCase {
    std::string name, variant;
    /// Each material of them grey and opaque, or clear: then its faces are not there.
    std::vector<Entity> entities;
    SunPosition sun;
    double sun_W_m2 = 0.0; ///< in-band, perpendicular to its rays
    double sky_W_m2_sr = 0.0, ground_W_m2_sr = 0.0;
    double azimuth_deg = 0.0, elevation_deg = 0.0; ///< of the viewer, azimuth from +y towards +x
    int bounces = convergedBounces;
    std::optional<std::size_t> body;  ///< whose intensity it is about; else that of all
    std::optional<Vec3> place_m;      ///< then it is about the radiance there, W m-2 sr-1
    std::optional<double> closedForm; ///< of what it is about, where there is one
    double skin_m = 0.0;              ///< see PathTracer

    bool isLitAround() const { return sky_W_m2_sr + ground_W_m2_sr > 0.0; }
};

/// The band of all cases.
const Band& band();
Scene sceneOf(const ExchangeCase& one);
/// From a thousand radii away. From much farther the library knows places on the bodies less well:
/// distances are floats. Of a place a thousandth of the bodies around it.
SensorView viewOf(const ExchangeCase& one);
/// By the path tracer, for the same viewer.
TracedLight truthOf(const ExchangeCase& one, TraceSettings settings);

ExchangeCase seenFrom(std::string name, std::string variant, std::vector<Entity> entities,
                      double azimuth_deg, double elevation_deg);
/// An entity of a model of which every surface has this emissivity and temperature, but for
/// materials that are not there.
Entity greyEntity(std::shared_ptr<const Model> model, double emissivity, double temperature_K,
                  const std::set<int>& absentMaterials = {});
/// The same body turned, scaled and cut at random, and its materials as one entity or as many; sun
/// and viewer turn with it, and the closed form is scaled. LogicError for one that is lit by sky or
/// ground, which do not turn.
struct VariedCase {
    ExchangeCase body;
    double scale = 1.0; ///< of lengths
    std::string how;    ///< "scaled by 3.1, cut in 4, as many entities"
};
VariedCase varied(const ExchangeCase& one, unsigned seed);

struct NamedCases {
    std::string name;
    std::function<std::vector<ExchangeCase>()> make;
};
/// Surfaces whose inter-reflection is hard, without sky and ground.
std::vector<NamedCases> hardSurfaces();

} // namespace irsg::test
