// Scenes in the wideband mode beside the spectral one: difference of the apparent in-band intensity
// and of the background, and time of one view whose factors are known, as a table in Markdown. With
// reflection the difference is that of the spectral mode, which multiplies means of bins.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>

#include "tests/support/WidebandScenes.h"

using namespace irsg;
using namespace irsg::test;

namespace {

double median_ms(int times, const std::function<void()>& work) {
    std::vector<double> values;
    for (int i = 0; i < times; ++i) {
        const auto start = std::chrono::steady_clock::now();
        work();
        values.push_back(
            std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
                .count());
    }
    std::ranges::nth_element(values, values.begin() + static_cast<long>(values.size() / 2));
    return values[values.size() / 2];
}

struct Measured {
    RenderReport report;
    double first_ms = 0.0; ///< with the training of the points, where they are new
    double later_ms = 0.0;
};

Measured measured(InteractiveRenderer& irsg, CalculationMode mode, ReflectionMode reflection) {
    RenderSettings settings = irsg.scene.settings;
    settings.mode = mode;
    settings.sun = settings.ambientReflection = reflection;
    settings.samplesPerAxis = 1;
    irsg.scene.settings = settings;
    Measured result;
    result.first_ms = median_ms(1, [&] { result.report = irsg.measure(); });
    result.later_ms = median_ms(15, [&] { irsg.measure(); });
    return result;
}

} // namespace

/// bench_wideband [RESOLUTION_CM]
int main(int argc, char** argv) {
    const int resolution_per_cm = argc > 1 ? std::atoi(argv[1]) : 5;
    std::printf("### Scenes in the wideband mode beside the spectral one, bins of %d cm⁻¹\n\n",
                resolution_per_cm);
    std::printf("| air | scene | reflection | spectral W sr⁻¹ | difference %% | background, "
                "difference %% | "
                "spectral ms | wideband ms | ratio |\n|---|---|---|---|---|---|---|---|---|\n");
    for (const WidebandAtmosphere& air : widebandAtmospheres()) {
        InteractiveRenderer irsg{RenderSettings::direct()};
        irsg.scene.environment = air.environment(resolution_per_cm);
        for (const WidebandScene& scene : widebandScenes(air.band()))
            for (const ReflectionMode reflection : {ReflectionMode::off, ReflectionMode::smart}) {
                irsg.scene.entities = {scene.entity};
                look(irsg, scene.view);
                const Measured spectral = measured(irsg, CalculationMode::spectral, reflection);
                const Measured wideband = measured(irsg, CalculationMode::wideband, reflection);
                auto error_percent = [](double ours, double reference) {
                    return 100.0 * (ours / reference - 1.0);
                };
                std::printf(
                    "| %s | %s | %s | %.4g | %.2f | %.2f | %.2f | %.3f | %.0f |\n", air.name,
                    scene.name.c_str(), reflection == ReflectionMode::off ? "off" : "on",
                    spectral.report.all.intensity_W_sr,
                    error_percent(wideband.report.all.intensity_W_sr,
                                  spectral.report.all.intensity_W_sr),
                    error_percent(wideband.report.background_W_m2_sr,
                                  spectral.report.background_W_m2_sr),
                    spectral.later_ms, wideband.later_ms, spectral.later_ms / wideband.later_ms);
            }
    }
    return 0;
}
