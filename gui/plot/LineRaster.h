#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <QPointF>
#include <QRectF>

#include "gui/plot/Coverage.h"

namespace smat::gui {

/// Draws one line into a picture pixel by pixel. What QPainter needs for a line grows faster than
/// its length, and a restless line covers most of its pixels many times: here a pixel is covered by
/// the nearest part of the line alone, once for all of its segments.
///
/// A segment that stays within half a pixel of one that was drawn just before is left out: a
/// restless line goes the same way up and down.
///
/// Ends and corners are round. Coordinates are those of the picture, a pixel being 1 wide with its
/// centre at 0.5. Lines are antialiased: of a pixel is covered what its distance from the middle of
/// the line says, exact but for corners of pixels.
class LineRaster {
  public:
    /// A line of `width_px`, of which what lies in `clip` is drawn. LogicError for a picture that
    /// Coverage cannot draw into.
    LineRaster(QImage& picture, const QRect& clip, double width_px);

    /// A segment; its ends are finite and may lie anywhere.
    void add(const QPointF& from, const QPointF& to);
    /// Colours what was added since the last time, within `region`.
    void paint(const QColor& color, const QRegion& region);

  private:
    struct Segment {
        float ax, ay, bx, by;
    };
    bool isSeen(const QPointF& point) const;
    /// Whether a segment lies on one side of all that is seen.
    bool isBeside(const QPointF& from, const QPointF& to) const;
    /// Whether it lies on what was drawn last.
    bool isCovered(const Segment& segment) const;
    void cover(const Segment& segment);
    void coverRows(const Segment& segment, int top, int bottom);

    Coverage coverage_;
    QPointF origin_;     ///< middle of the first pixel
    float half_, reach_; ///< half the width; how far from its middle the line colours pixels
    QRectF reached_;     ///< where what is drawn colours pixels of the clip
    std::vector<std::uint8_t> upright_; ///< covers of a row of a segment that stands upright
    std::optional<Segment> drawn_;      ///< the last one
};

} // namespace smat::gui
