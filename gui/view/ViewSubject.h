#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include <QString>

#include "gui/view/DisplayScene.h"
#include "gui/view/InfraredRequest.h"
#include "gui/view/PlaceHandles.h"
#include "gui/view/ViewProjection.h"

namespace smat::gui {

struct ViewHud;

/// What a view shows: the models of a project where they stand, the frame of its sensor, its sun,
/// and the databases that stand in for files. Knows neither how it is drawn nor who moves.
class ViewSubject {
  public:
    DisplayScene& scene() { return scene_; }
    const DisplayScene& scene() const { return scene_; }
    bool hasModels() const { return !scene_.models.empty(); }
    void setScene(DisplayScene scene);
    bool isOf(const Project& project, const Settings& settings) const;
    void setProject(const Project& project, const Settings& settings);
    const ViewFrame& frame() const { return frame_; }
    /// Null for the file again. Whether the point that cameras turn about moved with it.
    bool setEditedDatabase(const std::filesystem::path& file,
                           std::shared_ptr<const irsg::SignatureDatabase> database);

    /// Where a camera of the view stands.
    irsg::Viewpoint viewpoint(const OrbitCamera& camera) const;
    /// Settings of the project, with another camera.
    Settings settingsWith(const OrbitCamera& camera) const;
    /// Of all that is not the view's own; nothing without models or a project.
    std::optional<InfraredRequest> request(const OrbitCamera& camera) const;
    void fill(ViewHud& hud) const;
    /// The model that is meant where one of them is; the target where there is no such.
    void setChosen(std::size_t model) { chosen_ = model; }
    std::size_t chosen() const { return chosen_; }
    /// To place it by. LogicError of the standard library where there are no models.
    PlaceHandles handles() const;
    /// "east 312.5 m" of it, for the key of a ModelField.
    QString fieldWords(const char* key) const;

  private:
    DisplayScene scene_;
    std::shared_ptr<const Project> project_;
    Settings settings_;
    SceneBuilder::DatabaseOverrides edited_;
    std::size_t chosen_ = 0;
    double targetYaw_rad_ = 0.0;
    ViewFrame frame_;
    irsg::Vec3 towardsSun_{0, 0, 1};
};

} // namespace smat::gui
