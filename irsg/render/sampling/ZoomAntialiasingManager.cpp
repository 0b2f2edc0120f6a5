#include "irsg/render/sampling/ZoomAntialiasingManager.h"

#include <tuple>

#include "irsg/render/sampling/PixelAlignedStrategy.h"
#include "irsg/render/sampling/SillsBasedStrategy.h"
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

std::unique_ptr<AbstractZoomAntialiasingStrategy> make(const RenderSettings& settings) {
    if (settings.zoomsAsPublished())
        return std::make_unique<SillsBasedStrategy>(settings.zoomWindow);
    if (settings.zoomsAligned())
        return std::make_unique<PixelAlignedStrategy>(settings.zoomWindow);
    const int n = settings.samplesPerAxis;
    return std::make_unique<SupersamplingStrategy>(
        settings.countsPerPixel ? countsPerPixel(n) : SupersamplingStrategy(n, n));
}

} // namespace

AbstractZoomAntialiasingStrategy&
ZoomAntialiasingManager::strategyFor(const RenderSettings& settings) {
    const auto asks = [](const RenderSettings& s) {
        return std::tuple(s.zoomWindow, s.zoomStrategy, s.samplesPerAxis, s.countsPerPixel);
    };
    if (!strategy_ || asks(settings) != asks(settings_)) {
        strategy_ = make(settings);
        settings_ = settings;
    }
    return *strategy_;
}

} // namespace irsg
