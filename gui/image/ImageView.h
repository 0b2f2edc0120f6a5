#pragma once

#include <memory>
#include <optional>

#include <QWidget>

#include "gui/image/ImageExport.h"
#include "gui/image/PixelPanel.h"
#include "gui/widgets/Dialogs.h"
#include "gui/widgets/DisplayUnits.h"
#include "gui/widgets/Exportable.h"
#include "gui/widgets/LatestTask.h"
#include "irsg/image/ColorMap.h"
#include "irsg/image/RadianceImage.h"
#include "irsg/image/SampledTiles.h"
#include "irsg/radiometry/Band.h"

class QComboBox;
class QHBoxLayout;
class QLabel;
class QToolButton;

namespace smat::gui {

class ColorBar;
class HotSpotsPanel;
class ImageCanvas;
class ImageInspector;
class ImageLines;
class IndexLegend;
class ProfilePanel;
struct FoundLimits;
struct PlaneFigures;

/// An infrared image: one of its planes in false colours beside the colour bar, a read-out of the
/// pixel under the mouse with all planes, histogram and statistics of the image or of a dragged
/// rectangle. Everything has a key, see imageKeys().
class ImageView : public QWidget, public Exportable {
    Q_OBJECT

  public:
    explicit ImageView(QWidget* parent = nullptr, Dialogs dialogs = Dialogs::ofDesktop());

    /// With the band of a radiance image, apparent temperatures are shown, too; those of a large
    /// image follow when they are worked out. LogicError for an empty image.
    void setImage(std::shared_ptr<const irsg::RadianceImage> image,
                  const std::optional<irsg::Band>& band = {});
    void setImage(irsg::RadianceImage image, const std::optional<irsg::Band>& band = {});
    /// The next of a row of images: plane, zoom, rectangle and limits that were chosen stay as they
    /// are, and the last picture stands until this one has its colours.
    void setFrame(std::shared_ptr<const irsg::RadianceImage> image);
    bool hasImage() const { return given_ != nullptr; }
    /// In its own units, whatever it is shown in.
    const irsg::RadianceImage& image() const { return *given_; }
    /// A line over exported pictures, and the name that is suggested for files.
    void setTitle(const QString& title) { title_ = title; }
    /// A line over the image: band, range, aspect, ...; none where it is empty.
    void setConditions(const QString& conditions);
    void setDialogs(Dialogs dialogs) { dialogs_ = std::move(dialogs); }

    /// How to explain the pixels of the image; without it there is no such button.
    void setExplainer(PixelPanel::Maker maker);
    PixelPanel* pixelPanel() const { return pixels_; }

    ImageCanvas* canvas() const { return canvas_; }
    ColorBar* colorBar() const { return colorBar_; }
    ImageInspector* inspector() const { return inspector_; }
    ProfilePanel* profile() const { return profile_; }
    HotSpotsPanel* hotSpots() const { return hotSpots_; }
    /// In place of the colour bar where the plane has indices.
    IndexLegend* indexLegend() const { return legend_; }
    const irsg::ColorMap& colorMap() const { return *map_; }
    void setColorScale(irsg::ColorScale scale, bool marksOutside = false);
    /// A picture in visible light, in its own colours.
    bool showsColors() const;
    /// A plane of indices, in a colour for each.
    bool showsIndices() const;
    /// Name of the plane that is shown; of a picture in its own colours that of its luminance.
    const std::string& shownChannel() const { return plane().name; }
    void setColorMap(const std::string& name);
    /// The values that have the first and the last colour, in the plane's own unit, as if they were
    /// typed into the bar; what
    /// is not given stays, and nothing changes where they do not ascend.
    void setLimits(std::optional<double> low, std::optional<double> high);
    void setShownPlane(int index);
    /// "x 12  y 7   Radiance 1.234 W·m⁻²·sr⁻¹   Apparent temperature 301.2 K".
    QString readoutAt(int x, int y) const;
    /// Marks a pixel and reads it, as the mouse over it does; none.
    void readPixel(const std::optional<QPoint>& pixel);
    QString statistics() const;
    bool isBusy() const;

    QStringList exportFilters() const override;
    /// .exr with all planes, .csv with the one that is shown, .png as it is seen, with colour bar.
    void exportTo(const std::filesystem::path& file) const override;
    /// The shown plane in its colours and limits; with a bar, title and unit as well.
    /// With title, conditions and colour bar, as it is exported, or the plane alone.
    QImage picture(bool withColorBar) const;
    void copyPicture(bool withColorBar) const;
    /// The values of the rectangle, or of the whole plane, as text.
    void copyValues() const;

  protected:
    void focusInEvent(QFocusEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

  private:
    QHBoxLayout* makeBar();
    void connectParts();
    /// Where a page is so low that it would scroll, the other parts below the image make way for
    /// the one that was switched on.
    void makeRoomFor(QToolButton* part);
    void explainAt(const QPoint& pixel);
    void showPlane();
    void tellPixel(const std::optional<QPoint>& pixel);
    void markIndex(const std::optional<QPoint>& pixel);
    void updateColors();
    void recolor();
    /// Of the plane that is shown, or only what lies outside of `known` ones.
    void findLimits(const std::optional<irsg::DisplayLimits>& known);
    void useLimits(const FoundLimits& found);
    void updateStatistics();
    /// What the antialiasing sampled by itself; nothing in an image that does not tell.
    void outlineTiles();
    /// Of the finest window that touches a pixel; empty where none does.
    QString windowWords(int x, int y) const;
    void adopt(std::shared_ptr<const irsg::RadianceImage> image);
    void write(const std::filesystem::path& file, bool withColorBar) const;
    void askAndExport(const QString& filter, bool withColorBar);
    QString statisticsText(const std::optional<irsg::PixelRectangle>& selection,
                           const PlaneFigures& figures) const;
    const irsg::ImageChannel& plane() const;
    const irsg::ImageChannel& givenPlane() const;
    void takeUnits();
    /// Of the image as it is shown.
    void fillPlanes();

    Dialogs dialogs_;
    std::shared_ptr<const irsg::RadianceImage> given_, image_; ///< that in shown units
    DisplayUnits shownIn_;
    QString title_;
    const irsg::ColorMap* map_ = nullptr;
    ImageCanvas* canvas_ = nullptr;
    ColorBar* colorBar_ = nullptr;
    IndexLegend* legend_ = nullptr;
    ImageInspector* inspector_ = nullptr;
    PixelPanel* pixels_ = nullptr;
    ProfilePanel* profile_ = nullptr;
    HotSpotsPanel* hotSpots_ = nullptr;
    ImageLines* lines_ = nullptr;
    QComboBox* plane_ = nullptr;
    QComboBox* colors_ = nullptr;
    QToolButton* histogram_ = nullptr;
    QToolButton* tilesShown_ = nullptr;
    QToolButton* explains_ = nullptr;
    std::vector<irsg::SampledTile> windows_;
    QLabel* conditions_ = nullptr;
    QLabel* readout_ = nullptr;
    QLabel* statistics_ = nullptr;
    LatestTask figuresTask_, temperatureTask_, limitsTask_;
};

/// Keys of images and what they do, as a list of keys and mouse shows them.
QList<std::pair<QString, QString>> imageKeys();

} // namespace smat::gui
