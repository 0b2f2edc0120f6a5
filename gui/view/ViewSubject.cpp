#include "gui/view/ViewSubject.h"

#include <algorithm>

#include <QString>

#include "gui/view/ViewHud.h"
#include "gui/widgets/NumberFormat.h"
#include "irsg/core/Errors.h"
#include "irsg/radiometry/Units.h"
#include "smatcore/project/EnvironmentInput.h"
#include "smatcore/project/ModelFields.h"
#include "smatcore/settings/SettingKeys.h"

namespace smat::gui {

void ViewSubject::setScene(DisplayScene scene) {
    scene_ = std::move(scene);
    // What is being edited stands in for files of the new models, too.
    for (const auto& [file, database] : edited_)
        scene_.setSignature(file, database);
}

bool ViewSubject::isOf(const Project& project, const Settings& settings) const {
    return project_ && *project_ == project && settings_ == settings;
}

void ViewSubject::setProject(const Project& project, const Settings& settings) {
    if (!project_ || *project_ != project)
        project_ = std::make_shared<const Project>(project);
    settings_ = settings;
    scene_.place(project, settings);
    frame_ = {irsg::radians(settings[key::sensorFov]), settings[key::sensorWidth],
              settings[key::sensorHeight]};
    targetYaw_rad_ = irsg::radians(settings[key::targetYaw]);
    const irsg::SunPosition sun = sunOf(project, settings);
    towardsSun_ = irsg::direction(sun.azimuth_rad, sun.elevation_rad);
}

bool ViewSubject::setEditedDatabase(const std::filesystem::path& file,
                                    std::shared_ptr<const irsg::SignatureDatabase> database) {
    const irsg::Vec3 referenceBefore = scene_.referencePoint_m;
    if (database) {
        edited_[file] = database;
        scene_.setSignature(file, database);
    } else if (edited_.erase(file) > 0) {
        // The file counts again; where it cannot be read, the renderer says so.
        std::shared_ptr<const irsg::SignatureDatabase> ofFile;
        try {
            ofFile = SceneBuilder().database(file);
        } catch (const irsg::InputError&) {
            ofFile = nullptr;
        }
        scene_.setSignature(file, std::move(ofFile));
    }
    return scene_.referencePoint_m != referenceBefore;
}

irsg::Viewpoint ViewSubject::viewpoint(const OrbitCamera& camera) const {
    return camera.viewpoint(scene_.referencePoint_m, targetYaw_rad_);
}

Settings ViewSubject::settingsWith(const OrbitCamera& camera) const {
    Settings shown = settings_;
    const auto rounded = [](double value) { return QString::number(value, 'f', 2).toStdString(); };
    shown.set(key::cameraAzimuth, rounded(camera.azimuth_deg));
    shown.set(key::cameraElevation, rounded(camera.elevation_deg));
    shown.set(key::cameraRange, rounded(camera.range_m));
    return shown;
}

std::optional<InfraredRequest> ViewSubject::request(const OrbitCamera& camera) const {
    if (!project_ || !hasModels())
        return std::nullopt;
    InfraredRequest request;
    request.project = project_;
    request.settings = settings_;
    request.edited = edited_;
    request.models = scene_.loaded;
    request.camera = camera;
    request.targetYaw_rad = targetYaw_rad_;
    return request;
}

PlaceHandles ViewSubject::handles() const {
    const std::size_t number = chosen_ < scene_.models.size() ? chosen_ : 0;
    const DisplayModel& chosen = scene_.models.at(number);
    PlaceHandles handles;
    handles.pose = chosen.pose;
    handles.length_m = 1.25 * std::max(chosen.reach_m, 1e-3);
    handles.shifts = number > 0;
    handles.name = chosen.name;
    return handles;
}

QString ViewSubject::fieldWords(const char* key) const {
    const ModelField* field = findModelField(key);
    if (!project_ || field == nullptr || chosen_ >= project_->models.size())
        return {};
    Project shown = *project_;
    shown.settings = settings_;
    const std::string text = smat::textOf(shown, chosen_, *field);
    const QString unit = formattedUnit(field->info.unit);
    return QStringLiteral("%1 %2%3").arg(QString::fromStdString(field->info.label).toLower(),
                                         QString::fromStdString(text),
                                         unit.isEmpty() || unit == "°" ? unit : " " + unit);
}

void ViewSubject::fill(ViewHud& hud) const {
    hud.frame = frame_;
    hud.towardsSun = towardsSun_;
    hud.hasProject = project_ != nullptr;
    hud.hasModel = hasModels();
    if (!hud.hasModel)
        return;
    hud.reference_m = scene_.referencePoint_m;
    hud.radius_m = scene_.radius_m;
    const DisplayModel& chosen = scene_.models[chosen_ < scene_.models.size() ? chosen_ : 0];
    hud.attitude = chosen.pose.attitude;
    if (&chosen != &scene_.models.front()) {
        hud.reference_m = chosen.pose.toWorld(chosen.centre_m);
        hud.radius_m = chosen.radius_m;
    }
}

} // namespace smat::gui
