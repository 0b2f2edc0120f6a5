#pragma once

#include <cstdint>
#include <vector>

#include <QColor>
#include <QImage>
#include <QRect>
#include <QRegion>

namespace smat::gui {

/// How much of each pixel of a picture something covers that is drawn in one colour: what lines and
/// areas find out first, and what is then painted in one go, so that no pixel is coloured twice.
class Coverage {
  public:
    /// Whether pictures of this format can be drawn into: 32 bits a pixel, alpha premultiplied or
    /// none.
    static bool canDrawInto(const QImage& picture);

    /// Of the part of a picture that lies in `clip`, nothing being covered. LogicError for a
    /// picture that cannot be drawn into.
    Coverage(QImage& picture, const QRect& clip);

    /// The part that can be covered, in the coordinates of the picture.
    const QRect& clip() const { return clip_; }
    int width() const { return clip_.width(); }
    int height() const { return clip_.height(); }

    /// The covers of a row of the clip, 0 for a free pixel to 255 for a covered one. Those of the
    /// columns from `first` to `last` are about to be changed.
    std::uint8_t* touch(int y, int first, int last) {
        Columns& touched = rows_[static_cast<std::size_t>(y)];
        touched.first = touched.first < first ? touched.first : first;
        touched.last = touched.last > last ? touched.last : last;
        return covers_.data() + rowOffset(y);
    }
    /// Colours what is covered, within `region` of the picture, and forgets it.
    void paint(const QColor& color, const QRegion& region);

  private:
    std::size_t rowOffset(int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(clip_.width());
    }

    QImage& picture_;
    QRect clip_;
    std::vector<std::uint8_t>& covers_;
    struct Columns {
        int first, last;
    };
    std::vector<Columns> rows_; ///< of each row the columns that have any cover
};

} // namespace smat::gui
