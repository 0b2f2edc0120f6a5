#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "irsg/atmosphere/Environment.h"
#include "irsg/radiance/SharedValues.h"
#include "irsg/radiometry/SpectralSampling.h"

namespace irsg {

/// What an environment answered, kept by value: a path that several cases share is asked once. A
/// query is the same where its answer cannot differ; the azimuth counts only for air that
/// answers by it.
class AtmosphericQueryCache {
  public:
    /// Forgets everything unless the atmospheres and defaults are those of before; the sun may
    /// move. Answers stay where they are until the next call, which is due before every case.
    void setEnvironment(const Environment& environment);
    const Environment& environment() const { return environment_; }

    /// On the nodes that the air has of itself. InputError where nobody answers.
    const Provided<Spectrum>& spectrum(const AtmosphericQuery& query, const SpectralRange& range);
    /// On the nodes of a sampling, which is kept as long as its answers.
    const Provided<SharedValues>& at(const AtmosphericQuery& query,
                                     const std::shared_ptr<const SpectralSampling>& sampling);

  private:
    void beginCase();

    /// Numbers that are kept from case to case (8 MiB), since a sweep of some thousand paths would
    /// fill memory; of more, those of the last case that asked.
    static constexpr std::size_t mostCached = std::size_t{1} << 20;

    Environment environment_;
    template <typename Value>
    struct CacheEntry {
        Provided<Value> answer;
        long used = 0; ///< the case that asked for it last
    };
    std::map<std::pair<AtmosphericQueryKey, std::pair<double, double>>, CacheEntry<Spectrum>>
        spectra_;
    std::map<std::pair<AtmosphericQueryKey, const SpectralSampling*>, CacheEntry<SharedValues>>
        samples_;
    /// Those of samples_.
    std::map<const SpectralSampling*, std::shared_ptr<const SpectralSampling>> samplings_;
    long case_ = 0; // that asked last
    bool isNewCase_ = false;
    std::size_t numbers_ = 0; // in all answers
};

} // namespace irsg
