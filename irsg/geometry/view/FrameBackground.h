#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace irsg {

/// In-band radiance behind the objects, W m-2 sr-1: the same everywhere, or one value per pixel.
class FrameBackground {
  public:
    /// The same behind every pixel.
    explicit FrameBackground(double radiance_W_m2_sr = 0.0) : uniform_W_m2_sr_(radiance_W_m2_sr) {}
    /// One mean per pixel, top row first, width x height of them; `centre_W_m2_sr` at the middle of
    /// the field.
    FrameBackground(int width_px, std::vector<double> radiance_W_m2_sr, double centre_W_m2_sr)
        : width_px_(static_cast<std::size_t>(width_px)),
          uniform_W_m2_sr_(centre_W_m2_sr),
          pixels_W_m2_sr_(std::move(radiance_W_m2_sr)) {}

    /// Both are uniform, of whatever level, or equal pixel by pixel.
    bool variesLike(const FrameBackground& other) const {
        return pixels_W_m2_sr_ == other.pixels_W_m2_sr_;
    }
    bool isUniform() const { return pixels_W_m2_sr_.empty(); }
    double at(int x, int y) const {
        return isUniform() ? uniform_W_m2_sr_
                           : pixels_W_m2_sr_[static_cast<std::size_t>(y) * width_px_ +
                                             static_cast<std::size_t>(x)];
    }
    /// In the middle of the field.
    double centre_W_m2_sr() const { return uniform_W_m2_sr_; }
    /// What objects hide of a pixel, where it is not the pixel's mean: a pixel has one radiance,
    /// and an object smaller than it stands before a part of it.
    double behindAt(int x, int y) const { return at(x, y) + behindMore_W_m2_sr_; }

    /// The same times a factor, with so much more behind objects than in their pixels.
    FrameBackground matched(double factor, double behindMore_W_m2_sr) const {
        FrameBackground made = *this;
        made.uniform_W_m2_sr_ *= factor;
        for (double& pixel : made.pixels_W_m2_sr_)
            pixel *= factor;
        made.behindMore_W_m2_sr_ = behindMore_W_m2_sr;
        return made;
    }

  private:
    std::size_t width_px_ = 0;
    double uniform_W_m2_sr_;
    double behindMore_W_m2_sr_ = 0.0;
    std::vector<double> pixels_W_m2_sr_;
};

} // namespace irsg
