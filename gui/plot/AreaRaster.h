#pragma once

#include <vector>

#include <QPointF>

#include "gui/plot/Coverage.h"

namespace smat::gui {

/// Fills an area into a picture pixel by pixel, antialiased: of a pixel is covered what lies inside
/// of the outline, exactly but for pixels in which it crosses itself. What QPainter needs for an
/// outline grows faster than its number of edges; here it is the pixels that the edges cross and
/// those that are filled.
///
/// The outline may consist of several closed lines. Inside is what it goes round at least once,
/// whichever way; what it goes round once each way is outside. Coordinates are those of the
/// picture, a pixel being 1 wide.
class AreaRaster {
  public:
    /// Fills what lies in `clip`. LogicError for a picture that Coverage cannot draw into.
    AreaRaster(QImage& picture, const QRect& clip);

    /// An edge of the outline; its ends are finite and may lie anywhere.
    void add(const QPointF& from, const QPointF& to);
    /// Fills the outline that was added since the last time, within `region`.
    void paint(const QColor& color, const QRegion& region);

  private:
    /// Between the upper and lower end of the clip, and beside it.
    void addAcross(double x0, double y0, double x1, double y1, float way);
    /// Inside the clip.
    void addInside(float x0, float y0, float x1, float y1, float way);

    Coverage coverage_;
    /// By how much more each pixel is covered than the one on its left, and of each row the columns
    /// where that is not 0.
    std::vector<float>& steps_;
    std::size_t stride_;
    struct Columns {
        int first, last;
    };
    std::vector<Columns> rows_;
};

} // namespace smat::gui
