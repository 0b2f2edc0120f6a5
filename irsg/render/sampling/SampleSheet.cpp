#include "irsg/render/sampling/SampleSheet.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <utility>

namespace irsg {

namespace {

double samplesOf(const SampleWindow& window) {
    return static_cast<double>(window.width()) * window.height();
}

/// Beyond, nothing is gained by drawing more in one go, but memory taken.
constexpr double mostSamples = 400'000.0;

/// Places windows on shelves, the highest first; nothing where that takes more than a side.
SampleSheet sheetOf(std::vector<SampleWindow> windows, int largestSide) {
    if (windows.size() == 1)
        return SampleSheet::of(windows.front());
    double all = 0.0;
    SampleSheet sheet;
    for (const SampleWindow& window : windows) {
        all += samplesOf(window);
        sheet.width = std::max(sheet.width, window.width());
    }
    sheet.width = std::clamp(static_cast<int>(std::sqrt(all)), sheet.width, largestSide);

    std::vector<std::size_t> order(windows.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, std::ranges::greater{},
                             [&](std::size_t i) { return windows[i].height(); });
    int x = 0, shelf = 0;
    for (const std::size_t i : order) {
        if (x + windows[i].width() > sheet.width) {
            x = 0;
            shelf = sheet.height;
        }
        windows[i].placeIn(sheet.width, x, shelf);
        x += windows[i].width();
        sheet.height = std::max(sheet.height, shelf + windows[i].height());
    }
    sheet.windows = std::move(windows);
    return sheet;
}

} // namespace

std::vector<SampleSheet> sheetsOf(std::vector<SampleWindow> windows, int largestSide) {
    std::vector<SampleSheet> sheets;
    std::vector<SampleWindow> together;
    double samples = 0.0;
    const auto close = [&] {
        if (together.empty())
            return;
        SampleSheet sheet = sheetOf(together, largestSide);
        if (sheet.height <= largestSide)
            sheets.push_back(std::move(sheet));
        else
            for (SampleWindow& window : together)
                sheets.push_back(sheetOf({std::move(window)}, largestSide));
        together.clear();
        samples = 0.0;
    };
    for (SampleWindow& window : windows) {
        const double own = samplesOf(window);
        if (samples + own > mostSamples)
            close();
        samples += own;
        together.push_back(std::move(window));
    }
    close();
    return sheets;
}

} // namespace irsg
