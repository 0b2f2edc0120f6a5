#include "irsg/atmosphere/Environment.h"

#include <algorithm>
#include <utility>

#include "irsg/atmosphere/NearestRun.h"
#include "irsg/atmosphere/Vacuum.h"
#include "irsg/atmosphere/ck/SensorCkData.h"
#include "irsg/core/Errors.h"
#include "irsg/radiometry/Band.h"

namespace irsg {

namespace {

constexpr const char* byDefault = "default";

std::string textOf(const SpectralRange& range) {
    // Eight digits: a range may be widened by parts in 1e9.
    return general(range.min_um, 8) + "-" + general(range.max_um, 8) + " um";
}

std::string refusalOf(const Atmosphere& atmosphere, AtmosphereProperty property) {
    return atmosphere.supports(property)
               ? atmosphere.name() + " (holds only " + textOf(atmosphere.base()) + ")"
               : atmosphere.name() + " (" + atmosphere.refusal(property) + ")";
}

/// Direct light of a sun below the horizon, as an atmosphere has it.
bool isDark(const AtmosphericQuery& query, const Atmosphere& air) {
    return query.quantity == AtmosphereProperty::solarIrradiance &&
           air.sunView(query.altitude_m, query.sun).part <= 0.0;
}

/// Its name, of a family of runs with how far the nearest is.
std::string providersFor(const Atmosphere& air, const AtmosphericQuery& query) {
    const auto* family = dynamic_cast<const RunFamily*>(&air);
    return air.name() + (family ? family->nearestRun(query) : "");
}

} // namespace

Environment Environment::vacuum() {
    Environment environment;
    environment.add(std::make_shared<Vacuum>());
    return environment;
}

void Environment::add(std::shared_ptr<const Atmosphere> atmosphere) {
    if (!atmosphere)
        throw LogicError("no atmosphere was added to an environment");
    atmospheres_.push_back(std::move(atmosphere));
}

Environment Environment::with(
    const std::function<std::shared_ptr<const Atmosphere>(const Atmosphere&)>& other) const {
    Environment made = *this;
    for (auto& atmosphere : made.atmospheres_)
        if (auto changed = other(*atmosphere))
            atmosphere = std::move(changed);
    return made;
}

const Atmosphere* Environment::find(const SpectralRange& range, AtmosphereProperty property) const {
    for (const auto& atmosphere : atmospheres_)
        if (atmosphere->accept(range, property))
            return atmosphere.get();
    return nullptr;
}

const Atmosphere& Environment::require(const SpectralRange& range,
                                       AtmosphereProperty property) const {
    if (const Atmosphere* atmosphere = find(range, property))
        return *atmosphere;
    std::string refusals;
    for (const auto& atmosphere : atmospheres_)
        refusals += (refusals.empty() ? "" : ", ") + refusalOf(*atmosphere, property);
    throw InputError({"environment", std::string(name(property)) + " over " + textOf(range),
                      refusals.empty() ? "no atmosphere" : refusals,
                      "an atmosphere that supports this quantity and holds the whole range"});
}

double Environment::horizonElevation_rad(double altitude_m, const SpectralRange& range) const {
    if (const Atmosphere* air = find(range, AtmosphereProperty::backgroundRadiance))
        return air->horizonElevation_rad(altitude_m);
    return Vacuum().horizonElevation_rad(altitude_m);
}

SunView Environment::sunView(double altitude_m, const SpectralRange& range) const {
    if (const Atmosphere* air = find(range, AtmosphereProperty::solarIrradiance))
        return air->sunView(altitude_m, sun);
    return Vacuum().sunView(altitude_m, sun);
}

TargetView Environment::targetView(const AtmosphericPath& path, const SpectralRange& range) const {
    const Atmosphere* air = find(range, AtmosphereProperty::transmittance);
    return air ? air->targetView(path) : flatTargetView(path);
}

bool Environment::isByDefault(const SpectralRange& range, AtmosphereProperty property) const {
    return property == AtmosphereProperty::backgroundRadiance && defaultBackground &&
           !find(range, property);
}

Provided<std::vector<double>> Environment::provide(const AtmosphericQuery& query,
                                                   const SpectralSampling& sampling) const {
    const SpectralRange& range = sampling.range();
    const bool isWideband = SensorCkData::of(sampling) != nullptr;
    if (!isWideband && isByDefault(range, query.quantity))
        return {sampling.sampled(*defaultBackground), byDefault};
    const Atmosphere& air =
        isWideband ? requireWideband(range, query.quantity) : require(range, query.quantity);
    if (isDark(query, air))
        return {std::vector<double>(sampling.size(), 0.0), air.name()};
    return {air.provide(query, sampling), providersFor(air, query)};
}

void Environment::checkProvided(AtmosphereProperty quantity, const SpectralRange& range,
                                bool isWideband) const {
    if (isWideband)
        requireWideband(range, quantity);
    else if (!isByDefault(range, quantity))
        require(range, quantity);
}

Provided<Spectrum> Environment::spectrum(const AtmosphericQuery& query,
                                         const SpectralRange& range) const {
    if (isByDefault(range, query.quantity))
        return {*defaultBackground, byDefault};
    const Atmosphere& air = require(range, query.quantity);
    return {isDark(query, air) ? Spectrum::constant(0.0) : air.spectrum(query, range),
            providersFor(air, query)};
}

AtmosphericQueryKey Environment::keyOf(const AtmosphericQuery& query,
                                       const SpectralRange& range) const {
    const Atmosphere* air = find(range, query.quantity);
    return query.key(air && air->dependsOnAzimuth(query.quantity));
}

AtmosphericQueryKey Environment::keyOf(const AtmosphericQuery& query,
                                       const SpectralSampling& sampling) const {
    if (!SensorCkData::of(sampling))
        return keyOf(query, sampling.range());
    const Atmosphere* air = findWideband(sampling.range());
    return query.key(air && air->dependsOnAzimuth(query.quantity));
}

std::shared_ptr<const SpectralSampling> Environment::nodesOf(const Band& band) const {
    const Atmosphere* air = find(band.range(), AtmosphereProperty::transmittance);
    return air ? air->nodesOf({band}) : nullptr;
}

std::shared_ptr<const SpectralSampling> Environment::nodesOf(const std::vector<Band>& bands) const {
    const auto isMissing = [&](const Band& band) {
        return find(band.range(), AtmosphereProperty::transmittance) == nullptr;
    };
    if (atmospheres().size() != 1 || std::ranges::any_of(bands, isMissing))
        return nullptr;
    return atmospheres().front()->nodesOf(bands);
}

std::shared_ptr<const SpectralSampling>
Environment::nodesAt(const std::vector<double>& wavelengths_um) const {
    const SpectralPoints points(wavelengths_um);
    const Atmosphere* air = find(points.range(), AtmosphereProperty::transmittance);
    return air ? air->nodesAt(wavelengths_um) : nullptr;
}

Provided<double> Environment::ambientTemperature_K(double altitude_m) const {
    // A temperature has no range: the first that knows one answers.
    std::string refusals;
    for (const auto& atmosphere : atmospheres_) {
        if (atmosphere->supports(AtmosphereProperty::ambientTemperature))
            return {atmosphere->ambientTemperature_K(altitude_m), atmosphere->name()};
        refusals += (refusals.empty() ? "" : ", ") +
                    refusalOf(*atmosphere, AtmosphereProperty::ambientTemperature);
    }
    if (defaultAmbient_K)
        return {*defaultAmbient_K, byDefault};
    throw InputError({"environment", name(AtmosphereProperty::ambientTemperature),
                      refusals.empty() ? "no atmosphere" : refusals,
                      "an atmosphere that has an ambient temperature"});
}

const Atmosphere* Environment::findWideband(const SpectralRange& range) const {
    // One air answers all: the first of those that know the most.
    const auto known = [](const Atmosphere& air) {
        return std::ranges::count_if(allAtmosphereProperties, [&](AtmosphereProperty property) {
            return property != AtmosphereProperty::ambientTemperature && air.supports(property);
        });
    };
    const Atmosphere* best = nullptr;
    for (const auto& atmosphere : atmospheres_)
        if (atmosphere->isWidebandModeAvailable() && atmosphere->covers(range) &&
            (best == nullptr || known(*atmosphere) > known(*best)))
            best = atmosphere.get();
    return best;
}

const Atmosphere& Environment::requireWideband(const SpectralRange& range) const {
    if (const Atmosphere* atmosphere = findWideband(range))
        return *atmosphere;
    std::string refusals;
    for (const auto& atmosphere : atmospheres_) {
        refusals += (refusals.empty() ? "" : ", ") + atmosphere->name() +
                    (atmosphere->isWidebandModeAvailable()
                         ? " (holds only " + textOf(atmosphere->base()) + ")"
                         : " (" + atmosphere->widebandRefusal() + ")");
    }
    throw InputError({"environment", "wideband-ck over " + textOf(range),
                      refusals.empty() ? "no atmosphere" : refusals,
                      "an atmosphere with a wideband mode that holds the whole range"});
}

const Atmosphere& Environment::requireWideband(const SpectralRange& range,
                                               AtmosphereProperty property) const {
    const Atmosphere& atmosphere = requireWideband(range);
    if (!atmosphere.supports(property)) {
        throw InputError(
            {"environment", std::string("wideband ") + name(property) + " over " + textOf(range),
             refusalOf(atmosphere, property), "a wideband atmosphere that supports this quantity"});
    }
    return atmosphere;
}

Provided<std::shared_ptr<const SensorCkData>>
Environment::prepareCk(const CkRequest& request) const {
    const Atmosphere& air = requireWideband(request.band.range());
    return {air.prepareCk(request), air.name()};
}

} // namespace irsg
