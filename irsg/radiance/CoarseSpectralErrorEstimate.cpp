#include "irsg/radiance/CoarseSpectralErrorEstimate.h"

#include "irsg/atmosphere/EnvironmentVariants.h"

namespace irsg {

namespace {

std::size_t nodesOf(const Environment& environment, const Band& band) {
    const auto nodes = environment.nodesOf(band);
    return nodes ? nodes->size() : 0;
}

} // namespace

const Environment& CoarseSpectralErrorEstimate::cached(RecentlyUsed<CacheEntry>& among,
                                                       const Environment& environment,
                                                       const std::function<Environment()>& make) {
    among.letGo([](const CacheEntry& cached) { return cached.of.isGone(); });
    Environment& other =
        among
            .of([&](const CacheEntry& cached) { return cached.of.isOf(environment); },
                [&] {
                    return CacheEntry{AtmosphereIdentity(environment), make()};
                })
            .environment;
    other.sun = environment.sun;
    other.defaultBackground = environment.defaultBackground;
    other.defaultAmbient_K = environment.defaultAmbient_K;
    return other;
}

const Environment& CoarseSpectralErrorEstimate::of(const Environment& environment,
                                                   const Band& band) {
    return cached(others_, environment, [&] {
        constexpr int wide_per_cm = 15, usual_per_cm = 5;
        // The next wider, or the next narrower of the widest.
        Environment made = onTheFly(withBins(environment, usual_per_cm));
        if (nodesOf(made, band) == nodesOf(environment, band))
            made = onTheFly(withBins(environment, wide_per_cm));
        return made;
    });
}

const Environment& CoarseSpectralErrorEstimate::like(const Environment& environment) {
    return cached(alike_, environment, [&] { return onTheFly(environment); });
}

} // namespace irsg
