#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "irsg/image/Canvas.h"
#include "irsg/image/ColorMap.h"
#include "irsg/image/RadianceImage.h"

namespace irsg {

/// Of the frame around the picture in a view with colour bar.
inline constexpr Rgb viewFrameColor{96, 96, 96};

/// How a plane is made into a picture. A PNG is a view: the values themselves belong in EXR or CSV.
struct PngViewOptions {
    std::string colorMap = ColorMap::defaultName;
    /// Without: minimum to maximum of the finite values; symmetric about 0 for a diverging map.
    /// What they mark as outside is counted beside the bar, as NaN is.
    std::optional<DisplayLimits> limits{};
    bool colorBar = true;
    std::string title{};      ///< a line above the picture of a view with colour bar
    std::string conditions{}; ///< a line below the title
    std::string label{};      ///< above the bar; empty: the name of the plane's quantity
    /// Side of a pixel of the plane in the view. 0: 1 without a bar; with one, small planes are
    /// enlarged by the whole number that makes them about 240 px high.
    int magnification = 0;
    /// Size of text and lines. 0: 1, or 2 for large pictures.
    int textScale = 0;
};

/// The picture of a plane, with its colour bar: ticks at round values, the unit, and colours and
/// counts of what is out of range or not a number, where there is any.
/// Throws InputError for an unknown colour map, limits that are not finite or not low < high, a
/// magnification or text scale out of 0 to 64 or 0 to 8, and a view beyond 65535 px a side.
Canvas renderView(const RadianceImage& image, const ImageChannel& plane,
                  const PngViewOptions& options = {});

/// Writes the view of a plane (empty name: the shown one; LogicError if there is none such).
void writePngView(const RadianceImage& image, const std::filesystem::path& file,
                  const PngViewOptions& options = {}, const std::string& channel = "");

} // namespace irsg
