// A sphere lit by the sun in 12 bands of six model airs: what it reflects in the spectral mode
// beside the wideband one, which multiplies at single wavenumbers of the whole band. The emission
// of the sphere and of the path is taken off, so that light of the sun and of sky and ground is
// compared.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "tests/support/WidebandScenes.h"

using namespace irsg;
using namespace irsg::test;

namespace {

double intensity_W_sr(InteractiveRenderer& irsg, CalculationMode mode, ReflectionMode sun) {
    RenderSettings settings = irsg.scene.settings;
    settings.mode = mode;
    settings.sun = sun;
    settings.ambientReflection = ReflectionMode::smart;
    settings.samplesPerAxis = 1;
    irsg.scene.settings = settings;
    return irsg.measure().all.intensity_W_sr;
}

} // namespace

/// bench_sunlit [RESOLUTION_CM]
int main(int argc, char** argv) {
    const int resolution_per_cm = argc > 1 ? std::atoi(argv[1]) : 5;
    constexpr SpectralRange bands[] = {{0.7, 1.1}, {1.1, 1.4},  {1.5, 1.8}, {2.0, 2.5},
                                       {3.0, 3.4}, {3.4, 4.15}, {4.2, 4.6}, {4.5, 5.0},
                                       {3.0, 5.0}, {5.0, 8.0},  {8.0, 9.5}, {9.0, 12.0}};
    std::printf("### A sphere in the sun, spectral mode of %d cm⁻¹ against wideband points: "
                "difference %% of all its light, and of the sun's alone\n\n| band, µm | air | W "
                "sr⁻¹ | all | sun |\n|---|---|---|---|---|\n",
                resolution_per_cm);
    double largestAll = 0.0, largestSun = 0.0;
    for (const SpectralRange& range : bands) {
        const Band band = Band::topHat(range.min_um, range.max_um);
        for (int model = 1; model <= 6; ++model) {
            InteractiveRenderer irsg{RenderSettings::direct()};
            irsg.scene.environment = environmentOf(
                smartAtmosphere(model, range.min_um, range.max_um, 2, resolution_per_cm));
            const auto scenes = widebandScenes(band);
            irsg.scene.entities = {scenes.front().entity};
            look(irsg, scenes.front().view);
            const auto seen = [&](CalculationMode mode, ReflectionMode sun) {
                return intensity_W_sr(irsg, mode, sun);
            };
            const double spectral = seen(CalculationMode::spectral, ReflectionMode::smart);
            const double wide = seen(CalculationMode::wideband, ReflectionMode::smart);
            const double ofSun = spectral - seen(CalculationMode::spectral, ReflectionMode::off);
            const double ofSunWide = wide - seen(CalculationMode::wideband, ReflectionMode::off);
            const double all_percent = 100.0 * (spectral / wide - 1.0);
            // Of what is next to nothing beside the rest no digits are asked.
            const bool isSeen = ofSun > 1e-3 * spectral;
            const double sun_percent = isSeen ? 100.0 * (ofSun / ofSunWide - 1.0) : 0.0;
            largestAll = std::max(largestAll, std::abs(all_percent));
            largestSun = std::max(largestSun, std::abs(sun_percent));
            std::printf("| %g-%g | %d | %.4g | %+.3f | %s%+.3f |\n", range.min_um, range.max_um,
                        model, spectral, all_percent, isSeen ? "" : "dark ", sun_percent);
            std::fflush(stdout);
        }
    }
    std::printf("\nlargest: all %.3f %%, sun %.3f %%\n", largestAll, largestSun);
    return 0;
}
