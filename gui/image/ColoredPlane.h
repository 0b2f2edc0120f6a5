#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <QColor>
#include <QImage>

#include "irsg/image/ColorMap.h"
#include "irsg/image/RadianceImage.h"

class QPainter;

namespace smat::gui {

/// Values of a plane that several views share; the image they belong to is kept alive.
using SharedValues = std::shared_ptr<const std::vector<float>>;
SharedValues shareValues(std::shared_ptr<const irsg::RadianceImage> image,
                         const irsg::ImageChannel& plane);

/// A plane as a picture in false colours, with reduced copies for small views, so that drawing
/// costs what is seen and not what there is. Marked pixels have the colour of their mark at every
/// size, however far a view is reduced.
class ColoredPlane {
  public:
    /// Marks of pixels: none, or one of the colours below.
    enum Mark : std::uint8_t { unmarked, warned, failed };
    static QColor markColor(Mark mark);

    void setValues(int width, int height, SharedValues values);
    void setColors(const irsg::ColorMap& map, const irsg::DisplayLimits& limits);
    /// One for each pixel, or none at all. LogicError for another number.
    void setMarks(std::vector<std::uint8_t> marks);

    int width() const { return width_; }
    int height() const { return height_; }
    bool isEmpty() const { return width_ == 0; }
    float at(int x, int y) const;
    /// A colour a pixel.
    const QImage& picture() const;
    QColor colorAt(int x, int y) const { return picture().pixelColor(x, y); }

    /// Draws what lies inside `clip` of the plane laid over `target`, both in the painter's
    /// coordinates, of which `pixelRatio` device pixels make one. Enlarged pixels stay squares.
    void draw(QPainter& painter, const QRectF& target, const QRectF& clip, double pixelRatio) const;

  private:
    struct Level {
        QImage picture;
        std::vector<std::uint8_t> marks; ///< empty where nothing is marked
    };
    void recolor() const;
    const Level& level(std::size_t index) const;
    static Level halved(const Level& from);

    int width_ = 0, height_ = 0;
    SharedValues values_;
    std::vector<std::uint8_t> marks_;
    const irsg::ColorMap* map_ = nullptr;
    irsg::DisplayLimits limits_;
    mutable std::vector<Level> levels_; ///< made when they are first drawn
};

} // namespace smat::gui
