#include "irsg/image/IsoLines.h"

#include <array>
#include <cmath>

#include "irsg/core/Errors.h"
#include "irsg/image/AxisTicks.h"

namespace irsg {

namespace {

struct Point {
    double x = 0.0, y = 0.0;
};

/// Four neighbouring pixels, clockwise from the top left.
struct Cell {
    std::array<double, 4> values;
    std::array<Point, 4> corners;

    bool isWhole() const {
        for (const double value : values)
            if (!std::isfinite(value))
                return false;
        return true;
    }
    /// Where the side from corner `k` to the next has the level, which lies between their values.
    Point crossing(std::size_t k, double level) const {
        const std::size_t next = (k + 1) % 4;
        const double part = (level - values[k]) / (values[next] - values[k]);
        return {corners[k].x + part * (corners[next].x - corners[k].x),
                corners[k].y + part * (corners[next].y - corners[k].y)};
    }
};

void addSegments(const Cell& cell, double level, std::vector<IsoSegment>& segments) {
    std::array<std::size_t, 4> crossed{};
    std::size_t count = 0;
    for (std::size_t k = 0; k < 4; ++k)
        if ((cell.values[k] >= level) != (cell.values[(k + 1) % 4] >= level))
            crossed[count++] = k;
    const auto add = [&](std::size_t a, std::size_t b) {
        const Point from = cell.crossing(crossed[a], level), to = cell.crossing(crossed[b], level);
        if (from.x != to.x || from.y != to.y)
            segments.push_back({from.x, from.y, to.x, to.y});
    };
    if (count == 2)
        add(0, 1);
    if (count != 4)
        return;
    // A saddle: corners 1 and 3 are cut off where the middle is on the side of corners 0 and 2.
    const double middle =
        0.25 * (cell.values[0] + cell.values[1] + cell.values[2] + cell.values[3]);
    if ((middle >= level) == (cell.values[0] >= level)) {
        add(0, 1);
        add(2, 3);
    } else {
        add(3, 0);
        add(1, 2);
    }
}

} // namespace

std::vector<IsoSegment> isoLines(std::span<const float> values, int width, int height,
                                 double level) {
    if (width < 0 || height < 0 ||
        values.size() != static_cast<std::size_t>(width) * static_cast<std::size_t>(height))
        throw LogicError("lines of equal value in a plane of another size");
    std::vector<IsoSegment> segments;
    const auto at = [&](int x, int y) {
        return static_cast<double>(
            values[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                   static_cast<std::size_t>(x)]);
    };
    for (int y = 0; y + 1 < height; ++y)
        for (int x = 0; x + 1 < width; ++x) {
            const double left = x + 0.5, top = y + 0.5;
            const Cell cell{{at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)},
                            {{{left, top}, {left + 1, top}, {left + 1, top + 1}, {left, top + 1}}}};
            if (cell.isWhole())
                addSegments(cell, level, segments);
        }
    return segments;
}

std::vector<double> roundLevels(double low, double high, int wanted) {
    std::vector<double> levels;
    if (!(high > low) || !std::isfinite(high - low) || wanted < 1)
        return levels;
    const double step = roundStep((high - low) / wanted).first;
    for (double k = std::ceil(low / step); k * step <= high; k += 1.0)
        levels.push_back(k * step + 0.0); // no -0
    return levels;
}

} // namespace irsg
