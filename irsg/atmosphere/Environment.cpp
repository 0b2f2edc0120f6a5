#include "irsg/atmosphere/Environment.h"

#include <utility>

#include "irsg/atmosphere/Vacuum.h"
#include "irsg/atmosphere/ck/SensorCkData.h"
#include "irsg/radiometry/Errors.h"

namespace irsg {

namespace {

constexpr const char* byDefault = "default";

std::string textOf(const SpectralRange& range) {
    return numberText(range.min_um) + "-" + numberText(range.max_um) + " um";
}

std::string refusalOf(const Atmosphere& atmosphere, AtmosphereProperty property) {
    return atmosphere.supports(property)
               ? atmosphere.name() + " (holds only " + textOf(atmosphere.base()) + ")"
               : atmosphere.name() + " (" + atmosphere.refusal(property) + ")";
}

} // namespace

Environment Environment::vacuum() {
    Environment environment;
    environment.add(std::make_shared<Vacuum>());
    return environment;
}

void Environment::add(std::shared_ptr<const Atmosphere> atmosphere) {
    if (!atmosphere) {
        throw LogicError("no atmosphere was added to an environment");
    }
    atmospheres_.push_back(std::move(atmosphere));
}

const Atmosphere* Environment::find(const SpectralRange& range, AtmosphereProperty property) const {
    for (const auto& atmosphere : atmospheres_) {
        if (atmosphere->accept(range, property)) {
            return atmosphere.get();
        }
    }
    return nullptr;
}

const Atmosphere& Environment::require(const SpectralRange& range,
                                       AtmosphereProperty property) const {
    if (const Atmosphere* atmosphere = find(range, property)) {
        return *atmosphere;
    }
    std::string refusals;
    for (const auto& atmosphere : atmospheres_) {
        refusals += (refusals.empty() ? "" : ", ") + refusalOf(*atmosphere, property);
    }
    throw InputError({"environment", std::string(name(property)) + " over " + textOf(range),
                      refusals.empty() ? "no atmosphere" : refusals,
                      "an atmosphere that supports this quantity and holds the whole range"});
}

double Environment::horizonElevation_rad(double altitude_m, const SpectralRange& range) const {
    if (const Atmosphere* air = find(range, AtmosphereProperty::backgroundRadiance)) {
        return air->horizonElevation_rad(altitude_m);
    }
    return Vacuum().horizonElevation_rad(altitude_m);
}

Answer<Spectrum> Environment::transmittance(const AirPath& path, const SpectralRange& range) const {
    const Atmosphere& air = require(range, AtmosphereProperty::transmittance);
    return {air.transmittance(path, range), air.name()};
}

Answer<Spectrum> Environment::pathRadiance(const AirPath& path, const SpectralRange& range) const {
    const Atmosphere& air = require(range, AtmosphereProperty::pathRadiance);
    return {air.pathRadiance(path, sun, range), air.name()};
}

Answer<Spectrum> Environment::backgroundRadiance(const LineOfSight& sight,
                                                 const SpectralRange& range) const {
    if (defaultBackground && !find(range, AtmosphereProperty::backgroundRadiance)) {
        return {*defaultBackground, byDefault};
    }
    const Atmosphere& air = require(range, AtmosphereProperty::backgroundRadiance);
    return {air.backgroundRadiance(sight, sun, range), air.name()};
}

Answer<Spectrum> Environment::solarIrradiance(double altitude_m, const SpectralRange& range) const {
    const Atmosphere& air = require(range, AtmosphereProperty::solarIrradiance);
    return {sun.isUp() ? air.solarIrradiance(altitude_m, sun, range) : Spectrum::constant(0.0),
            air.name()};
}

Answer<Spectrum> Environment::upwardFlux(double altitude_m, const SpectralRange& range) const {
    const Atmosphere& air = require(range, AtmosphereProperty::upwardFlux);
    return {air.upwardFlux(altitude_m, sun, range), air.name()};
}

Answer<Spectrum> Environment::downwardFlux(double altitude_m, const SpectralRange& range) const {
    const Atmosphere& air = require(range, AtmosphereProperty::downwardFlux);
    return {air.downwardFlux(altitude_m, sun, range), air.name()};
}

Answer<double> Environment::ambientTemperature_K(double altitude_m) const {
    // A temperature has no range: the first that knows one answers.
    std::string refusals;
    for (const auto& atmosphere : atmospheres_) {
        if (atmosphere->supports(AtmosphereProperty::ambientTemperature)) {
            return {atmosphere->ambientTemperature_K(altitude_m), atmosphere->name()};
        }
        refusals += (refusals.empty() ? "" : ", ") +
                    refusalOf(*atmosphere, AtmosphereProperty::ambientTemperature);
    }
    if (defaultAmbient_K) {
        return {*defaultAmbient_K, byDefault};
    }
    throw InputError({"environment", name(AtmosphereProperty::ambientTemperature),
                      refusals.empty() ? "no atmosphere" : refusals,
                      "an atmosphere that has an ambient temperature"});
}

Answer<Spectrum> Environment::scatteringOpticalDepth(const AirPath& path,
                                                     const SpectralRange& range) const {
    const Atmosphere& air = require(range, AtmosphereProperty::scatteringOpticalDepth);
    return {air.scatteringOpticalDepth(path, range), air.name()};
}

const Atmosphere* Environment::findWideband(const SpectralRange& range) const {
    for (const auto& atmosphere : atmospheres_) {
        if (atmosphere->isWidebandModeAvailable() && atmosphere->base().contains(range)) {
            return atmosphere.get();
        }
    }
    return nullptr;
}

const Atmosphere& Environment::requireWideband(const SpectralRange& range) const {
    if (const Atmosphere* atmosphere = findWideband(range)) {
        return *atmosphere;
    }
    std::string refusals;
    for (const auto& atmosphere : atmospheres_) {
        refusals += (refusals.empty() ? "" : ", ") + atmosphere->name() +
                    (atmosphere->isWidebandModeAvailable()
                         ? " (holds only " + textOf(atmosphere->base()) + ")"
                         : " (has no wideband mode)");
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

Answer<std::shared_ptr<const SensorCkData>> Environment::prepareCk(const CkRequest& request) const {
    const Atmosphere& air = requireWideband(request.band.range());
    return {air.prepareCk(request), air.name()};
}

Answer<std::vector<double>> Environment::ckTransmittance(const AirPath& path,
                                                         const SensorCkData& ck) const {
    const Atmosphere& air = requireWideband(ck.band().range(), AtmosphereProperty::transmittance);
    return {air.ckTransmittance(path, ck), air.name()};
}

Answer<std::vector<double>> Environment::ckPathRadiance(const AirPath& path,
                                                        const SensorCkData& ck) const {
    const Atmosphere& air = requireWideband(ck.band().range(), AtmosphereProperty::pathRadiance);
    return {air.ckPathRadiance(path, sun, ck), air.name()};
}

Answer<std::vector<double>> Environment::ckBackgroundRadiance(const LineOfSight& sight,
                                                              const SensorCkData& ck) const {
    const Atmosphere& air =
        requireWideband(ck.band().range(), AtmosphereProperty::backgroundRadiance);
    return {air.ckBackgroundRadiance(sight, sun, ck), air.name()};
}

Answer<std::vector<double>> Environment::ckSolarIrradiance(double altitude_m,
                                                           const SensorCkData& ck) const {
    const Atmosphere& air = requireWideband(ck.band().range(), AtmosphereProperty::solarIrradiance);
    return {sun.isUp() ? air.ckSolarIrradiance(altitude_m, sun, ck)
                       : std::vector<double>(ck.size(), 0.0),
            air.name()};
}

Answer<std::vector<double>> Environment::ckUpwardFlux(double altitude_m,
                                                      const SensorCkData& ck) const {
    const Atmosphere& air = requireWideband(ck.band().range(), AtmosphereProperty::upwardFlux);
    return {air.ckUpwardFlux(altitude_m, sun, ck), air.name()};
}

Answer<std::vector<double>> Environment::ckDownwardFlux(double altitude_m,
                                                        const SensorCkData& ck) const {
    const Atmosphere& air = requireWideband(ck.band().range(), AtmosphereProperty::downwardFlux);
    return {air.ckDownwardFlux(altitude_m, sun, ck), air.name()};
}

} // namespace irsg
