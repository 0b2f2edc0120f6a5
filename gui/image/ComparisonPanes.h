#pragma once

#include <array>
#include <memory>
#include <optional>

#include <QWidget>

#include "gui/image/ComparisonColors.h"
#include "irsg/image/ImageComparison.h"

class QCheckBox;
class QGridLayout;
class QHBoxLayout;
class QLabel;
class QSlider;

namespace smat::gui {

class ImageCanvas;

/// A plane of one of two images that are compared.
struct ComparedPlane {
    QString name; ///< of the image
    int width = 0, height = 0;
    SharedValues values; ///< null: there is none yet
};

/// Image A top left, B top right, their difference below, all at one zoom and one place, with one
/// cursor and one rectangle. Their colours are ComparisonColors. What is beside the difference is
/// somebody else's: companion().
class ComparisonPanes : public QWidget {
    Q_OBJECT

  public:
    explicit ComparisonPanes(QWidget* parent = nullptr);

    /// `title` is the quantity with its unit.
    void setPlanes(const ComparedPlane& a, const ComparedPlane& b, const QString& title);
    /// Null where there is none.
    void setDifference(SharedValues values, irsg::DifferenceMode mode, const QString& title);
    void setMarks(std::vector<std::uint8_t> marks);
    void setColorMap(const std::string& name) { colors_->setColorMap(name); }

    /// B in the place of A, while a key is held.
    void setFlicker(bool on);
    bool isFlickering() const { return flickering_; }
    void setWipe(bool on);
    bool isWiping() const;
    void fit();
    void showActualSize();
    /// Shows a pixel large, with the cursor on it.
    void goTo(const QPoint& pixel);

    ImageCanvas* canvas(int index) const { return canvases_[static_cast<std::size_t>(index)]; }
    ColorBar* sharedBar() const { return colors_->shared(); }
    ColorBar* differenceBar() const { return colors_->difference(); }
    /// The bar of the canvas that has the focus.
    ColorBar* activeBar() const;
    std::optional<irsg::PixelRectangle> selection() const;
    /// Box and slider of the line between A and B, for a bar of somebody else's.
    QWidget* wipeControl() const { return wipeControl_; }
    /// Puts a widget beside the difference, below B.
    void setCompanion(QWidget* companion);
    bool isBusy() const;

  signals:
    /// Limits of the difference's colours that were found.
    void differenceLimitsFound(const irsg::DisplayLimits& limits);
    void hovered(std::optional<QPoint> pixel);
    void selectionChanged();

  protected:
    void resizeEvent(QResizeEvent* event) override;

  private:
    QLabel* makeTitle(int index);
    /// Beside the difference, or below all where the page is narrow.
    void placeCompanion();
    void makeWipe();
    void link(ImageCanvas* canvas);
    void followColors();
    void showTitles();

    std::array<ImageCanvas*, 3> canvases_{};
    std::array<QLabel*, 3> titles_{};
    std::array<ComparedPlane, 2> planes_;
    bool hasDifference_ = false;
    irsg::DifferenceMode mode_ = irsg::DifferenceMode::signedDifference;
    ComparisonColors* colors_ = nullptr;
    QWidget* wipeControl_ = nullptr;
    QCheckBox* wipe_ = nullptr;
    QSlider* wipeAt_ = nullptr;
    QWidget* companion_ = nullptr;
    QHBoxLayout* besideDifference_ = nullptr;
    QGridLayout* grid_ = nullptr;
    bool flickering_ = false;
};

} // namespace smat::gui
