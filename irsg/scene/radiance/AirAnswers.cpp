#include "irsg/scene/radiance/AirAnswers.h"

#include <algorithm>

#include "irsg/atmosphere/ck/SensorCkData.h"

namespace irsg {

void AirAnswers::setEnvironment(const Environment& environment) {
    const bool isSame = environment.atmospheres() == environment_.atmospheres() &&
                        environment.defaultBackground == environment_.defaultBackground &&
                        environment.defaultAmbient_K == environment_.defaultAmbient_K;
    if (!isSame || numbers_ > mostKept) {
        numbers_ = 0;
        spectra_.clear();
        samples_.clear();
        samplings_.clear();
    }
    environment_ = environment;
}

const Answer<Spectrum>& AirAnswers::spectrum(const AirQuestion& question,
                                             const SpectralRange& range) {
    const std::pair key{environment_.keyOf(question, range), std::pair{range.min_um, range.max_um}};
    if (const auto known = spectra_.find(key); known != spectra_.end())
        return known->second;
    ++asked_;
    const auto& made = spectra_.emplace(key, environment_.spectrum(question, range)).first->second;
    numbers_ += 64 + 2 * made.value.wavelengths_um().size();
    return made;
}

const Answer<std::vector<double>>&
AirAnswers::at(const AirQuestion& question,
               const std::shared_ptr<const SpectralSampling>& sampling) {
    const std::pair key{environment_.keyOf(question, *sampling), sampling.get()};
    if (const auto known = samples_.find(key); known != samples_.end())
        return known->second;
    if (std::ranges::find(samplings_, sampling) == samplings_.end())
        samplings_.push_back(sampling);
    numbers_ += 64 + sampling->size();
    // In the spectral mode the quadrature was built on the same spectra, which need not be asked
    // for again.
    if (!SensorCkData::of(*sampling)) {
        const Answer<Spectrum>& native = spectrum(question, sampling->range());
        return samples_
            .emplace(key, Answer<std::vector<double>>{sampling->sampled(native.value),
                                                      native.answeredBy})
            .first->second;
    }
    ++asked_;
    return samples_.emplace(key, environment_.answer(question, *sampling)).first->second;
}

} // namespace irsg
