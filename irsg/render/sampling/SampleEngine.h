#pragma once

#include <cstddef>
#include <functional>
#include <future>
#include <string>

#include "irsg/render/sampling/Samples.h"
#include "irsg/render/sampling/SurfaceScene.h"

namespace irsg {

/// Largest side of one drawing, samples: bounds the memory of what is drawn at once.
inline constexpr int largestDrawing = 2048;

/// Who answers the samples of windows: which surfaces each one meets, from front to back, and what
/// factors geometry makes of them. OpenGL (opengl/GlEngine) and rays (rays/RayEngine) give the same
/// answers to the same windows, so that nothing behind knows who gave them.
class SampleEngine {
  public:
    virtual ~SampleEngine() = default;

    /// Does work on the engine's thread, in the order in which it comes.
    virtual std::future<void> post(std::function<void()> work) = 0;
    /// The same and waits; what the work throws is thrown here.
    void run(const std::function<void()>& work) { post(work).get(); }

    /// "llvmpipe (LLVM 15.0.6, 256 bits), OpenGL 4.5 (Compatibility Profile) Mesa 22.3.6".
    virtual std::string description() const = 0;
    /// Largest side of a drawing, samples: at most largestDrawing.
    virtual int largestSide() const = 0;

    /// On the engine's thread: radiances of rows; LogicError where an item is transparent.
    virtual void renderRadiance(const SheetScene& sheet, RadianceSamples& samples) = 0;
    /// On the engine's thread: factors of all layers, the transparent ones not sorted yet.
    virtual void sampleGeometry(const SheetScene& sheet, bool withDistance,
                                GeometrySamples& samples) = 0;

    /// Seconds spent drawing and reading back since the last call.
    virtual double takeRenderSeconds() = 0;
    virtual double takeReadSeconds() { return 0.0; }
    /// Memory on the graphics card that every drawing shares.
    virtual std::size_t bytes() const { return 0; }
};

} // namespace irsg
