#include "irsg/scene/radiance/AirAnswers.h"

#include <algorithm>

#include "irsg/atmosphere/ck/SensorCkData.h"

namespace irsg {

void AirAnswers::setEnvironment(const Environment& environment) {
    const bool isSame = environment.atmospheres() == environment_.atmospheres() &&
                        environment.defaultBackground == environment_.defaultBackground &&
                        environment.defaultAmbient_K == environment_.defaultAmbient_K;
    if (!isSame || numbers_ > mostKept) {
        const auto isOld = [&](const auto& kept) { return !isSame || kept.second.used < case_; };
        std::erase_if(spectra_, isOld);
        std::erase_if(samples_, isOld);
        std::erase_if(samplings_, [&](const auto& sampling) {
            return std::ranges::none_of(
                samples_, [&](const auto& kept) { return kept.first.second == sampling.get(); });
        });
        numbers_ = 0;
        for (const auto& [key, kept] : spectra_)
            numbers_ += 64 + 2 * kept.answer.value.wavelengths_um().size();
        for (const auto& [key, kept] : samples_)
            numbers_ += 64 + kept.answer.value.size();
    }
    ++case_;
    environment_ = environment;
}

const Answer<Spectrum>& AirAnswers::spectrum(const AirQuestion& question,
                                             const SpectralRange& range) {
    const std::pair key{environment_.keyOf(question, range), std::pair{range.min_um, range.max_um}};
    auto known = spectra_.find(key);
    if (known == spectra_.end()) {
        ++asked_;
        known = spectra_.try_emplace(key, environment_.spectrum(question, range)).first;
        numbers_ += 64 + 2 * known->second.answer.value.wavelengths_um().size();
    }
    known->second.used = case_;
    return known->second.answer;
}

const Answer<std::vector<double>>&
AirAnswers::at(const AirQuestion& question,
               const std::shared_ptr<const SpectralSampling>& sampling) {
    const std::pair key{environment_.keyOf(question, *sampling), sampling.get()};
    auto known = samples_.find(key);
    if (known == samples_.end()) {
        if (std::ranges::find(samplings_, sampling) == samplings_.end())
            samplings_.push_back(sampling);
        numbers_ += 64 + sampling->size();
        // In the spectral mode the quadrature was built on the same spectra, which need not be
        // asked for again.
        if (!SensorCkData::of(*sampling)) {
            const Answer<Spectrum>& native = spectrum(question, sampling->range());
            known =
                samples_
                    .try_emplace(key, Answer<std::vector<double>>{sampling->sampled(native.value),
                                                                  native.answeredBy})
                    .first;
        } else {
            ++asked_;
            known = samples_.try_emplace(key, environment_.answer(question, *sampling)).first;
        }
    }
    known->second.used = case_;
    return known->second.answer;
}

} // namespace irsg
