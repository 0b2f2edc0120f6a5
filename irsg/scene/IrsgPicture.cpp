#include "irsg/scene/IrsgParts.h"

namespace irsg {

RadianceImage Irsg::picture() {
    Parts& p = *parts_;
    const Parts::Frame frame = p.frame();
    RenderReport report;
    const FrameReduction pixels = p.pixelsOf(frame, report);
    return p.timed("composition", [&] {
        RadianceImage image = pixels.compose(frame.background);
        p.describe(frame, image);
        describeWindows(report.windows, image);
        return image;
    });
}

FrameReduction Irsg::Parts::pixelsOf(const Frame& frame, RenderReport& report) {
    // Points are not drawn here, and the published antialiasing resamples what it draws.
    const bool isSum = frame.points.empty() &&
                       (settings.zoomWindow == 0 || settings.zoomStrategy == ZoomStrategy::aligned);
    PixelView view{isSum ? fingerprint(frame) : std::vector<double>{}, {}, {}};
    for (const Entity& entity : entities)
        view.models.push_back(entity.model);
    if (!isSum || view.fingerprint != pixelView.fingerprint || view.models != pixelView.models) {
        pixelView = std::move(view);
        return drawObjects(frame, report);
    }

    const std::vector<SampleWindow> planned =
        antialiasing.strategyFor(settings).windows(frame.drawn);
    report.windows = sampledWindows(DrawnWindow::of(planned), frame.points);
    const std::vector<SampleWindow> windows = piecesOf(planned, largestDrawing());
    if (!pixelView.factors) {
        std::vector<bool> transparent;
        for (const SurfaceSpectra& surface : frame.radiometry.surfaces())
            transparent.push_back(surface.isTransparent());
        pixelView.factors.emplace(sensor, std::move(transparent));
        drawFactorWindows(frame, frame.drawn, false, "factors of pixels",
                          [&](const SampleWindow& window, const FactorSamples& samples) {
                              pixelView.factors->add(window, samples);
                          });
        pixelView.factors->finish();
    }
    FrameReduction pixels(sensor, windows);
    timed("sums of pixels", [&] { pixelView.factors->evaluate(frame.scene.rows, pixels); });
    return pixels;
}

} // namespace irsg
