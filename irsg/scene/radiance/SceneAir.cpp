#include "irsg/scene/radiance/SceneAir.h"

#include <algorithm>
#include <utility>

namespace irsg {

namespace {

/// The part of a path next to its target.
AirPath nearTarget(const AirPath& path, double range_m) {
    AirPath part = path;
    part.range_m = range_m;
    part.sensorAltitude_m =
        path.targetAltitude_m +
        (path.sensorAltitude_m - path.targetAltitude_m) * range_m / path.range_m;
    return part;
}

/// One scene on its way to its air.
class Asking {
  public:
    Asking(const Environment& environment, const RenderSettings& settings,
           const AirAnswers& answers)
        : environment_(environment),
          settings_(settings),
          answers_(answers),
          zero_(answers.nodes, 0.0) {
        scene_.background = zero_;
    }

    void object(const Entity& entity, const AirPath& path) {
        const SunPosition& sun = environment_.sun;
        const double altitude_m = path.targetAltitude_m;
        ObjectAir air;
        air.transmittance = take("transmittance", AirQuestion::transmittance(path));
        air.pathRadiance = take("path radiance", AirQuestion::pathRadiance(path, sun));
        air.solarIrradiance =
            settings_.sun == ReflectionMode::off
                ? zero_
                : take("solar irradiance", AirQuestion::solarIrradiance(altitude_m, sun));
        if (settings_.fluxes == ReflectionMode::off) {
            air.upwardFlux = air.downwardFlux = zero_;
        } else {
            air.upwardFlux = take("upward flux", AirQuestion::upwardFlux(altitude_m, sun));
            air.downwardFlux = take("downward flux", AirQuestion::downwardFlux(altitude_m, sun));
        }
        air.ambient_K = noted("ambient temperature", environment_.ambientTemperature_K(altitude_m));
        for (const auto& [name, spectrum] : entity.database->spectra)
            toReference(name, spectrum.referenceDistance_m, path, air);
        scene_.objects.push_back(std::move(air));
    }

    void background(const LineOfSight& centre) {
        if (settings_.background == BackgroundMode::environment)
            scene_.background =
                take("background", AirQuestion::backgroundRadiance(centre, environment_.sun));
    }

    SceneAir done() { return std::move(scene_); }

  private:
    /// What a measured spectrum already holds of the air is taken out again. The part of the path
    /// next to the target is the one that was inside the measurement.
    void toReference(const std::string& name, double inside_m, const AirPath& path,
                     ObjectAir& air) {
        if (inside_m <= 0.0)
            return;
        if (path.range_m <= inside_m) {
            if (said_.insert(name).second)
                scene_.warnings.push_back("spectrum '" + name + "' was measured at " +
                                          std::to_string(inside_m) +
                                          " m and is seen from nearer: no air is added or removed");
            air.insideReference.insert(name);
            return;
        }
        air.toReference.emplace(
            name, answers_.answer(AirQuestion::transmittance(nearTarget(path, inside_m))).value);
    }

    std::vector<double> take(const char* quantity, const AirQuestion& question) {
        return noted(quantity, answers_.answer(question));
    }

    template <typename Value>
    Value noted(const char* quantity, Answer<Value> answer) {
        std::string line = quantity;
        line += ": ";
        line += answer.answeredBy;
        if (std::ranges::find(scene_.answeredBy, line) == scene_.answeredBy.end())
            scene_.answeredBy.push_back(std::move(line));
        return std::move(answer.value);
    }

    const Environment& environment_;
    const RenderSettings& settings_;
    const AirAnswers& answers_;
    std::vector<double> zero_;
    std::set<std::string> said_;
    SceneAir scene_;
};

} // namespace

SceneAir sceneAir(const Environment& environment, const std::vector<Entity>& entities,
                  const std::vector<ObjectGeometry>& geometry, const RenderSettings& settings,
                  const LineOfSight& centre, const AirAnswers& answers) {
    Asking asking(environment, settings, answers);
    for (std::size_t e = 0; e < entities.size(); ++e)
        asking.object(entities[e], geometry[e].path);
    asking.background(centre);
    return asking.done();
}

SceneAir sceneAir(const Environment& environment, const std::vector<Entity>& entities,
                  const std::vector<ObjectGeometry>& geometry, const RenderSettings& settings,
                  const LineOfSight& centre, const SpectralSampling& sampling) {
    const auto answer = [&](const AirQuestion& question) {
        return environment.answer(question, sampling);
    };
    return sceneAir(environment, entities, geometry, settings, centre,
                    AirAnswers{sampling.size(), answer});
}

std::vector<const Spectrum*> NativeAir::spectra() const {
    std::vector<const Spectrum*> all;
    for (const auto& [key, answer] : answers_)
        all.push_back(&answer.value);
    return all;
}

AirAnswers NativeAir::unsampled() {
    return {0, [this](const AirQuestion& question) {
                return Answer<std::vector<double>>{{}, ask(question).answeredBy};
            }};
}

AirAnswers NativeAir::at(const SpectralSampling& sampling) {
    return {sampling.size(), [this, &sampling](const AirQuestion& question) {
                const Answer<Spectrum>& own = ask(question);
                return Answer<std::vector<double>>{sampling.sampled(own.value), own.answeredBy};
            }};
}

const Answer<Spectrum>& NativeAir::ask(const AirQuestion& question) {
    const AirKey key = environment_.keyOf(question, range_);
    const auto found = answers_.find(key);
    return found != answers_.end()
               ? found->second
               : answers_.emplace(key, environment_.spectrum(question, range_)).first->second;
}

} // namespace irsg
