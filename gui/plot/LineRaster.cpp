#include "gui/plot/LineRaster.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "gui/plot/CurveDrawing.h"
#include "irsg/radiometry/Errors.h"

namespace smat::gui {
namespace {

/// Zeros between two lines, kept so that a plot of many curves does not ask for memory for each.
std::vector<std::uint8_t>& sharedCovers() {
    thread_local std::vector<std::uint8_t> covers;
    return covers;
}

/// a · b / 255, rounded.
std::uint32_t part(std::uint32_t a, std::uint32_t b) {
    const std::uint32_t product = a * b + 128U;
    return (product + (product >> 8U)) >> 8U;
}

} // namespace

bool LineRaster::canDrawInto(const QImage& picture) {
    return picture.format() == QImage::Format_RGB32 ||
           picture.format() == QImage::Format_ARGB32_Premultiplied;
}

LineRaster::LineRaster(QImage& picture, const QRect& clip, double width_px)
    : picture_(picture),
      clip_(clip & picture.rect()),
      half_(static_cast<float>(0.5 * width_px)),
      reach_(half_ + 0.5F),
      covers_(sharedCovers()) {
    if (!canDrawInto(picture))
        throw irsg::LogicError("lines cannot be drawn into a picture of this format");
    const auto pixels = static_cast<std::size_t>(std::max(0, clip_.width())) *
                        static_cast<std::size_t>(std::max(0, clip_.height()));
    if (covers_.size() < pixels)
        covers_.resize(pixels);
    rows_.assign(static_cast<std::size_t>(std::max(0, clip_.height())),
                 {std::numeric_limits<int>::max(), -1});
}

void LineRaster::add(const QPointF& from, const QPointF& to) {
    // What is far away is cut off where its end is not seen: small numbers are exact ones.
    const double margin = static_cast<double>(reach_) + 2.0;
    const QRectF area = QRectF(clip_).adjusted(-margin, -margin, margin, margin);
    const bool whole = area.contains(from) && area.contains(to);
    const auto kept = whole ? std::optional(Part{}) : insideOf(from, to, area);
    if (!kept)
        return;
    const QPointF origin = QPointF(clip_.topLeft()) + QPointF(0.5, 0.5);
    const QPointF way = to - from;
    const QPointF a = (kept->from > 0.0 ? from + way * kept->from : from) - origin;
    const QPointF b = (kept->to < 1.0 ? from + way * kept->to : to) - origin;
    const Segment segment{static_cast<float>(a.x()), static_cast<float>(a.y()),
                          static_cast<float>(b.x()), static_cast<float>(b.y())};
    if (isCovered(segment))
        return;
    cover(segment);
    drawn_ = segment;
}

bool LineRaster::isCovered(const Segment& segment) const {
    if (!drawn_)
        return false;
    // Beside a long segment the width of a line is room for half of the width between two.
    constexpr float around2 = 0.5F * 0.5F, beside2 = 1.0F, long2 = 4.0F * 4.0F;
    const float dx = drawn_->bx - drawn_->ax, dy = drawn_->by - drawn_->ay;
    const float length2 = dx * dx + dy * dy;
    const auto isNear = [&](float x, float y) {
        const float px = x - drawn_->ax, py = y - drawn_->ay;
        const float along = length2 > 0.0F ? (px * dx + py * dy) / length2 : 0.0F;
        const float on = std::clamp(along, 0.0F, 1.0F);
        const float ex = px - on * dx, ey = py - on * dy;
        return ex * ex + ey * ey <= (along == on && length2 > long2 ? beside2 : around2);
    };
    return isNear(segment.bx, segment.by) && isNear(segment.ax, segment.ay);
}

std::uint8_t LineRaster::coverAt(float distance) const {
    return static_cast<std::uint8_t>(std::clamp((reach_ - distance) * 255.0F + 0.5F, 0.0F, 255.0F));
}

std::uint8_t* LineRaster::touch(int y, int first, int last) {
    Columns& touched = rows_[static_cast<std::size_t>(y)];
    touched.first = std::min(touched.first, first);
    touched.last = std::max(touched.last, last);
    return covers_.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(clip_.width());
}

void LineRaster::cover(const Segment& segment) {
    const auto [ax, ay, bx, by] = segment;
    const int top = std::max(0, static_cast<int>(std::ceil(std::min(ay, by) - reach_)));
    const int bottom =
        std::min(clip_.height() - 1, static_cast<int>(std::floor(std::max(ay, by) + reach_)));
    // Most segments of a restless line stand upright, and all rows between their ends are alike.
    const int high = std::max(top, static_cast<int>(std::ceil(std::min(ay, by))));
    const int low = std::min(bottom, static_cast<int>(std::floor(std::max(ay, by))));
    constexpr float upright = 0.5F;
    if (std::abs(bx - ax) > upright || high >= low) {
        coverRows(segment, top, bottom);
        return;
    }
    coverRows(segment, top, high - 1);
    coverRows(segment, low + 1, bottom);
    const float middle = 0.5F * (ax + bx);
    const int first = std::max(0, static_cast<int>(std::ceil(middle - reach_)));
    const int last = std::min(clip_.width() - 1, static_cast<int>(std::floor(middle + reach_)));
    if (first > last)
        return;
    upright_.clear();
    for (int x = first; x <= last; ++x)
        upright_.push_back(coverAt(std::abs(static_cast<float>(x) - middle)));
    const std::uint8_t* covers = upright_.data();
    const int count = last - first + 1;
    for (int y = high; y <= low; ++y) {
        std::uint8_t* row = touch(y, first, last) + first;
        for (int i = 0; i < count; ++i)
            row[i] = std::max(row[i], covers[i]);
    }
}

void LineRaster::coverRows(const Segment& segment, int top, int bottom) {
    const auto [ax, ay, bx, by] = segment;
    const float dx = bx - ax, dy = by - ay;
    const float length2 = dx * dx + dy * dy;
    const float perLength2 = length2 > 0.0F ? 1.0F / length2 : 0.0F;
    const float perLength = std::sqrt(perLength2);
    const float left = std::min(ax, bx) - reach_, right = std::max(ax, bx) + reach_;
    // How far along a row the line of a slope reaches to either side of its middle.
    const bool flat = std::abs(dy) < 1e-3F;
    const float perRow = flat ? 0.0F : dx / dy;
    const float across = flat ? 0.0F : reach_ * std::sqrt(1.0F + perRow * perRow);

    for (int y = top; y <= bottom; ++y) {
        const float py = static_cast<float>(y) - ay;
        const float middle = ax + py * perRow;
        const float from = flat ? left : std::max(left, middle - across);
        const float to = flat ? right : std::min(right, middle + across);
        const int first = std::max(0, static_cast<int>(std::ceil(from)));
        const int last = std::min(clip_.width() - 1, static_cast<int>(std::floor(to)));
        if (first > last)
            continue;
        std::uint8_t* row = touch(y, first, last);

        // Where along the segment the ends of the row lie: beside it, or around one of its ends.
        const float firstX = static_cast<float>(first) - ax, lastX = static_cast<float>(last) - ax;
        const float atFirst = (firstX * dx + py * dy) * perLength2;
        const float atLast = (lastX * dx + py * dy) * perLength2;
        if (length2 > 0.0F && std::min(atFirst, atLast) >= 0.0F &&
            std::max(atFirst, atLast) <= 1.0F) {
            const float step = dy * perLength;
            float beside = (firstX * dy - py * dx) * perLength;
            for (int x = first; x <= last; ++x, beside += step)
                row[x] = std::max(row[x], coverAt(std::abs(beside)));
            continue;
        }
        for (int x = first; x <= last; ++x) {
            const float px = static_cast<float>(x) - ax;
            const float along = std::clamp((px * dx + py * dy) * perLength2, 0.0F, 1.0F);
            const float ex = px - along * dx, ey = py - along * dy;
            row[x] = std::max(row[x], coverAt(std::sqrt(ex * ex + ey * ey)));
        }
    }
}

void LineRaster::paint(const QColor& color, const QRegion& region) {
    for (const QRect& rectangle : region) {
        const QRect seen = (rectangle & clip_).translated(-clip_.topLeft());
        for (int y = seen.top(); y <= seen.bottom(); ++y) {
            const Columns touched = rows_[static_cast<std::size_t>(y)];
            blend(y, std::max(touched.first, seen.left()), std::min(touched.last, seen.right()),
                  color);
        }
    }
    for (int y = 0; y < clip_.height(); ++y) {
        Columns& touched = rows_[static_cast<std::size_t>(y)];
        if (touched.first <= touched.last) {
            std::uint8_t* row = covers_.data() + static_cast<std::size_t>(y) *
                                                     static_cast<std::size_t>(clip_.width());
            std::fill(row + touched.first, row + touched.last + 1, std::uint8_t(0));
        }
        touched = {std::numeric_limits<int>::max(), -1};
    }
    drawn_.reset();
}

void LineRaster::blend(int y, int from, int to, const QColor& color) {
    const std::uint8_t* covers =
        covers_.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(clip_.width());
    auto* pixels = reinterpret_cast<QRgb*>(picture_.scanLine(clip_.top() + y)) + clip_.left();
    const QRgb opaque = color.rgb();
    const auto alpha = static_cast<std::uint32_t>(color.alpha());
    const auto red = static_cast<std::uint32_t>(color.red());
    const auto green = static_cast<std::uint32_t>(color.green());
    const auto blue = static_cast<std::uint32_t>(color.blue());
    for (int x = from; x <= to; ++x) {
        if (covers[x] == 0)
            continue;
        const std::uint32_t over = alpha == 255U ? covers[x] : part(covers[x], alpha);
        if (over == 255U) {
            pixels[x] = opaque;
            continue;
        }
        const std::uint32_t under = 255U - over;
        const QRgb below = pixels[x];
        pixels[x] = (over + part((below >> 24U) & 0xFFU, under)) << 24U |
                    (part(red, over) + part((below >> 16U) & 0xFFU, under)) << 16U |
                    (part(green, over) + part((below >> 8U) & 0xFFU, under)) << 8U |
                    (part(blue, over) + part(below & 0xFFU, under));
    }
}

} // namespace smat::gui
