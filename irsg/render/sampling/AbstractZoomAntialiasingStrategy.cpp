#include "irsg/render/sampling/AbstractZoomAntialiasingStrategy.h"

#include <cmath>

namespace irsg {

DrawnWindow DrawnWindow::of(const SampleWindow& window) {
    const double tilesOfPixel = std::ldexp(1.0, window.level);
    return {window.region(), tilesOfPixel * window.samplesAcross, tilesOfPixel * window.samplesDown,
            window.entities};
}

std::vector<DrawnWindow> DrawnWindow::of(const std::vector<SampleWindow>& windows) {
    std::vector<DrawnWindow> result;
    for (const SampleWindow& window : windows)
        result.push_back(of(window));
    return result;
}

FrameReduction AbstractZoomAntialiasingStrategy::draw(const CameraFrame& camera,
                                                      const std::vector<ZoomEntityInfo>& objects,
                                                      RttPass& pass) {
    const std::vector<SampleWindow> planned = windows(objects);
    drawn_ = DrawnWindow::of(planned);
    const std::vector<SampleWindow> pieces = piecesOf(planned, pass.largestSide());
    FrameReduction frame(camera.sensor(), pieces);
    for (const SampleSheet& sheet : sheetsOf(pieces, pass.largestSide())) {
        pass.draw(camera, sheet, samples_);
        for (const SampleWindow& window : sheet.windows)
            frame.add(window, samples_);
    }
    if (samples_.planes.size() > 2 * mostSamplesKept)
        samples_ = {};
    return frame;
}

std::vector<SampleWindow> piecesOf(const std::vector<SampleWindow>& windows, int largestSide) {
    std::vector<SampleWindow> result;
    for (const SampleWindow& window : windows)
        for (SampleWindow& piece : window.pieces(largestSide))
            result.push_back(std::move(piece));
    return result;
}

} // namespace irsg
