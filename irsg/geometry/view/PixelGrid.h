#pragma once

#include <cmath>

#include "irsg/geometry/view/Sensor.h"

namespace irsg {

/// Solid angles of pixels and cosines off the axis: what many pixels share is computed once.
class PixelGrid {
  public:
    PixelGrid() = default;
    explicit PixelGrid(const Sensor& sensor)
        : pitch_(sensor.pixelPitch()),
          centreX_(0.5 * sensor.width_px - 0.5),
          centreY_(0.5 * sensor.height_px - 0.5),
          width_(sensor.width_px),
          height_(sensor.height_px) {}

    struct Pixel {
        double solidAngle_sr = 0.0;
        double cosOffAxis = 0.0;
    };
    Pixel at(int x, int y) const {
        const double u = (x - centreX_) * pitch_, v = (y - centreY_) * pitch_;
        const double cosine = 1.0 / std::sqrt(1.0 + u * u + v * v);
        return {pitch_ * pitch_ * cosine * cosine * cosine, cosine};
    }

    /// What a small part of a pixel is over what its share of the pixel's area is of the pixel.
    struct Share {
        double solidAngle = 1.0;
        double projected = 1.0; ///< of solid angle times the cosine off the axis
    };
    /// Around a place `right_px` and `below_px` from the centre, -1/2 to 1/2. The solid angle falls
    /// towards the rim of a frame as cos^3 of the angle off the axis, the projected one as cos^4;
    /// to first order here, so that the mean over a pixel is 1.
    Share shareAt(int x, int y, double right_px, double below_px) const {
        const double u = (x - centreX_) * pitch_, v = (y - centreY_) * pitch_;
        const double outwards = pitch_ * (u * right_px + v * below_px) / (1.0 + u * u + v * v);
        return {1.0 - 3.0 * outwards, 1.0 - 4.0 * outwards};
    }
    /// Whether parts of a pixel differ by so much that they are told apart; if not, those of no
    /// pixel do that is nearer to the axis.
    bool hasUnequalShares(int x, int y) const {
        const double u = (x - centreX_) * pitch_, v = (y - centreY_) * pitch_;
        return pitch_ * std::sqrt(u * u + v * v) > mostEqual;
    }

    /// Sum of solid angle times cosine over all pixels, sr.
    double projectedSolidAngle_sr() const {
        double sum = 0.0;
        for (int y = 0; y < height_; ++y)
            for (int x = 0; x < width_; ++x) {
                const Pixel pixel = at(x, y);
                sum += pixel.solidAngle_sr * pixel.cosOffAxis;
            }
        return sum;
    }

  private:
    static constexpr double mostEqual = 1e-6; ///< pitch times tangent of the angle off the axis
    double pitch_ = 0.0, centreX_ = 0.0, centreY_ = 0.0;
    int width_ = 0, height_ = 0;
};

} // namespace irsg
