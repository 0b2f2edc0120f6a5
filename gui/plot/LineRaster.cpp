#include "gui/plot/LineRaster.h"

#include <algorithm>
#include <cmath>

#include "gui/plot/CurveDrawing.h"
#include "gui/plot/Rounding.h"

namespace smat::gui {
namespace {

/// Cover of a pixel at a distance from the middle of a line that reaches so far.
std::uint8_t coverAt(float distance, float reach) {
    return static_cast<std::uint8_t>(std::clamp((reach - distance) * 255.0F + 0.5F, 0.0F, 255.0F));
}

} // namespace

LineRaster::LineRaster(QImage& picture, const QRect& clip, double width_px)
    : coverage_(picture, clip),
      origin_(QPointF(coverage_.clip().topLeft()) + QPointF(0.5, 0.5)),
      half_(static_cast<float>(0.5 * width_px)),
      reach_(half_ + 0.5F) {
    const double margin = static_cast<double>(reach_) + 2.0;
    reached_ = QRectF(coverage_.clip()).adjusted(-margin, -margin, margin, margin);
}

bool LineRaster::isSeen(const QPointF& point) const {
    return point.x() >= reached_.left() && point.x() <= reached_.right() &&
           point.y() >= reached_.top() && point.y() <= reached_.bottom();
}

bool LineRaster::isBeside(const QPointF& from, const QPointF& to) const {
    return std::max(from.x(), to.x()) < reached_.left() ||
           std::min(from.x(), to.x()) > reached_.right() ||
           std::max(from.y(), to.y()) < reached_.top() ||
           std::min(from.y(), to.y()) > reached_.bottom();
}

void LineRaster::add(const QPointF& from, const QPointF& to) {
    // What is far away is cut off where its end is not seen: small numbers are exact ones.
    QPointF a = from, b = to;
    if (isBeside(from, to))
        return;
    if (!isSeen(from) || !isSeen(to)) {
        const auto kept = insideOf(from, to, reached_);
        if (!kept)
            return;
        if (kept->from > 0.0)
            a = from + (to - from) * kept->from;
        if (kept->to < 1.0)
            b = from + (to - from) * kept->to;
    }
    a -= origin_;
    b -= origin_;
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

void LineRaster::cover(const Segment& segment) {
    const auto [ax, ay, bx, by] = segment;
    const int top = std::max(0, ceilOf(std::min(ay, by) - reach_));
    const int bottom = std::min(coverage_.height() - 1, floorOf(std::max(ay, by) + reach_));
    // Most segments of a restless line stand upright, and all rows between their ends are alike.
    const int high = std::max(top, ceilOf(std::min(ay, by)));
    const int low = std::min(bottom, floorOf(std::max(ay, by)));
    constexpr float upright = 0.5F;
    if (std::abs(bx - ax) > upright || high >= low) {
        coverRows(segment, top, bottom);
        return;
    }
    coverRows(segment, top, high - 1);
    coverRows(segment, low + 1, bottom);
    const float middle = 0.5F * (ax + bx);
    const int first = std::max(0, ceilOf(middle - reach_));
    const int last = std::min(coverage_.width() - 1, floorOf(middle + reach_));
    if (first > last)
        return;
    upright_.clear();
    for (int x = first; x <= last; ++x)
        upright_.push_back(coverAt(std::abs(static_cast<float>(x) - middle), reach_));
    const std::uint8_t* covers = upright_.data();
    const int count = last - first + 1;
    for (int y = high; y <= low; ++y) {
        std::uint8_t* row = coverage_.touch(y, first, last) + first;
        for (int i = 0; i < count; ++i)
            row[i] = std::max(row[i], covers[i]);
    }
}

void LineRaster::coverRows(const Segment& segment, int top, int bottom) {
    const auto [ax, ay, bx, by] = segment;
    const float dx = bx - ax, dy = by - ay;
    const float reach = reach_;
    const float length = std::sqrt(dx * dx + dy * dy);
    const float left = std::min(ax, bx) - reach, right = std::max(ax, bx) + reach;
    // How far along a row the line of a slope reaches to either side of its middle, and how much
    // nearer to the line each pixel is than the one on its left.
    const bool flat = std::abs(dy) < 1e-3F;
    const float perRow = flat ? 0.0F : dx / dy;
    const float across = flat ? 0.0F : reach * std::sqrt(1.0F + perRow * perRow);
    const float perColumn = length > 0.0F ? dy / length : 0.0F;
    const bool upright = std::abs(dx) < 1e-3F;
    const float perWidth = upright ? 0.0F : 1.0F / dx;
    // The rows all of whose pixels lie beside the segment.
    const float ends = flat ? 0.0F : across * std::abs(dx) / length * std::abs(perColumn);
    const float insideFrom = std::min(0.0F, dy) + ends, insideTo = std::max(0.0F, dy) - ends;

    for (int y = top; y <= bottom; ++y) {
        const float py = static_cast<float>(y) - ay;
        const float middle = ax + py * perRow;
        const float from = flat ? left : std::max(left, middle - across);
        const float to = flat ? right : std::min(right, middle + across);
        const int first = std::max(0, ceilOf(from));
        const int last = std::min(coverage_.width() - 1, floorOf(to));
        if (first > last)
            continue;
        std::uint8_t* row = coverage_.touch(y, first, last);

        // Pixels between the lines through the ends at right angles lie beside the segment, the
        // others around one of its ends.
        int besideFrom = first, besideTo = last;
        const bool inside = !flat && py >= insideFrom && py <= insideTo;
        if (!inside && !upright) {
            const float atA = ax - py * dy * perWidth, atB = bx - (py - dy) * dy * perWidth;
            const float low = std::max(std::min(atA, atB), left);
            const float high = std::min(std::max(atA, atB), right);
            besideFrom = low < to ? std::max(first, ceilOf(low)) : last + 1;
            besideTo = high > from ? std::min(last, floorOf(high)) : first - 1;
        } else if (!inside) {
            const bool besideAnEnd = length == 0.0F || py * dy < 0.0F || (py - dy) * dy > 0.0F;
            besideFrom = besideAnEnd ? last + 1 : first;
        }
        const auto coverAround = [&](int x0, int x1) {
            for (int x = x0; x <= x1; ++x) {
                const float px = static_cast<float>(x) - ax;
                const bool atEnd = px * dx + py * dy > 0.0F;
                const float ex = atEnd ? px - dx : px, ey = atEnd ? py - dy : py;
                row[x] = std::max(row[x], coverAt(std::sqrt(ex * ex + ey * ey), reach));
            }
        };
        if (besideFrom > besideTo) {
            coverAround(first, last);
            continue;
        }
        coverAround(first, besideFrom - 1);
        float beside = flat ? py : (static_cast<float>(besideFrom) - middle) * perColumn;
        for (int x = besideFrom; x <= besideTo; ++x, beside += perColumn)
            row[x] = std::max(row[x], coverAt(std::abs(beside), reach));
        coverAround(besideTo + 1, last);
    }
}

void LineRaster::paint(const QColor& color, const QRegion& region) {
    coverage_.paint(color, region);
    drawn_.reset();
}

} // namespace smat::gui
