#include "gui/plot/AreaRaster.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "gui/plot/Rounding.h"

namespace smat::gui {
namespace {

/// Zeros between two areas, kept so that a plot of many curves does not ask for memory for each.
std::vector<float>& sharedSteps() {
    thread_local std::vector<float> steps;
    return steps;
}

} // namespace

AreaRaster::AreaRaster(QImage& picture, const QRect& clip)
    : coverage_(picture, clip),
      steps_(sharedSteps()),
      // An edge along the right end steps in the column beyond, and in the one after it.
      stride_(static_cast<std::size_t>(coverage_.width() + 2)) {
    const auto rows = static_cast<std::size_t>(coverage_.height());
    if (steps_.size() < stride_ * rows)
        steps_.resize(stride_ * rows);
    rows_.assign(rows, {std::numeric_limits<int>::max(), -1});
}

void AreaRaster::add(const QPointF& from, const QPointF& to) {
    const QPointF a = from - coverage_.clip().topLeft(), b = to - coverage_.clip().topLeft();
    const bool down = a.y() < b.y();
    const QPointF& top = down ? a : b;
    const QPointF& low = down ? b : a;
    const double bottom = coverage_.height();
    const double right = coverage_.width();
    if (top.y() == low.y() || low.y() <= 0.0 || top.y() >= bottom ||
        std::min(top.x(), low.x()) >= right)
        return;
    const float way = down ? 1.0F : -1.0F;
    if (top.y() >= 0.0 && low.y() <= bottom && std::min(top.x(), low.x()) >= 0.0 &&
        std::max(top.x(), low.x()) <= right) {
        addInside(static_cast<float>(top.x()), static_cast<float>(top.y()),
                  static_cast<float>(low.x()), static_cast<float>(low.y()), way);
        return;
    }
    const double slope = (low.x() - top.x()) / (low.y() - top.y());
    const auto xAt = [&](double y) { return top.x() + (y - top.y()) * slope; };
    const double y0 = std::max(top.y(), 0.0), y1 = std::min(low.y(), bottom);
    addAcross(y0 > top.y() ? xAt(y0) : top.x(), y0, y1 < low.y() ? xAt(y1) : low.x(), y1, way);
}

void AreaRaster::addAcross(double x0, double y0, double x1, double y1, float way) {
    // What lies on the left of the clip covers its rows from their first pixel on, what lies on the
    // right of it none of them.
    const double right = coverage_.width();
    for (const double border : {0.0, right})
        if (std::min(x0, x1) < border && std::max(x0, x1) > border) {
            const double y = std::clamp(y0 + (border - x0) * (y1 - y0) / (x1 - x0), y0, y1);
            addAcross(x0, y0, border, y, way);
            addAcross(border, y, x1, y1, way);
            return;
        }
    if (std::min(x0, x1) >= right)
        return;
    const auto inside = [](double x) { return static_cast<float>(std::max(x, 0.0)); };
    addInside(inside(x0), static_cast<float>(y0), inside(x1), static_cast<float>(y1), way);
}

void AreaRaster::addInside(float x0, float y0, float x1, float y1, float way) {
    if (!(y1 > y0))
        return;
    const float slope = (x1 - x0) / (y1 - y0);
    const int last = std::min(coverage_.height(), ceilOf(y1));
    float x = x0;
    for (int y = static_cast<int>(y0); y < last; ++y) {
        // The piece of the edge in this row. Right of it all pixels are covered by its height, and
        // the pixels that it crosses by what lies right of it in them.
        const float from = std::max(y0, static_cast<float>(y));
        const float to = std::min(y1, static_cast<float>(y + 1));
        const float height = (to - from) * way;
        const float next =
            std::clamp(to == y1 ? x1 : x + (to - from) * slope, std::min(x0, x1), std::max(x0, x1));
        const float left = std::min(x, next), right = std::max(x, next);
        x = next;
        const int firstColumn = static_cast<int>(left);
        const int lastColumn = std::max(firstColumn, ceilOf(right) - 1);
        Columns& touched = rows_[static_cast<std::size_t>(y)];
        touched.first = std::min(touched.first, firstColumn);
        touched.last = std::max(touched.last, lastColumn + 1);
        float* steps = steps_.data() + static_cast<std::size_t>(y) * stride_;
        if (lastColumn == firstColumn) {
            const float beyond = 0.5F * (left + right) - static_cast<float>(firstColumn);
            steps[firstColumn] += height * (1.0F - beyond);
            steps[firstColumn + 1] += height * beyond;
            continue;
        }
        // In the first and the last pixel a triangle, in those between a step more each.
        const float perPixel = height / (right - left);
        const float inFirst = static_cast<float>(firstColumn + 1) - left;
        const float inLast = right - static_cast<float>(lastColumn);
        const float covered = 0.5F * inFirst * inFirst * perPixel;
        const float missing = 0.5F * inLast * inLast * perPixel;
        float before = 0.0F, now = covered;
        steps[firstColumn] += covered;
        for (int column = firstColumn + 1; column < lastColumn; ++column) {
            before = now;
            now = perPixel * (inFirst + static_cast<float>(column - firstColumn) - 0.5F);
            steps[column] += now - before;
        }
        steps[lastColumn] += height - missing - now;
        steps[lastColumn + 1] += missing;
    }
}

void AreaRaster::paint(const QColor& color, const QRegion& region) {
    const int width = coverage_.width();
    for (int y = 0; y < coverage_.height(); ++y) {
        Columns& row = rows_[static_cast<std::size_t>(y)];
        if (row.first > row.last)
            continue;
        float* steps = steps_.data() + static_cast<std::size_t>(y) * stride_;
        std::uint8_t* covers = coverage_.touch(y, row.first, row.first - 1);
        float covered = 0.0F;
        for (int x = row.first; x < width;) {
            covered += steps[x];
            int end = x + 1;
            while (end <= row.last && end < width && steps[end] == 0.0F)
                ++end;
            if (end > row.last)
                end = width;
            // Rounding leaves next to nothing where an outline has come round.
            const float share = std::min(std::abs(covered), 1.0F);
            if (const auto cover = static_cast<std::uint8_t>(share * 255.0F + 0.5F); cover != 0) {
                coverage_.touch(y, x, end - 1);
                std::memset(covers + x, cover, static_cast<std::size_t>(end - x));
            }
            x = end;
        }
        std::fill(steps + row.first, steps + row.last + 1, 0.0F);
        row = {std::numeric_limits<int>::max(), -1};
    }
    coverage_.paint(color, region);
}

} // namespace smat::gui
