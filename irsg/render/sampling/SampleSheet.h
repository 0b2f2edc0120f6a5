#pragma once

#include <cstddef>
#include <vector>

#include "irsg/render/sampling/SampleTile.h"

namespace irsg {

/// Tiles that follow one another and are drawn side by side in one go: small ones alone would
/// leave most of a rasteriser's threads idle and the rest of the time to waiting.
struct SampleSheet {
    int width = 0, height = 0;
    std::vector<SampleTile> tiles; ///< with their place in it

    static SampleSheet of(const SampleTile& tile) { return {tile.width(), tile.height(), {tile}}; }
};

/// Sheets of all tiles, in their order. A sheet has at most `largestSide` samples a side, as each
/// tile has, and about as many as a large tile.
std::vector<SampleSheet> sheetsOf(std::vector<SampleTile> tiles, int largestSide);

} // namespace irsg
