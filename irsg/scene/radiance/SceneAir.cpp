#include "irsg/scene/radiance/SceneAir.h"

#include <algorithm>

#include "irsg/atmosphere/ck/SensorCkData.h"

namespace irsg {

namespace {

/// The questions to an environment, in the two modes under the same names.
struct SpectralQuestions {
    using Value = Spectrum;
    const Environment& environment;
    SpectralRange range;

    Value zero() const { return {}; }
    auto transmittance(const AirPath& path) const { return environment.transmittance(path, range); }
    auto pathRadiance(const AirPath& path) const { return environment.pathRadiance(path, range); }
    auto background(const LineOfSight& sight) const {
        return environment.backgroundRadiance(sight, range);
    }
    auto solarIrradiance(double altitude_m) const {
        return environment.solarIrradiance(altitude_m, range);
    }
    auto upwardFlux(double altitude_m) const { return environment.upwardFlux(altitude_m, range); }
    auto downwardFlux(double altitude_m) const {
        return environment.downwardFlux(altitude_m, range);
    }
};

struct WidebandQuestions {
    using Value = std::vector<double>;
    const Environment& environment;
    const SensorCkData& ck;

    Value zero() const { return Value(ck.size(), 0.0); }
    auto transmittance(const AirPath& path) const { return environment.ckTransmittance(path, ck); }
    auto pathRadiance(const AirPath& path) const { return environment.ckPathRadiance(path, ck); }
    auto background(const LineOfSight& sight) const {
        return environment.ckBackgroundRadiance(sight, ck);
    }
    auto solarIrradiance(double altitude_m) const {
        return environment.ckSolarIrradiance(altitude_m, ck);
    }
    auto upwardFlux(double altitude_m) const { return environment.ckUpwardFlux(altitude_m, ck); }
    auto downwardFlux(double altitude_m) const {
        return environment.ckDownwardFlux(altitude_m, ck);
    }
};

/// The part of a path next to its target.
AirPath nearTarget(const AirPath& path, double range_m) {
    AirPath part = path;
    part.range_m = range_m;
    part.sensorAltitude_m =
        path.targetAltitude_m +
        (path.sensorAltitude_m - path.targetAltitude_m) * range_m / path.range_m;
    return part;
}

template <typename Questions>
auto ask(const Questions& questions, const std::vector<Entity>& entities,
         const std::vector<ObjectGeometry>& geometry, const RenderSettings& settings,
         const LineOfSight& centre) {
    using Value = typename Questions::Value;
    SceneAir<Value> scene{{}, questions.zero(), {}, {}};
    auto take = [&](const char* quantity, auto answer) {
        std::string line = quantity;
        line += ": ";
        line += answer.answeredBy;
        if (std::ranges::find(scene.answeredBy, line) == scene.answeredBy.end())
            scene.answeredBy.push_back(line);
        return std::move(answer.value);
    };
    std::set<std::string> said;
    for (std::size_t e = 0; e < entities.size(); ++e) {
        const AirPath& path = geometry[e].path;
        ObjectAir<Value> air;
        air.transmittance = take("transmittance", questions.transmittance(path));
        air.pathRadiance = take("path radiance", questions.pathRadiance(path));
        air.solarIrradiance =
            settings.sun == ReflectionMode::off
                ? questions.zero()
                : take("solar irradiance", questions.solarIrradiance(path.targetAltitude_m));
        if (settings.fluxes == ReflectionMode::off) {
            air.upwardFlux = air.downwardFlux = questions.zero();
        } else {
            air.upwardFlux = take("upward flux", questions.upwardFlux(path.targetAltitude_m));
            air.downwardFlux = take("downward flux", questions.downwardFlux(path.targetAltitude_m));
        }
        air.ambient_K = take("ambient temperature",
                             questions.environment.ambientTemperature_K(path.targetAltitude_m));

        // What a measured spectrum already holds of the air is taken out again. The part of the
        // path next to the target is the one that was inside the measurement.
        for (const auto& [name, spectrum] : entities[e].database->spectra) {
            const double inside_m = spectrum.referenceDistance_m;
            if (inside_m <= 0.0)
                continue;
            if (path.range_m <= inside_m) {
                if (said.insert(name).second)
                    scene.warnings.push_back(
                        "spectrum '" + name + "' was measured at " + std::to_string(inside_m) +
                        " m and is seen from nearer: no air is added or removed");
                air.insideReference.insert(name);
                continue;
            }
            air.toReference.emplace(name,
                                    questions.transmittance(nearTarget(path, inside_m)).value);
        }
        scene.objects.push_back(std::move(air));
    }
    if (settings.background == BackgroundMode::environment)
        scene.background = take("background", questions.background(centre));
    return scene;
}

} // namespace

SceneAir<Spectrum> spectralAir(const Environment& environment, const std::vector<Entity>& entities,
                               const std::vector<ObjectGeometry>& geometry,
                               const RenderSettings& settings, const LineOfSight& centre,
                               const SpectralRange& range) {
    return ask(SpectralQuestions{environment, range}, entities, geometry, settings, centre);
}

SceneAir<std::vector<double>> widebandAir(const Environment& environment,
                                          const std::vector<Entity>& entities,
                                          const std::vector<ObjectGeometry>& geometry,
                                          const RenderSettings& settings, const LineOfSight& centre,
                                          const SensorCkData& ck) {
    return ask(WidebandQuestions{environment, ck}, entities, geometry, settings, centre);
}

SceneAir<std::vector<double>> sampledAir(const SceneAir<Spectrum>& air,
                                         const std::vector<double>& wavelengths_um) {
    auto sample = [&](const Spectrum& spectrum) { return spectrum.sample(wavelengths_um); };
    SceneAir<std::vector<double>> sampled{{}, sample(air.background), air.answeredBy, air.warnings};
    for (const ObjectAir<Spectrum>& object : air.objects) {
        ObjectAir<std::vector<double>> own{sample(object.transmittance),
                                           sample(object.pathRadiance),
                                           sample(object.solarIrradiance),
                                           sample(object.upwardFlux),
                                           sample(object.downwardFlux),
                                           object.ambient_K,
                                           {},
                                           object.insideReference};
        for (const auto& [name, transmittance] : object.toReference)
            own.toReference.emplace(name, sample(transmittance));
        sampled.objects.push_back(std::move(own));
    }
    return sampled;
}

} // namespace irsg
