#include "irsg/scene/antialiasing/AbstractZoomAntialiasingStrategy.h"

namespace irsg {

FrameReduction AbstractZoomAntialiasingStrategy::draw(const CameraFrame& camera,
                                                      const std::vector<ZoomEntityInfo>& objects,
                                                      RttPass& pass) {
    const std::vector<SampleWindow> pieces = piecesOf(windows(objects), pass.largestSide());
    FrameReduction frame(camera.sensor(), pieces);
    RadianceSamples samples;
    for (const SampleWindow& window : pieces) {
        pass.draw(camera, window, samples);
        frame.add(window, samples);
    }
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
