#pragma once

#include <memory>

#include "irsg/render/sampling/SampleEngine.h"

namespace irsg {

class OffscreenContext;
class SurfacePass;

/// Samples drawn by OpenGL, off-screen. The first one of a process makes the context: InputError
/// where the machine has none.
class GlEngine : public SampleEngine {
  public:
    GlEngine();
    ~GlEngine() override;

    std::future<void> post(std::function<void()> work) override;
    std::string description() const override;
    int largestSide() const override;
    void renderRadiance(const SheetScene& sheet, RadianceSamples& samples) override;
    void sampleGeometry(const SheetScene& sheet, bool withDistance,
                        GeometrySamples& samples) override;
    double takeRenderSeconds() override;
    double takeReadSeconds() override;
    std::size_t bytes() const override;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace irsg
