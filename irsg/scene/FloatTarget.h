#pragma once

#include <vector>

#include <osg/GL>

namespace irsg {

/// An off-screen render target: one or two RGBA32F colour planes and a 32-bit float depth texture,
/// grown as needed and reused. Lives and dies on the context's thread.
class FloatTarget {
  public:
    explicit FloatTarget(int colourPlanes);
    ~FloatTarget();
    FloatTarget(const FloatTarget&) = delete;
    FloatTarget& operator=(const FloatTarget&) = delete;

    /// Makes the planes at least this large. Throws InputError when the driver refuses the target.
    void reserve(int width, int height);
    /// Binds it for drawing with the viewport at its lower left corner.
    void bind(int width, int height) const;
    /// Colours to 0, depth to 0, which is infinitely far: depth is reversed
    /// (CameraFrame::clipFromEye).
    void clear() const;

    /// RGBA of a colour plane, four floats a sample, bottom row first as GL has it.
    void read(int plane, int width, int height, std::vector<float>& into) const;

    GLuint colourTexture(int plane) const { return colour_[static_cast<std::size_t>(plane)]; }
    GLuint depthTexture() const { return depth_; }

  private:
    void release();

    int width_ = 0;
    int height_ = 0;
    GLuint framebuffer_ = 0;
    GLuint depth_ = 0;
    std::vector<GLuint> colour_;
};

} // namespace irsg
