#pragma once

#include <memory>
#include <vector>

#include <QObject>

#include "gui/widgets/LatestTask.h"
#include "irsg/image/DisplayLimits.h"
#include "irsg/image/RadianceImage.h"

class QImage;
class QLineEdit;
class QToolButton;

namespace smat::gui {

class HotSpotsPanel;
class ImageCanvas;
class ProfilePanel;
struct IsoLine;

/// Marks over an image: the line along which it is profiled, lines of equal value (isotherms, where
/// temperatures are shown), and its hottest spots.
class ImageLines : public QObject {
    Q_OBJECT

  public:
    ImageLines(ImageCanvas& canvas, ProfilePanel& profile, HotSpotsPanel& spots, QObject* parent);

    /// Buttons of a bar, and the field of the levels beside the second.
    QToolButton* profileButton() const { return profiles_; }
    QToolButton* isoButton() const { return isoLines_; }
    QToolButton* spotsButton() const { return spots_; }
    QLineEdit* levelsField() const { return levels_; }

    /// `plane` belongs to `image`; `title` is its quantity with unit.
    void show(std::shared_ptr<const irsg::RadianceImage> image, const irsg::ImageChannel& plane,
              const QString& title);
    /// Automatic levels are round numbers inside these.
    void setLimits(const irsg::DisplayLimits& limits);
    bool isBusy() const { return task_.isBusy() || spotsTask_.isBusy(); }
    /// The lines of equal value upon a picture of the whole image, of any size.
    void drawOn(QImage& picture) const;

  private:
    void followProfile();
    void showProfile();
    void refreshIsoLines();
    void refreshSpots();
    /// Those that were typed, or automatic ones; none where the text is refused.
    std::vector<double> levels() const;

    ImageCanvas& canvas_;
    ProfilePanel& panel_;
    HotSpotsPanel& spotsPanel_;
    QToolButton *profiles_ = nullptr, *isoLines_ = nullptr, *spots_ = nullptr;
    QLineEdit* levels_ = nullptr;
    std::shared_ptr<const irsg::RadianceImage> image_;
    const irsg::ImageChannel* plane_ = nullptr;
    QString title_;
    irsg::DisplayLimits limits_;
    LatestTask task_, spotsTask_;
};

} // namespace smat::gui
