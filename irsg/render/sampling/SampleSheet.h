#pragma once

#include <cstddef>
#include <vector>

#include "irsg/render/sampling/SampleWindow.h"

namespace irsg {

/// Windows that follow one another and are drawn side by side in one go: small ones alone would
/// leave most of a rasteriser's threads idle and the rest of the time to waiting.
struct SampleSheet {
    int width = 0, height = 0;
    std::vector<SampleWindow> windows; ///< with their place in it

    static SampleSheet of(const SampleWindow& window) {
        return {window.width(), window.height(), {window}};
    }
};

/// Sheets of all windows, in their order. A sheet has at most `largestSide` samples a side, as each
/// window has, and about as many as a large window.
std::vector<SampleSheet> sheetsOf(std::vector<SampleWindow> windows, int largestSide);

} // namespace irsg
