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

class ImageCanvas;
class ProfilePanel;
struct IsoLine;

/// Lines over an image: the one along which it is profiled, and those of equal value (isotherms,
/// where temperatures are shown).
class ImageLines : public QObject {
    Q_OBJECT

  public:
    ImageLines(ImageCanvas& canvas, ProfilePanel& profile, QObject* parent);

    /// Buttons of a bar, and the field of the levels beside the second.
    QToolButton* profileButton() const { return profiles_; }
    QToolButton* isoButton() const { return isoLines_; }
    QLineEdit* levelsField() const { return levels_; }

    /// `plane` belongs to `image`; `title` is its quantity with unit.
    void show(std::shared_ptr<const irsg::RadianceImage> image, const irsg::ImageChannel& plane,
              const QString& title);
    /// Automatic levels are round numbers inside these.
    void setLimits(const irsg::DisplayLimits& limits);
    bool isBusy() const { return task_.isBusy(); }
    /// The lines of equal value upon a picture of the whole image, of any size.
    void drawOn(QImage& picture) const;

  private:
    void followProfile();
    void showProfile();
    void refreshIsoLines();
    /// Those that were typed, or automatic ones; none where the text is refused.
    std::vector<double> levels() const;

    ImageCanvas& canvas_;
    ProfilePanel& panel_;
    QToolButton *profiles_ = nullptr, *isoLines_ = nullptr;
    QLineEdit* levels_ = nullptr;
    std::shared_ptr<const irsg::RadianceImage> image_;
    const irsg::ImageChannel* plane_ = nullptr;
    QString title_;
    irsg::DisplayLimits limits_;
    LatestTask task_;
};

} // namespace smat::gui
