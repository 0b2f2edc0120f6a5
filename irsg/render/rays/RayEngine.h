#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "irsg/core/TaskThread.h"
#include "irsg/render/sampling/SampleEngine.h"

namespace irsg {

/// Some samples of a window that lie side by side; rows count from the top.
struct SampleRun {
    int row = 0, firstColumn = 0, count = 0;
    double weight = 1.0; ///< of each in its pixel, see SampleTile::forEachRun
};

/// Samples answered by rays, on all cores, without OpenGL: each sample of a window is a ray from
/// the eye through its place in the frame. Surfaces are met in double (RayMesh); the bytes of what
/// comes out do not depend on the number of threads.
class RayEngine : public SampleEngine {
  public:
    std::future<void> post(std::function<void()> work) override;
    std::string description() const override;
    int largestSide() const override;
    void renderRadiance(const SheetScene& sheet, RadianceSamples& samples) override;
    void sampleGeometry(const SheetScene& sheet, bool withDistance,
                        GeometrySamples& samples) override;
    double takeRenderSeconds() override;

    /// The factors of some samples of a window with their distances, on the caller's thread; the
    /// others meet nothing.
    static void traceRuns(const SheetScene& sheet, std::size_t tile,
                          const std::vector<SampleRun>& runs, GeometrySamples& samples);

  private:
    GeometrySamples factors_; // of radiances
    double renderSeconds_ = 0.0;
    TaskThread thread_; // last: what it does uses all others
};

} // namespace irsg
