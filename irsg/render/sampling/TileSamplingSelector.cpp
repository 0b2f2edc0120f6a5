#include "irsg/render/sampling/TileSamplingSelector.h"

#include <tuple>

#include "irsg/render/sampling/PixelAlignedStrategy.h"
#include "irsg/render/sampling/PublishedTileStrategy.h"
#include "irsg/render/sampling/SupersamplingStrategy.h"

namespace irsg {

namespace {

/// The most nearly square grid of so many samples, wider than high.
SupersamplingStrategy countsPerPixel(int samples) {
    int down = 1;
    for (int n = 1; n * n <= samples; ++n)
        if (samples % n == 0)
            down = n;
    return {samples / down, down};
}

std::unique_ptr<TileSamplingStrategy> make(const RenderSettings& settings) {
    if (settings.usesPublishedTiles())
        return std::make_unique<PublishedTileStrategy>(settings.tileSide_samples);
    if (settings.usesAlignedTiles())
        return std::make_unique<PixelAlignedStrategy>(settings.tileSide_samples);
    const int n = settings.samplesPerAxis;
    return std::make_unique<SupersamplingStrategy>(
        settings.countsPerPixel ? countsPerPixel(n) : SupersamplingStrategy(n, n));
}

} // namespace

TileSamplingStrategy& TileSamplingSelector::strategyFor(const RenderSettings& settings) {
    const auto asks = [](const RenderSettings& s) {
        return std::tuple(s.tileSide_samples, s.tileStrategy, s.samplesPerAxis, s.countsPerPixel);
    };
    if (!strategy_ || asks(settings) != asks(settings_)) {
        strategy_ = make(settings);
        settings_ = settings;
    }
    return *strategy_;
}

} // namespace irsg
