#pragma once

#include <functional>
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

/// The air of one object, a value a node of the sampling.
struct ObjectAir {
    std::vector<double> transmittance, pathRadiance, solarIrradiance, upwardFlux, downwardFlux;
    double ambient_K = 288.15;
    /// Transmittance to the reference distance of a user-defined spectrum, by its name.
    std::map<std::string, std::vector<double>> toReference;
    std::set<std::string> insideReference; ///< names of spectra measured from farther away
};

/// All that a scene asks of its environment: once per object, and once for the background.
struct SceneAir {
    std::vector<ObjectAir> objects;
    std::vector<double> background;
    std::vector<std::string> answeredBy; ///< "transmittance: vacuum", each once
    std::vector<std::string> warnings;   ///< each once
};

/// Who answers a scene: of a question a value at every node of a sampling, all of `nodes`.
struct AirAnswers {
    std::size_t nodes = 0;
    std::function<Answer<std::vector<double>>(const AirQuestion&)> answer;
};

/// Asks for a scene. What the settings do not use is 0 and not asked for. Throws InputError where
/// no atmosphere answers.
SceneAir sceneAir(const Environment& environment, const std::vector<Entity>& entities,
                  const std::vector<ObjectGeometry>& geometry, const RenderSettings& settings,
                  const LineOfSight& centre, const AirAnswers& answers);
SceneAir sceneAir(const Environment& environment, const std::vector<Entity>& entities,
                  const std::vector<ObjectGeometry>& geometry, const RenderSettings& settings,
                  const LineOfSight& centre, const SpectralSampling& sampling);

/// The native spectra of an environment over a range, each computed once: first they say at which
/// nodes products of them are to be sampled, then they are sampled there.
class NativeAir {
  public:
    /// The environment must live as long.
    NativeAir(const Environment& environment, const SpectralRange& range)
        : environment_(environment), range_(range) {}

    /// All that has been asked for.
    std::vector<const Spectrum*> spectra() const;
    /// Answers without a value, whose spectra are kept.
    AirAnswers unsampled();
    /// Answers at nodes of the same range.
    AirAnswers at(const SpectralSampling& sampling);

  private:
    const Answer<Spectrum>& ask(const AirQuestion& question);

    const Environment& environment_;
    SpectralRange range_;
    std::map<AirKey, Answer<Spectrum>> answers_;
};

} // namespace irsg
