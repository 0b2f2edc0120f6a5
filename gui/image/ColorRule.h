#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "gui/image/ColoredPlane.h"
#include "irsg/image/DisplayLimits.h"

namespace smat::gui {

/// How the limits of the colours are found.
enum class LimitMode {
    target,     ///< irsg::limitsFor
    full,       ///< least to largest
    percentile, ///< the percentiles that are typed in
    locked      ///< as typed in
};

/// What colours are made by, whatever is shown: the one rule of view, image windows and
/// comparison.
struct ColorRule {
    LimitMode mode = LimitMode::target;
    std::pair<double, double> percentiles{1.0, 99.0}; ///< of LimitMode::percentile
    irsg::ColorScale scale = irsg::ColorScale::automatic;
    bool marksOutside = false; ///< see irsg::DisplayLimits

    bool operator==(const ColorRule&) const = default;
};

/// Values that lie outside of the limits.
struct OutOfRange {
    std::size_t below = 0, above = 0, nan = 0;
};
/// Counted in one sweep.
OutOfRange countOutOfRange(const std::vector<float>& values, const irsg::DisplayLimits& limits);

/// Limits of colours with what lies outside of them.
struct FoundLimits {
    irsg::DisplayLimits limits;
    OutOfRange outside;
};
/// Limits of one plane, or of several that share them: between `known` ends, or as the mode says,
/// in either case with scale and marks. Without `known` the mode is not `locked`.
irsg::DisplayLimits limitsBy(const ColorRule& rule,
                             const std::vector<const std::vector<float>*>& planes,
                             const std::optional<irsg::DisplayLimits>& known = {});
/// The same with what lies outside of them.
FoundLimits findLimits(const ColorRule& rule, const std::vector<SharedValues>& planes,
                       const std::optional<irsg::DisplayLimits>& known);

} // namespace smat::gui
