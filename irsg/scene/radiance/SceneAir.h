#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "irsg/atmosphere/Environment.h"
#include "irsg/scene/Entity.h"
#include "irsg/scene/RenderSettings.h"

namespace irsg {

/// The geometry that the air is asked for, once per object.
struct ObjectGeometry {
    AirPath path;                 ///< sensor to reference point
    double aspectAngle_rad = 0.0; ///< nose axis to the direction reference point -> sensor
};

/// The air of one object. A value is a Spectrum on its own axis, or one number per node.
template <typename Value>
struct ObjectAir {
    Value transmittance, pathRadiance, solarIrradiance, upwardFlux, downwardFlux;
    double ambient_K = 288.15;
    /// Transmittance to the reference distance of a user-defined spectrum, by its name.
    std::map<std::string, Value> toReference;
    std::set<std::string> insideReference; ///< names of spectra measured from farther away
};

/// All that a scene asks of its environment: once per object, and once for the background.
template <typename Value>
struct SceneAir {
    std::vector<ObjectAir<Value>> objects;
    Value background;
    std::vector<std::string> answeredBy; ///< "transmittance: vacuum", each once
    std::vector<std::string> warnings;   ///< each once
};

/// In the spectral mode, over a range. What the settings do not use is 0 and not asked for. Throws
/// InputError where no atmosphere answers.
SceneAir<Spectrum> spectralAir(const Environment& environment, const std::vector<Entity>& entities,
                               const std::vector<ObjectGeometry>& geometry,
                               const RenderSettings& settings, const LineOfSight& centre,
                               const SpectralRange& range);
/// In the wideband mode: one value per term.
SceneAir<std::vector<double>> widebandAir(const Environment& environment,
                                          const std::vector<Entity>& entities,
                                          const std::vector<ObjectGeometry>& geometry,
                                          const RenderSettings& settings, const LineOfSight& centre,
                                          const SensorCkData& ck);
/// Spectra sampled at ascending wavelengths.
SceneAir<std::vector<double>> sampledAir(const SceneAir<Spectrum>& air,
                                         const std::vector<double>& wavelengths_um);

} // namespace irsg
