#pragma once

#include <array>

#include <QWidget>

#include "irsg/geometry/view/Pose.h"

class QLabel;

namespace smat::gui {

class NumberField;

/// Position and attitude of what does not move, in the units of trajectories.
class PlaceFields : public QWidget {
    Q_OBJECT

  public:
    explicit PlaceFields(QWidget* parent = nullptr);

    void setPose(const irsg::Pose& pose);
    /// Without an attitude where something else gives it.
    void showAttitude(bool isShown);

  signals:
    /// By the user: the place as it was but for one number. `what` is its name: "x".
    void edited(const irsg::Pose& pose, const QString& what);
    void finished();

  private:
    static double& number(irsg::Pose& pose, std::size_t field);

    irsg::Pose pose_;
    std::array<NumberField*, 6> fields_{};
    std::array<QLabel*, 6> names_{};
};

} // namespace smat::gui
