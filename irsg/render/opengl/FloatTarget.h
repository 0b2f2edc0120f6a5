#pragma once

#include <cstddef>
#include <vector>

#include "irsg/render/opengl/GlFunctions.h"

namespace irsg {

/// An off-screen render target: planes of 32-bit floats and a 32-bit float depth, grown as needed
/// and reused. Lives and dies on the context's thread.
class FloatTarget {
  public:
    /// Channels of each colour plane: 1, 2 or 4.
    explicit FloatTarget(std::vector<int> channels);
    ~FloatTarget();
    FloatTarget(const FloatTarget&) = delete;
    FloatTarget& operator=(const FloatTarget&) = delete;

    /// Makes the planes at least this large. Throws InputError when the driver refuses the target.
    void reserve(int width, int height);
    /// Memory of its planes.
    std::size_t bytes() const;
    /// Binds it for drawing with the viewport at its lower left corner.
    void bind(int width, int height) const;
    /// Colours to 0, depth to 0, which is infinitely far: depth is reversed
    /// (CameraFrame::clipFromEye).
    void clear() const;

    /// All channels of a plane, sample after sample, bottom row first as GL has it.
    void read(int plane, int width, int height, std::vector<float>& into) const;

  private:
    void release();

    std::vector<int> channels_;
    int width_ = 0;
    int height_ = 0;
    GLuint framebuffer_ = 0;
    GLuint depth_ = 0;
    std::vector<GLuint> colour_;
};

} // namespace irsg
