#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "irsg/scene/Renderer.h"

namespace irsg {

/// The door with a memory, for programs that step through frames: change `scene` or `view`, then
/// ask. Every result is what Renderer::render says of their present values.
class InteractiveRenderer {
  public:
    explicit InteractiveRenderer(const RenderSettings& settings = {}) { scene.settings = settings; }

    Scene scene;
    SensorView view;

    Rendered render(const Outputs& outputs) { return renderer_->render(scene, view, outputs); }
    PendingRender begin(const Outputs& outputs) { return renderer_->begin(scene, view, outputs); }
    /// See Renderer::explainer; of the present values.
    std::function<PixelExplanation(int x, int y)> explainer() const {
        return renderer_->explainer(scene, view);
    }
    /// See Renderer::check.
    void check() const { renderer_->check(scene, view); }
    /// In the world, at the entity's present pose.
    Vec3 referencePoint(std::size_t entity) const;

    /// Radiance image in W m-2 sr-1 with its report.
    RenderedImage imageWithReport();
    /// The image alone, and of its report how it was drawn: no sums.
    RenderedImage image();
    /// The image for a window that follows what is edited (Outputs::followedImage).
    RadianceImage picture();
    /// The report alone (Outputs::reports).
    RenderReport measure();
    std::vector<RenderReport> measure(const std::vector<Band>& bands);
    IntensitySpectrum measureSpectrum(const std::vector<double>& wavenumbers_per_cm);
    /// What measure() would say of all objects together, as a function of scales.
    std::unique_ptr<const ScaledView> scaledView(const std::vector<ScalingInput>& inputs);
    /// The same of measureSpectrum().
    std::unique_ptr<const ScaledView> scaledSpectrum(const std::vector<ScalingInput>& inputs,
                                                     const std::vector<double>& wavenumbers_per_cm);

    std::string rendererDescription() const { return renderer_->rendererDescription(scene); }
    std::size_t graphicsMemory_bytes() const { return renderer_->graphicsMemory_bytes(); }
    /// Since the last reset.
    StageTimes stageTimes() const { return renderer_->stageTimes().since(earlier_); }
    void resetStageTimes() { earlier_ = renderer_->stageTimes(); }

  private:
    std::unique_ptr<Renderer> renderer_ = std::make_unique<Renderer>();
    StageTimes earlier_;
};

} // namespace irsg
