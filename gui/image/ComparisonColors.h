#pragma once

#include <array>
#include <functional>

#include <QObject>

#include "gui/image/ColorBar.h"
#include "gui/image/ColoredPlane.h"
#include "gui/widgets/LatestTask.h"
#include "irsg/image/ImageComparison.h"

namespace smat::gui {

/// The colours of a comparison and their bars: A and B share a map and limits, their difference has
/// its own. Limits of large planes are found off this thread.
class ComparisonColors : public QObject {
    Q_OBJECT

  public:
    /// The bars belong to `panes`.
    explicit ComparisonColors(QWidget* panes);

    ColorBar* shared() const { return shared_; }
    ColorBar* difference() const { return difference_; }
    /// Null where there is none.
    void setPlanes(const std::array<SharedValues, 2>& planes, const QString& title);
    void setDifference(SharedValues values, irsg::DifferenceMode mode, const QString& title);
    /// Of A and B, and of differences without a sign.
    void setColorMap(const std::string& name);
    bool isBusy() const { return sharedTask_.isBusy() || differenceTask_.isBusy(); }

  signals:
    /// Limits are being found: what is there has none until then.
    void sharedAwaited();
    void differenceAwaited();
    void sharedFound(const irsg::ColorMap& map, const irsg::DisplayLimits& limits);
    void differenceFound(const irsg::ColorMap& map, const irsg::DisplayLimits& limits);

  private:
    void findShared();
    void findDifference();
    void useShared(const FoundLimits& found);
    void useDifference(const FoundLimits& found);

    std::array<SharedValues, 2> planes_;
    SharedValues differenceValues_;
    irsg::DifferenceMode mode_ = irsg::DifferenceMode::signedDifference;
    const irsg::ColorMap* map_ = nullptr;
    ColorBar* shared_ = nullptr;
    ColorBar* difference_ = nullptr;
    LatestTask sharedTask_, differenceTask_;
};

} // namespace smat::gui
