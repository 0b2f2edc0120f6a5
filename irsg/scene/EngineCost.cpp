#include "irsg/scene/EngineCost.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "irsg/core/Interpolation.h"

namespace irsg {

namespace {

/// llvmpipe: a drawing whatever is in it, what comes back of a sample, what a sample that is hit is
/// shaded for, a transparent layer of it, and a facet.
constexpr double drawing_ms = 0.4, sampleBack_ns = 6.0, shaded_ns = 31.0, listed_ns = 160.0,
                 facet_ns = 200.0;
/// Embree: a frame whatever is in it, a ray that misses, one that hits among so many facets, and
/// each transparent surface that it goes through.
constexpr double traced_ms = 0.2, missed_ns = 25.0, layer_ns = 365.0;
struct Hit {
    double facets, ns;
};
constexpr Hit hits[] = {{1e3, 330.0}, {1e4, 355.0}, {1e5, 470.0}, {1e6, 950.0}};

/// Linear in the logarithm of the number of facets, and beyond the ends.
double hit_ns(double facets) {
    const Bracket at = bracket(hits, std::log10(std::max(facets, 1.0)), Beyond::extrapolate,
                               [](const Hit& hit) { return std::log10(hit.facets); });
    return std::max(lerp(hits[at.below].ns, hits[at.above].ns, at.fraction), 0.5 * hits[0].ns);
}

std::string rounded(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.*f", value < 9.95 ? 1 : 0, value);
    return text;
}

} // namespace

double openGlCost_ms(const EngineWork& work) {
    const double own_ns = shaded_ns + work.layers * listed_ns;
    return drawing_ms +
           1e-6 * (work.samples * sampleBack_ns + work.covered * own_ns + work.facets * facet_ns);
}

double raysCost_ms(const EngineWork& work) {
    const double own_ns = hit_ns(work.facets) + work.layers * layer_ns;
    return traced_ms + 1e-6 * ((work.samples - work.covered) * missed_ns + work.covered * own_ns);
}

EngineChoice quickerEngine(const EngineWork& work) {
    return openGlCost_ms(work) <= raysCost_ms(work) ? EngineChoice::opengl : EngineChoice::rays;
}

std::string wordsOf(const EngineWork& work) {
    return rounded(work.facets) + " facets, " + rounded(work.samples) + " samples" +
           (work.layers > 0.0 ? ", " + rounded(work.layers) + " layers before one" : "") +
           " and no graphics card: about " + rounded(openGlCost_ms(work)) + " ms by OpenGL, " +
           rounded(raysCost_ms(work)) + " by rays";
}

} // namespace irsg
