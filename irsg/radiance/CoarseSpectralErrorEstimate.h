#pragma once

#include <functional>

#include "irsg/atmosphere/AtmosphereIdentity.h"
#include "irsg/core/RecentlyUsed.h"
#include "irsg/radiance/AtmosphericQueryCache.h"
#include "irsg/radiance/RadiometryCache.h"
#include "irsg/radiance/SampledScene.h"
#include "irsg/radiometry/Band.h"

namespace irsg {

/// The same air in other spectral bins, and what is kept of scenes in it: what their errors are
/// measured by. Errors of bins are their own, and those of wider bins are larger.
class CoarseSpectralErrorEstimate {
  public:
    /// In bins of 15 cm-1, or of 5 where they are 15 or 1; air without bins as it is. Kept for the
    /// air it is of; sun and defaults are those of `environment`. Its answers do not depend on what
    /// it was asked before, since errors are differences of nearly equal ones.
    const Environment& of(const Environment& environment, const Band& band);
    /// The same air in its own bins, and at its own wideband points.
    const Environment& like(const Environment& environment);

    AtmosphericQueryCache answers;
    SampledScenes sampled;
    RadiometryCache radiometry;

  private:
    struct CacheEntry {
        AtmosphereIdentity of;
        Environment environment;
    };
    const Environment& cached(RecentlyUsed<CacheEntry>& among, const Environment& environment,
                              const std::function<Environment()>& make);

    RecentlyUsed<CacheEntry> others_{4}, alike_{4};
};

} // namespace irsg
