#include "irsg/radiance/SceneAtmosphere.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "irsg/atmosphere/AtmosphereSmart.h"
#include "irsg/atmosphere/NearestRun.h"
#include "irsg/atmosphere/Vacuum.h"
#include "irsg/core/AppendUnique.h"
#include "irsg/core/Errors.h"
#include "irsg/radiance/GasCrossing.h"

namespace irsg {

namespace {

constexpr double angleStep_rad = 1e-10;

double rounded(double value, double step) {
    return step * std::round(value / step);
}

/// The query behind the light of a term.
AtmosphericQuery queryOf(AtmosphereProperty light, const AtmosphericPath& path,
                         const SunPosition& sun) {
    AtmosphericQuery query;
    query.quantity = light;
    query.path = path;
    query.altitude_m = path.targetAltitude_m;
    query.sun = sun;
    return query;
}

bool isOn(const RadianceTerm& term, const RenderSettings& settings) {
    return term.light && term.isOn(settings);
}

/// The transmittance that is asked for because of a spectrum that was measured from so far.
AtmosphericQuery passedByMeasured(const AtmosphericPath& path, double reference_m,
                                  ReferenceTransmittance rule) {
    return AtmosphericQuery::transmittance(rule == ReferenceTransmittance::segment
                                               ? atRange(path, path.range_m - reference_m)
                                               : nearTarget(path, reference_m));
}

/// The radiance onto an object from a place of its grid; none without diffuse light.
std::vector<AtmosphericQuery> specularQueries(const ObjectGeometry& object,
                                              const RenderSettings& settings,
                                              const SunPosition& sun) {
    std::vector<AtmosphericQuery> queries;
    if (settings.ambientReflection == ReflectionMode::smart)
        for (const SpecularEnvironmentGrid::Direction& place : object.mirror.places())
            queries.push_back(AtmosphericQuery::backgroundRadiance(
                {object.path.targetAltitude_m, place.elevation_rad,
                 sun.azimuth_rad + place.fromSun_rad},
                sun));
    return queries;
}

/// Node by node; 0, for "nothing arrives", where both are 0.
SharedValues ratio(const std::vector<double>& whole, const std::vector<double>& part) {
    auto made = std::make_shared<std::vector<double>>(whole);
    for (std::size_t i = 0; i < made->size(); ++i)
        (*made)[i] = part[i] > 0.0 ? whole[i] / part[i] : 0.0;
    return made;
}

bool areEqual(const std::map<std::string, SharedValues>& a,
              const std::map<std::string, SharedValues>& b) {
    return std::ranges::equal(a, b, [](const auto& one, const auto& other) {
        return one.first == other.first && irsg::areEqual(one.second, other.second);
    });
}

} // namespace

bool ObjectAtmosphere::operator==(const ObjectAtmosphere& other) const {
    return ambient_K == other.ambient_K && insideReference == other.insideReference &&
           beforeGas == other.beforeGas && nodes == other.nodes &&
           areEqual(toReference, other.toReference) &&
           std::ranges::equal(
               specular, other.specular,
               [](const SharedValues& a, const SharedValues& b) { return irsg::areEqual(a, b); });
}

AtmosphericPath steadied(const AtmosphericPath& path) {
    const double step_m = std::max(1e-8, 1e-12 * path.range_m);
    return {rounded(path.sensorAltitude_m, step_m), rounded(path.targetAltitude_m, step_m),
            rounded(path.range_m, step_m), rounded(path.azimuth_rad, angleStep_rad)};
}

LineOfSight steadied(const LineOfSight& sight) {
    // No step of the rounding ends at the zenith.
    constexpr double zenith_rad = 0.5 * std::numbers::pi;
    return {rounded(sight.sensorAltitude_m, std::max(1e-8, 1e-12 * sight.sensorAltitude_m)),
            std::clamp(rounded(sight.elevation_rad, angleStep_rad), -zenith_rad, zenith_rad),
            rounded(sight.azimuth_rad, angleStep_rad)};
}

AtmosphericPath nearTarget(const AtmosphericPath& path, double range_m) {
    AtmosphericPath part = path;
    part.range_m = range_m;
    part.sensorAltitude_m =
        path.targetAltitude_m +
        (path.sensorAltitude_m - path.targetAltitude_m) * range_m / path.range_m;
    return part;
}

AtmosphericPath atRange(const AtmosphericPath& path, double range_m) {
    AtmosphericPath part = path;
    part.range_m = range_m;
    if (path.range_m > 0.0)
        part.targetAltitude_m =
            std::max(0.0, path.sensorAltitude_m + (path.targetAltitude_m - path.sensorAltitude_m) *
                                                      (range_m / path.range_m));
    return part;
}

std::vector<AtmosphericQueryKey> atmosphereQueries(const Environment& environment,
                                                   const RadianceTerms& terms,
                                                   const std::vector<ObjectGeometry>& geometry,
                                                   const RenderSettings& settings,
                                                   const LineOfSight& centre) {
    std::vector<AtmosphericQueryKey> keys;
    const auto add = [&](const AtmosphericQuery& query) {
        keys.push_back(
            query.key(std::ranges::any_of(environment.atmospheres(), [&](const auto& air) {
                return air->dependsOnAzimuth(query.quantity);
            })));
    };
    for (const ObjectGeometry& object : geometry) {
        add(AtmosphericQuery::transmittance(object.path));
        add(AtmosphericQuery::pathRadiance(object.path, environment.sun));
        for (const RadianceTerm& term : terms.terms)
            if (isOn(term, settings))
                add(queryOf(*term.light, object.path, environment.sun));
        for (const AtmosphericQuery& query : specularQueries(object, settings, environment.sun))
            add(query);
    }
    if (settings.background == BackgroundMode::environment)
        add(AtmosphericQuery::backgroundRadiance(centre, environment.sun));
    return keys;
}

Provided<double> ambientOf(const AtmosphericQueryCache& answers, const ObjectGeometry& geometry) {
    return answers.environment().ambientTemperature_K(geometry.altitude_m);
}

namespace {

/// The codes of its gases.
std::vector<IrCodes> gasesOf(const Entity& entity) {
    std::vector<IrCodes> gases;
    for (const auto& [codes, use] : entity.model->codes())
        if (const Material* material = materialEntry(entity, codes.material);
            material != nullptr && material->isGas())
            gases.push_back(codes);
    return gases;
}

/// Names gases whose zones go through each other.
void nameCrossing(const Entity& entity, const std::vector<IrCodes>& gases,
                  std::vector<std::string>& warnings) {
    const auto wordsOf = [](const IrCodes& gas) {
        return "material " + std::to_string(gas.material) + " and temperature " +
               std::to_string(gas.temperature);
    };
    for (const IrCodes& one : gases) {
        if (doGasZonesCross(entity.model->mesh(), one, one))
            appendUnique(warnings, {"meshes of the gas of " + wordsOf(one) + " of '" + entity.name +
                                    "' cross or hold each other: where two are, none counts"});
        for (const IrCodes& other : gases)
            if (one != other && doGasZonesCross(entity.model->mesh(), one, other))
                appendUnique(warnings, {"the gas of " + wordsOf(one) + " of '" + entity.name +
                                        "' crosses that of " + wordsOf(other) +
                                        ": where both are, that of the smaller volume counts"});
    }
}

/// The air whose lines coincide with those of the entity's gases.
void takeAirBeforeGas(const Environment& environment, const SpectralRange& range,
                      const AtmosphericPath& path, ObjectAtmosphere& air,
                      std::vector<std::string>& warnings) {
    const Atmosphere* const atmosphere = environment.find(range, AtmosphereProperty::transmittance);
    if (const auto state = airOfPath(atmosphere, path))
        air.beforeGas = {*state, path.range_m};
    else if (atmosphere && dynamic_cast<const Vacuum*>(atmosphere) == nullptr)
        appendUnique(warnings,
                     {"gas is seen through means of the atmosphere: " + atmosphere->name() +
                      " does not tell which gases it holds, so the coincidence of lines "
                      "is left out"});
}

} // namespace

SceneAtmosphere sceneAtmosphere(AtmosphericQueryCache& answers, const RadianceTerms& terms,
                                const std::vector<Entity>& entities,
                                const std::vector<ObjectGeometry>& geometry,
                                const RenderSettings& settings, const LineOfSight& centre,
                                const std::shared_ptr<const SpectralSampling>& sampling,
                                const std::vector<std::vector<bool>>& taken) {
    const SunPosition& sun = answers.environment().sun;
    SceneAtmosphere scene;
    const auto note = [&](const char* quantity, const std::string& who) {
        std::string line = quantity;
        line += ": ";
        line += who;
        addProvider(scene.providedBy, std::move(line));
    };
    const auto take = [&](const AtmosphericQuery& query, const char* quantity) {
        const auto& answer = answers.at(query, sampling);
        note(quantity, answer.providedBy);
        return answer.value;
    };
    std::set<std::string> said;
    for (std::size_t e = 0; e < entities.size(); ++e) {
        const AtmosphericPath& path = geometry[e].path;
        ObjectAtmosphere air;
        std::vector<AtmosphericPath> paths{path};
        if (geometry[e].slices_m.size() > 1) {
            paths.clear();
            for (const double range_m : geometry[e].slices_m)
                paths.push_back(atRange(path, range_m));
        }
        for (std::size_t i = 0; i < paths.size(); ++i) {
            const AtmosphericPath& toNode = paths[i];
            AtmosphereSamples& node = air.nodes.emplace_back();
            if (e < taken.size() && !taken[e].empty() && !taken[e][i]) {
                node.light.resize(terms.terms.size());
                continue;
            }
            node.transmittance = take(AtmosphericQuery::transmittance(toNode), "transmittance");
            for (const RadianceTerm& term : terms.terms) {
                SharedValues& light = node.light.emplace_back();
                if (!isOn(term, settings))
                    continue;
                // Light onto an object is that at its reference point; light of a path ends at the
                // node.
                const bool ofPath = geometryOf(*term.light) == QueryGeometry::path;
                light = take(queryOf(*term.light, ofPath ? toNode : path, sun), name(*term.light));
            }
        }
        for (const AtmosphericQuery& query : specularQueries(geometry[e], settings, sun))
            air.specular.push_back(take(query, "reflected sky and ground"));
        const Provided<double> ambient = ambientOf(answers, geometry[e]);
        note("ambient temperature", ambient.providedBy);
        air.ambient_K = ambient.value;

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
            SharedValues divisor =
                answers
                    .at(passedByMeasured(path, inside_m, settings.referenceTransmittance), sampling)
                    .value;
            if (settings.referenceTransmittance == ReferenceTransmittance::segment)
                divisor = ratio(*answers.at(AtmosphericQuery::transmittance(path), sampling).value,
                                *divisor);
            air.toReference.emplace(name, std::move(divisor));
        }
        if (const std::vector<IrCodes> gases = gasesOf(entities[e]); !gases.empty()) {
            takeAirBeforeGas(answers.environment(), sampling->range(), path, air, scene.warnings);
            nameCrossing(entities[e], gases, scene.warnings);
        }
        scene.objects.push_back(std::move(air));
    }
    if (settings.background == BackgroundMode::environment)
        scene.background = take(AtmosphericQuery::backgroundRadiance(centre, sun), "background");
    return scene;
}

std::vector<const Spectrum*>
atmosphereSpectra(AtmosphericQueryCache& answers, const RadianceTerms& terms,
                  const std::vector<Entity>& entities, const std::vector<ObjectGeometry>& geometry,
                  const RenderSettings& settings, const LineOfSight& centre,
                  const SpectralRange& range) {
    const SunPosition& sun = answers.environment().sun;
    std::vector<const Spectrum*> spectra;
    const auto add = [&](const AtmosphericQuery& query) {
        spectra.push_back(&answers.spectrum(query, range).value);
    };
    if (settings.background == BackgroundMode::environment)
        add(AtmosphericQuery::backgroundRadiance(centre, sun));
    for (std::size_t e = 0; e < entities.size(); ++e) {
        const AtmosphericPath& path = geometry[e].path;
        add(AtmosphericQuery::transmittance(path));
        for (const RadianceTerm& term : terms.terms)
            if (isOn(term, settings))
                add(queryOf(*term.light, path, sun));
        for (const auto& [name, spectrum] : entities[e].database->spectra)
            if (spectrum.referenceDistance_m > 0.0 && path.range_m > spectrum.referenceDistance_m)
                add(passedByMeasured(path, spectrum.referenceDistance_m,
                                     settings.referenceTransmittance));
    }
    return spectra;
}

} // namespace irsg
