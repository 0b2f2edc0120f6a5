#include "gui/atmosphere/AtmosphereSight.h"

#include <cmath>

#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>

#include "gui/tools/TargetPoint.h"
#include "gui/widgets/NumberField.h"
#include "gui/workbench/Workbench.h"
#include "smatcore/project/EnvironmentInput.h"
#include "smatcore/tools/ViewerGeometry.h"

namespace smat::gui {
namespace {

constexpr double usualRange_m = 1000.0, usualAltitude_m = 100.0;

} // namespace

AtmosphereSight::AtmosphereSight(Workbench& workbench, QWidget* parent)
    : QWidget(parent), workbench_(workbench), targetPoint_(new TargetPoint(workbench, this)) {
    setObjectName("airSight");
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(8, 8, 8, 8);
    grid->setHorizontalSpacing(5);
    grid->setVerticalSpacing(4);
    ofProject_ = new QCheckBox(tr("Line of sight of the scene"), this);
    ofProject_->setObjectName("sightOfProject");
    ofProject_->setToolTip(tr("From the camera of the project to its target, as they are placed"));
    ofProject_->setChecked(true);
    grid->addWidget(ofProject_, 0, 0, 1, 7);
    sensor_ = addField("sightSensor", tr("From"), usualAltitude_m,
                       tr("Altitude of the sensor above the ground"));
    target_ = addField("sightTarget", tr("to"), usualAltitude_m,
                       tr("Altitude of the target above the ground"));
    range_ = addField("sightRange", tr("over"), usualRange_m, tr("From sensor to target"));
    connect(ofProject_, &QCheckBox::toggled, this, &AtmosphereSight::refresh);
    connect(targetPoint_, &TargetPoint::changed, this, &AtmosphereSight::refresh);
    connect(&workbench_, &Workbench::settingsChanged, this, &AtmosphereSight::refresh);
    grid->setColumnStretch(6, 1);
    refresh();
}

NumberField* AtmosphereSight::addField(const char* name, const QString& label, double value_m,
                                       const QString& tip) {
    auto* grid = dynamic_cast<QGridLayout*>(layout());
    auto* field = new NumberField("m", this);
    field->setObjectName(name);
    field->setAccessibleName(tip);
    field->setToolTip(tip);
    field->setRange(0.0, 1e7);
    field->setStep(100.0);
    field->setValue(value_m);
    field->setMinimumWidth(fontMetrics().horizontalAdvance("00000.0 m") + 10);
    auto* words = new QLabel(label, this);
    words->setBuddy(field);
    const int column = (grid->count() - 1) % 6;
    grid->addWidget(words, 1, column);
    grid->addWidget(field, 1, column + 1);
    connect(field, &NumberField::edited, this, &AtmosphereSight::changed);
    return field;
}

bool AtmosphereSight::isOfProject() const {
    return workbench_.hasProject() && ofProject_->isChecked();
}

bool AtmosphereSight::isBusy() const {
    return targetPoint_->isBusy();
}

void AtmosphereSight::refresh() {
    ofProject_->setEnabled(workbench_.hasProject());
    const bool isFixed = isOfProject();
    if (isFixed) {
        const PathGeometryInput shown = path();
        // To the centimetre, which no air tells apart.
        const auto show = [](NumberField* field, const std::optional<double>& value_m) {
            field->setValue(std::round(100.0 * value_m.value_or(0.0)) / 100.0);
            field->setCursorPosition(0);
        };
        show(sensor_, shown.sensorAltitude_m);
        show(target_, shown.targetAltitude_m);
        show(range_, shown.range_m);
    }
    for (NumberField* field : {sensor_, target_, range_})
        field->setEnabled(!isFixed);
    emit changed();
}

PathGeometryInput AtmosphereSight::path() const {
    if (isOfProject())
        // Bands do not matter, but a view has one.
        return viewerGeometry(workbench_.project(), eachBand(workbench_.settings()).front(),
                              targetPoint_->point_m().value_or(irsg::Vec3{}));
    return {.sensorAltitude_m = sensor_->value(),
            .targetAltitude_m = target_->value(),
            .range_m = range_->value()};
}

irsg::SunPosition AtmosphereSight::sun() const {
    return workbench_.hasProject() ? sunOf(workbench_.project(), workbench_.settings())
                                   : sunOf({}, {});
}

} // namespace smat::gui

#include "moc_AtmosphereSight.cpp"
