#include "irsg/radiance/AtmosphericQueryCache.h"

#include <set>

#include "irsg/atmosphere/AtmosphereNodes.h"
#include "irsg/atmosphere/ck/SensorCkData.h"

namespace irsg {

void AtmosphericQueryCache::setEnvironment(const Environment& environment) {
    const bool isSame = environment.atmospheres() == environment_.atmospheres() &&
                        environment.defaultBackground == environment_.defaultBackground &&
                        environment.defaultAmbient_K == environment_.defaultAmbient_K;
    const bool hasAsked = !isNewCase_;
    if (!isSame || (hasAsked && numbers_ > mostCached)) {
        const auto isOld = [&](const auto& kept) { return !isSame || kept.second.used < case_; };
        std::erase_if(spectra_, isOld);
        std::erase_if(samples_, isOld);
        std::set<const SpectralSampling*> used;
        for (const auto& [key, kept] : samples_)
            used.insert(key.second);
        std::erase_if(samplings_, [&](const auto& known) { return !used.contains(known.first); });
        numbers_ = 0;
        for (const auto& [key, kept] : spectra_)
            numbers_ += 64 + 2 * kept.answer.value.wavelengths_um().size();
        for (const auto& [key, kept] : samples_)
            numbers_ += 64 + kept.answer.value->size();
    }
    isNewCase_ = true;
    environment_ = environment;
}

void AtmosphericQueryCache::beginCase() {
    case_ += isNewCase_ ? 1 : 0;
    isNewCase_ = false;
}

const Provided<Spectrum>& AtmosphericQueryCache::spectrum(const AtmosphericQuery& query,
                                                          const SpectralRange& range) {
    beginCase();
    const std::pair key{environment_.keyOf(query, range), std::pair{range.min_um, range.max_um}};
    auto known = spectra_.find(key);
    if (known == spectra_.end()) {
        known = spectra_.try_emplace(key, environment_.spectrum(query, range)).first;
        numbers_ += 64 + 2 * known->second.answer.value.wavelengths_um().size();
    }
    known->second.used = case_;
    return known->second.answer;
}

const Provided<SharedValues>&
AtmosphericQueryCache::at(const AtmosphericQuery& query,
                          const std::shared_ptr<const SpectralSampling>& sampling) {
    beginCase();
    const std::pair key{environment_.keyOf(query, *sampling), sampling.get()};
    auto known = samples_.find(key);
    if (known == samples_.end()) {
        // In the spectral mode the quadrature was built on the same spectra, which need not be
        // asked for again.
        Provided<std::vector<double>> answer;
        if (!SensorCkData::of(*sampling) && !AtmosphereNodes::of(*sampling)) {
            const Provided<Spectrum>& native = spectrum(query, sampling->range());
            answer = {sampling->sampled(native.value), native.providedBy};
        } else {
            answer = environment_.provide(query, *sampling);
        }
        samplings_.try_emplace(sampling.get(), sampling);
        numbers_ += 64 + sampling->size();
        auto values = std::make_shared<const std::vector<double>>(std::move(answer.value));
        known = samples_
                    .try_emplace(key, Provided<SharedValues>{std::move(values),
                                                             std::move(answer.providedBy)})
                    .first;
    }
    known->second.used = case_;
    return known->second.answer;
}

} // namespace irsg
