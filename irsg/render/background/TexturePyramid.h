#pragma once

#include <vector>

#include "irsg/geometry/conversion/TextureImage.h"

namespace irsg {

/// A picture and its box means, each half as wide and high as the one before, read as OpenGL's
/// trilinear filter does.
class TexturePyramid {
  public:
    TexturePyramid(const TextureImage& image, TextureWrap wrapS, TextureWrap wrapT);

    /// At a place (0 to 1 over the picture, t upwards), averaged over steps of (s, t) from one
    /// sample to the next across and down.
    double at(double s, double t, const double (&across)[2], const double (&down)[2]) const;

  private:
    struct Level {
        int width = 0, height = 0;
        std::vector<float> values; ///< bottom row first
    };
    static Level halved(const Level& level);
    double bilinear(const Level& level, double s, double t) const;

    std::vector<Level> levels_;
    TextureWrap wrapS_, wrapT_;
};

} // namespace irsg
