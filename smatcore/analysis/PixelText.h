#pragma once

#include <optional>
#include <string>
#include <vector>

#include "irsg/render/values/PixelExplanation.h"

namespace smat {

/// What was computed of a pixel beside what was drawn, W m-2 sr-1.
struct ExplainedPixel {
    irsg::PixelExplanation computed;
    double drawn_W_m2_sr = 0.0;
    /// What the image says that was asked about; none where that is what was drawn.
    std::optional<double> inImage_W_m2_sr = {};

    double difference_W_m2_sr() const { return computed.radiance_W_m2_sr - drawn_W_m2_sr; }
    /// Of what was drawn; 0 where both are nothing.
    double relative() const;
};

/// Tables for people, surface by surface.
std::string explanationText(const std::vector<ExplainedPixel>& pixels, const std::string& renderer);
/// {"renderer", "pixels": [{"x", "y", "surfaces": [...], ...}]}
std::string explanationJson(const std::vector<ExplainedPixel>& pixels, const std::string& renderer);

} // namespace smat
