#include "gui/scenario/MountFields.h"

#include <cmath>

#include <QComboBox>
#include <QFormLayout>

#include "gui/scenario/ScenarioParts.h"
#include "gui/widgets/NumberFormat.h"

namespace smat::gui {
namespace {

/// Entity numbers stand behind these.
enum Mount { still, trajectory, firstEntity };

/// To a nanometre: without the rounding of turning there and back.
irsg::Vec3 rounded(const irsg::Vec3& point) {
    const auto one = [](double value) { return std::round(value * 1e9) / 1e9; };
    return {one(point.x), one(point.y), one(point.z)};
}

} // namespace

MountFields::MountFields(QWidget* parent) : QWidget(parent) {
    auto* form = new QFormLayout(this);
    form->setContentsMargins(0, 0, 0, 0);
    const auto box = [&](const char* name, const QString& label, const QString& tip) {
        auto* made = new QComboBox(this);
        made->setObjectName(name);
        made->setAccessibleName(label);
        made->setToolTip(tip);
        form->addRow(label, made);
        return made;
    };
    mount_ = box("sensorMount", tr("Fixed to"),
                 tr("What the sensor stands on or rides on; it stays where it is at the start"));
    track_ = box("sensorTrack", tr("Looks at"),
                 tr("The reference point of an entity, wherever it goes, or along its own nose"));
    connect(mount_, &QComboBox::activated, this, &MountFields::changeMount);
    connect(track_, &QComboBox::activated, this, &MountFields::changeTrack);
}

void MountFields::show(const Scenario& scenario, std::size_t sensor) {
    sensor_ = sensor;
    const ScenarioSensor& shown = scenario.sensors.at(sensor);
    name_ = textOf(shown.name);
    mount_->clear();
    track_->clear();
    mount_->addItem(tr("The ground: stands still"), still);
    if (!shown.trajectory.empty())
        mount_->addItem(tr("Its trajectory, %1").arg(textOf(shown.trajectory)), trajectory);
    track_->addItem(tr("Along its own nose"));
    for (std::size_t i = 0; i < scenario.entities.size(); ++i) {
        const QString name = textOf(scenario.entities[i].name);
        mount_->addItem(tr("%1: rides on it").arg(name), firstEntity + static_cast<int>(i));
        track_->addItem(name);
    }
    const auto carrier = scenario.findEntity(shown.carrier);
    const int mount = shown.mount == MountKind::trajectory ? int{trajectory}
                      : shown.mount == MountKind::entity && carrier
                          ? firstEntity + static_cast<int>(*carrier)
                          : int{still};
    mount_->setCurrentIndex(mount_->findData(mount));
    const auto tracked = scenario.findEntity(shown.track);
    track_->setCurrentIndex(tracked ? static_cast<int>(*tracked) + 1 : 0);
}

void MountFields::changeMount(int chosen) {
    const int mount = mount_->itemData(chosen).toInt();
    emit edited(
        tr("Change what %1 is fixed to").arg(name_), [mount, at = sensor_](EditedScenario& to) {
            ScenarioSensor& sensor = to.scenario.sensors.at(at);
            const ScenarioSensor before = sensor;
            const irsg::Vec3 place_m = mountOf(to, before).toWorld(before.offset.position_m);
            sensor.carrier.clear();
            if (mount >= firstEntity) {
                sensor.mount = MountKind::entity;
                sensor.carrier =
                    to.scenario.entities.at(static_cast<std::size_t>(mount - firstEntity)).name;
            } else {
                sensor.mount = mount == trajectory ? MountKind::trajectory : MountKind::world;
            }
            if (sensor.mount != MountKind::trajectory) {
                sensor.trajectory.clear();
                sensor.hold = false;
            }
            if (sensor.mount == before.mount && sensor.carrier == before.carrier)
                return;
            const irsg::Pose axes = mountOf(to, sensor);
            sensor.offset.position_m =
                rounded(axes.attitude.rotation().transposed() * (place_m - axes.position_m));
        });
}

void MountFields::changeTrack(int chosen) {
    emit edited(tr("Change what %1 looks at").arg(name_), [chosen,
                                                           at = sensor_](EditedScenario& to) {
        ScenarioSensor& sensor = to.scenario.sensors.at(at);
        const std::string before = sensor.track;
        sensor.track =
            chosen == 0 ? "" : to.scenario.entities.at(static_cast<std::size_t>(chosen - 1)).name;
        // What it tracks says where it looks; on its own it looks on to where that was.
        sensor.offset.attitude = {};
        if (!sensor.track.empty() || before.empty())
            return;
        const irsg::Pose axes = mountOf(to, sensor);
        const irsg::Vec3 ahead = axes.attitude.rotation().transposed() *
                                     (poseAtStart(to, before).position_m - axes.position_m) -
                                 sensor.offset.position_m;
        if (irsg::length(ahead) > 0.0)
            sensor.offset.attitude = attitudeTowards(ahead);
    });
}

} // namespace smat::gui

#include "moc_MountFields.cpp"
