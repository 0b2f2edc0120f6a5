#include "gui/scenario/PlaceFields.h"

#include <QGridLayout>
#include <QLabel>

#include "gui/widgets/NumberField.h"
#include "gui/widgets/NumberFormat.h"
#include "irsg/radiometry/Units.h"
#include "smatcore/simulate/Trajectory.h"

namespace smat::gui {
namespace {

constexpr std::size_t firstAngle = 3;

/// Without the rounding of radians.
double shownDegrees(double angle_rad) {
    return QString::number(irsg::degrees(angle_rad), 'g', 12).toDouble();
}

} // namespace

PlaceFields::PlaceFields(QWidget* parent) : QWidget(parent) {
    setObjectName("placeFields");
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    const QStringList tips{tr("East"),
                           tr("North"),
                           tr("Altitude of the origin"),
                           tr("Counter-clockwise from north"),
                           tr("Nose up"),
                           tr("Starboard down")};
    for (std::size_t i = 0; i < fields_.size(); ++i) {
        // Those of a trajectory behind its time.
        const TrajectoryColumn& column = TrajectoryTable::columns()[i + 1];
        const QString name = textOf(std::string(column.name));
        auto* field = new NumberField(formattedUnit(std::string(column.unit)), this);
        field->setObjectName("place." + name);
        field->setAccessibleName(name);
        field->setToolTip(tips[static_cast<int>(i)]);
        field->setRange(column.minimum, column.maximum);
        auto* label = new QLabel(name, this);
        label->setBuddy(field);
        fields_[i] = field;
        names_[i] = label;
        const int row = static_cast<int>(i % firstAngle);
        const int place = i < firstAngle ? 0 : 2;
        grid->addWidget(label, row, place);
        grid->addWidget(field, row, place + 1);
        connect(field, &NumberField::edited, this, [this, i, name](double value) {
            number(pose_, i) = i < firstAngle ? value : irsg::radians(value);
            emit edited(pose_, name);
        });
        connect(field, &NumberField::finished, this, &PlaceFields::finished);
    }
    grid->setColumnStretch(1, 1);
    grid->setColumnStretch(3, 1);
}

double& PlaceFields::number(irsg::Pose& pose, std::size_t field) {
    double* const numbers[] = {&pose.position_m.x,       &pose.position_m.y,
                               &pose.position_m.z,       &pose.attitude.yaw_rad,
                               &pose.attitude.pitch_rad, &pose.attitude.roll_rad};
    return *numbers[field];
}

void PlaceFields::setPose(const irsg::Pose& pose) {
    pose_ = pose;
    for (std::size_t i = 0; i < fields_.size(); ++i) {
        const double value = number(pose_, i);
        fields_[i]->setValue(i < firstAngle ? value : shownDegrees(value));
    }
}

void PlaceFields::showAttitude(bool isShown) {
    for (std::size_t i = firstAngle; i < fields_.size(); ++i) {
        fields_[i]->setVisible(isShown);
        names_[i]->setVisible(isShown);
    }
}

} // namespace smat::gui

#include "moc_PlaceFields.cpp"
