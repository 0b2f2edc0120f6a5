#pragma once

#include <string>
#include <vector>

#include "irsg/image/RadianceImage.h"

namespace irsg {

/// A rectangle of the image plane whose samples the antialiasing spent apart from the rest: what
/// the report draws as the frustum of a zoom camera. Pixels from the top left corner of the frame
/// to the right and down; not bound to whole pixels.
struct SampledTile {
    double left_px = 0.0, top_px = 0.0, right_px = 0.0, bottom_px = 0.0;
    double across = 0.0, down = 0.0; ///< samples per pixel; 0 for a point, which is not sampled
    std::string objects;             ///< names of what is drawn in it, "hull, mast"

    bool operator==(const SampledTile&) const = default;
};

/// As the attribute `tiles` of an image: a line for each, coarse before fine.
void describeTiles(const std::vector<SampledTile>& tiles, RadianceImage& image);
/// Of the attribute; empty where the image has none or another program wrote it otherwise.
std::vector<SampledTile> tilesOf(const RadianceImage& image);

} // namespace irsg
