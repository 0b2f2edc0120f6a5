#include "smatcore/tools/WhoAnswers.h"

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

/// Goes through the atmospheres until one has `mayAnswer` and holds the band.
template <typename MayAnswer, typename WhyNot>
AnswerSource sourceOf(std::string quantity, const irsg::Environment& environment,
                      const irsg::SpectralRange* band, const MayAnswer& mayAnswer,
                      const WhyNot& whyNot) {
    AnswerSource source{.quantity = std::move(quantity), .answeredBy = {}, .refusals = {}};
    for (const auto& atmosphere : environment.atmospheres()) {
        if (!mayAnswer(*atmosphere)) {
            source.refusals.push_back(atmosphere->name() + " " + whyNot(*atmosphere));
        } else if (band != nullptr && !atmosphere->covers(*band)) {
            source.refusals.push_back(outside(*atmosphere));
        } else {
            source.answeredBy = atmosphere->name();
            break;
        }
    }
    return source;
}

AnswerSource sourceOf(AtmosphereProperty property, const irsg::Environment& environment,
                      const irsg::SpectralRange& band) {
    const bool isTemperature = property == AtmosphereProperty::ambientTemperature;
    AnswerSource source = sourceOf(
        irsg::name(property), environment, isTemperature ? nullptr : &band,
        [&](const Atmosphere& one) { return one.supports(property); },
        [&](const Atmosphere& one) { return one.refusal(property); });
    if (source.answeredBy.empty() && isTemperature && environment.defaultAmbient_K)
        source.answeredBy = fmt::format("default {:.6g} K", *environment.defaultAmbient_K);
    if (source.answeredBy.empty() && property == AtmosphereProperty::backgroundRadiance &&
        environment.defaultBackground)
        source.answeredBy = "default background";
    return source;
}

/// One air has the quadrature points of a band.
AnswerSource widebandSourceOf(const irsg::Environment& environment,
                              const irsg::SpectralRange& band) {
    AnswerSource source{.quantity = "wideband-ck", .answeredBy = {}, .refusals = {}};
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
        source.answeredBy = answering->name();
    return source;
}

} // namespace

std::vector<BandAnswers> whoAnswers(const irsg::Environment& environment,
                                    std::span<const irsg::SpectralRange> bands) {
    std::vector<BandAnswers> all;
    for (const irsg::SpectralRange& band : bands) {
        BandAnswers& one = all.emplace_back(BandAnswers{.band = band, .sources = {}});
        for (const AtmosphereProperty property : irsg::allAtmosphereProperties)
            one.sources.push_back(sourceOf(property, environment, band));
        one.sources.push_back(widebandSourceOf(environment, band));
    }
    return all;
}

} // namespace smat
