#include <cmath>

#include "benchmarks/antialiasing/Study.h"

namespace irsg::study {

std::string Method::name() const {
    return strategy + " " + std::to_string(mode) + (wholeFrame ? " whole frame" : "");
}

RenderSettings Method::settings() const {
    RenderSettings settings = RenderSettings::direct();
    settings.background = BackgroundMode::constant;
    settings.tileSide_samples = mode < 3 ? 0 : 64 << (mode - 2);
    settings.samplesPerAxis = mode < 3 ? 1 << mode : 4;
    settings.tileStrategy = strategy == "sills" ? TileStrategy::published : TileStrategy::aligned;
    return settings;
}

std::vector<Method> methods() {
    std::vector<Method> result;
    for (int mode : {0, 1, 2})
        result.push_back({"supersampling", mode, false});
    result.push_back({"supersampling", 2, true});
    for (const char* strategy : {"aligned", "sills"})
        for (int mode : {3, 4, 5})
            result.push_back({strategy, mode, false});
    return result;
}

std::vector<double> sizes_px() {
    // No ratio of them to a pixel or to a sample is a round number, which would hide errors.
    constexpr double largest_px = 101.3, smallest_px = 0.00987;
    std::vector<double> result;
    for (int i = 0; i <= 12; ++i)
        result.push_back(largest_px * std::pow(smallest_px / largest_px, i / 12.0));
    return result;
}

} // namespace irsg::study
