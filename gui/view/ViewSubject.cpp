#include "gui/view/ViewSubject.h"

#include <QString>

#include "gui/view/ViewHud.h"
#include "irsg/radiometry/Errors.h"
#include "irsg/radiometry/Units.h"
#include "smatcore/project/EnvironmentInput.h"
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
    scene_.placeTarget(targetPoseOf(settings));
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

void ViewSubject::fill(ViewHud& hud) const {
    hud.frame = frame_;
    hud.towardsSun = towardsSun_;
    hud.hasProject = project_ != nullptr;
    hud.hasModel = hasModels();
    if (!hud.hasModel)
        return;
    hud.reference_m = scene_.referencePoint_m;
    hud.attitude = scene_.models.front().pose.attitude;
    hud.radius_m = scene_.radius_m;
}

} // namespace smat::gui
