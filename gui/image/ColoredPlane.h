#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
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

/// Red, green and blue of a picture in visible light, linear.
using LightPlanes = std::array<SharedValues, 3>;

/// Pixels up to which what is derived of an image is worked out at once; above it is done in
/// another thread, while the window goes on with what it showed.
inline constexpr std::size_t quickPixels = 512 * 512;

/// A plane as a picture in false colours, with reduced copies for small views, so that drawing
/// costs what is seen and not what there is. Marked pixels have the colour of their mark at every
/// size, however far a view is reduced. Copies share what they are made of: another thread may
/// colour a copy.
class ColoredPlane {
  public:
    /// Marks of pixels: none, or one of the colours below.
    enum Mark : std::uint8_t { unmarked, warned, failed };
    static QColor markColor(Mark mark);

    void setValues(int width, int height, SharedValues values);
    /// The picture is in the colours of these planes, between the same limits, rather than in those
    /// of a map; until the next setValues. LogicError for planes of another size.
    void setLight(const LightPlanes& light);
    void setColors(const irsg::ColorMap& map, const irsg::DisplayLimits& limits);
    /// One for each pixel, or none at all. LogicError for another number.
    void setMarks(std::vector<std::uint8_t> marks);

    int width() const { return width_; }
    int height() const { return height_; }
    bool isEmpty() const { return width_ == 0; }
    std::size_t pixelCount() const { return values_ ? values_->size() : 0; }
    float at(int x, int y) const;
    /// Whether values, colours or marks have changed since the picture was made.
    bool isStale() const { return stale_ && !isEmpty(); }
    /// Makes the picture and its reduced copies. LogicError without values or colours.
    void color() const;
    /// A colour a pixel, made now where it is stale.
    const QImage& picture() const;
    QColor colorAt(int x, int y) const { return picture().pixelColor(x, y); }
    /// The colour a pixel is drawn in, stale or not; none before it is first coloured.
    QColor shownColorAt(int x, int y) const;
    /// Nothing is drawn until the plane is coloured anew: what was is of another image.
    void forgetPicture();
    bool hasPicture() const { return levels_ != nullptr; }
    /// Draws the picture of another plane of the same size until this one is coloured.
    void showPictureOf(const ColoredPlane& other);

    /// Draws what lies inside `clip` of the plane laid over `target`, both in the painter's
    /// coordinates, of which `pixelRatio` device pixels make one. Enlarged pixels stay squares. A
    /// stale picture is drawn as it is, nothing where there is none.
    void draw(QPainter& painter, const QRectF& target, const QRectF& clip, double pixelRatio) const;

  private:
    struct Level {
        QImage picture;
        std::vector<std::uint8_t> marks; ///< empty where nothing is marked
    };
    Level colored() const;
    QImage falseColors() const;
    QImage lightColors() const;
    static Level halved(const Level& from);

    int width_ = 0, height_ = 0;
    SharedValues values_;
    std::optional<LightPlanes> light_;
    std::shared_ptr<const std::vector<std::uint8_t>> marks_; ///< null for none
    const irsg::ColorMap* map_ = nullptr;
    irsg::DisplayLimits limits_;
    mutable bool stale_ = false;
    /// The picture and its halves down to one pixel; empty before it is first coloured.
    mutable std::shared_ptr<const std::vector<Level>> levels_;
};

} // namespace smat::gui
