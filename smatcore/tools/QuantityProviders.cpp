#include "smatcore/tools/QuantityProviders.h"

#include <fmt/format.h>

namespace smat {

namespace {

using irsg::Atmosphere;
using irsg::AtmosphereProperty;

std::string outside(const Atmosphere& atmosphere) {
    const irsg::SpectralRange base = atmosphere.base();
    return fmt::format("{} holds only {:.6g} to {:.6g} um", atmosphere.name(), base.min_um,
                       base.max_um);
}

/// Goes through the atmospheres until one has `mayProvide` and holds the band.
template <typename MayProvide, typename WhyNot>
QuantityProvider sourceOf(std::string quantity, const irsg::Environment& environment,
                          const irsg::SpectralRange* band, const MayProvide& mayProvide,
                          const WhyNot& whyNot) {
    QuantityProvider source{.quantity = std::move(quantity), .providedBy = {}, .refusals = {}};
    for (const auto& atmosphere : environment.atmospheres()) {
        if (!mayProvide(*atmosphere)) {
            source.refusals.push_back(atmosphere->name() + " " + whyNot(*atmosphere));
        } else if (band != nullptr && !atmosphere->covers(*band)) {
            source.refusals.push_back(outside(*atmosphere));
        } else {
            source.providedBy = atmosphere->name();
            break;
        }
    }
    return source;
}

QuantityProvider sourceOf(AtmosphereProperty property, const irsg::Environment& environment,
                          const irsg::SpectralRange& band) {
    const bool isTemperature = property == AtmosphereProperty::ambientTemperature;
    QuantityProvider source = sourceOf(
        irsg::name(property), environment, isTemperature ? nullptr : &band,
        [&](const Atmosphere& one) { return one.supports(property); },
        [&](const Atmosphere& one) { return one.refusal(property); });
    if (source.providedBy.empty() && isTemperature && environment.defaultAmbient_K)
        source.providedBy = fmt::format("default {:.6g} K", *environment.defaultAmbient_K);
    if (source.providedBy.empty() && property == AtmosphereProperty::backgroundRadiance &&
        environment.defaultBackground)
        source.providedBy = "default background";
    return source;
}

/// One air has the quadrature points of a band.
QuantityProvider widebandSourceOf(const irsg::Environment& environment,
                                  const irsg::SpectralRange& band) {
    QuantityProvider source{.quantity = "wideband-ck", .providedBy = {}, .refusals = {}};
    const Atmosphere* answering = environment.findWideband(band);
    for (const auto& atmosphere : environment.atmospheres()) {
        if (atmosphere.get() == answering)
            break;
        if (!atmosphere->isWidebandModeAvailable())
            source.refusals.push_back(atmosphere->name() + " " + atmosphere->widebandRefusal());
        else if (!atmosphere->covers(band))
            source.refusals.push_back(outside(*atmosphere));
        else
            source.refusals.push_back(atmosphere->name() + " knows fewer quantities than " +
                                      answering->name());
    }
    if (answering != nullptr)
        source.providedBy = answering->name();
    return source;
}

} // namespace

std::vector<BandProviders> providersFor(const irsg::Environment& environment,
                                        std::span<const irsg::SpectralRange> bands) {
    std::vector<BandProviders> all;
    for (const irsg::SpectralRange& band : bands) {
        BandProviders& one = all.emplace_back(BandProviders{.band = band, .sources = {}});
        for (const AtmosphereProperty property : irsg::allAtmosphereProperties)
            one.sources.push_back(sourceOf(property, environment, band));
        one.sources.push_back(widebandSourceOf(environment, band));
    }
    return all;
}

} // namespace smat
