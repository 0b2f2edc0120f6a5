#pragma once

#include <string>
#include <vector>

#include "irsg/scene/values/PixelExplanation.h"

namespace smat::batch {

/// What was computed of a pixel beside what was drawn, W m-2 sr-1.
struct ExplainedPixel {
    irsg::PixelExplanation computed;
    double drawn_W_m2_sr = 0.0;

    double difference_W_m2_sr() const { return computed.radiance_W_m2_sr - drawn_W_m2_sr; }
    /// Of what was drawn; 0 where both are nothing.
    double relative() const;
};

/// Tables for people, surface by surface.
std::string explanationText(const std::vector<ExplainedPixel>& pixels, const std::string& renderer);
/// {"renderer", "pixels": [{"x", "y", "surfaces": [...], ...}]}
std::string explanationJson(const std::vector<ExplainedPixel>& pixels, const std::string& renderer);

} // namespace smat::batch
