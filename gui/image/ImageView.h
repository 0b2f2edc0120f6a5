#pragma once

#include <optional>

#include <QWidget>

#include "irsg/image/ColorMap.h"
#include "irsg/image/RadianceImage.h"
#include "irsg/radiometry/Band.h"

class QComboBox;
class QLabel;

namespace smat::gui {

class ColorBar;
class ImageCanvas;

/// An infrared image: one of its planes in false colours beside the colour bar, a read-out of the
/// pixel under the mouse with all planes, and statistics of the image or of a dragged rectangle.
class ImageView : public QWidget {
    Q_OBJECT

  public:
    explicit ImageView(QWidget* parent = nullptr);

    /// With the band of a radiance image, apparent temperatures are shown, too. LogicError for an
    /// empty image.
    void setImage(irsg::RadianceImage image, const std::optional<irsg::Band>& band = {});
    const irsg::RadianceImage& image() const { return image_; }

    ImageCanvas* canvas() const { return canvas_; }
    ColorBar* colorBar() const { return colorBar_; }
    const irsg::ColorMap& colorMap() const { return *map_; }
    /// Name of the plane that is shown.
    const std::string& shownChannel() const { return plane().name; }
    void setColorMap(const std::string& name);
    /// "x 12  y 7   Radiance 1.234 W·m⁻²·sr⁻¹   Apparent temperature 301.2 K".
    QString readoutAt(int x, int y) const;
    QString statistics() const;

  private:
    void showPlane();
    void updateColors();
    const irsg::ImageChannel& plane() const;

    irsg::RadianceImage image_;
    const irsg::ColorMap* map_ = nullptr;
    ImageCanvas* canvas_ = nullptr;
    ColorBar* colorBar_ = nullptr;
    QComboBox* plane_ = nullptr;
    QComboBox* colors_ = nullptr;
    QLabel* readout_ = nullptr;
    QLabel* statistics_ = nullptr;
};

/// "Radiance" of channel L, "Apparent temperature", else the channel's own name in words.
QString planeTitle(const irsg::ImageChannel& channel);
/// "W m-2 sr-1" as "W·m⁻²·sr⁻¹".
QString readableUnit(const std::string& unit);

} // namespace smat::gui
