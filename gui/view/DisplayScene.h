#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include <QString>
#include <osg/Group>
#include <osg/MatrixTransform>
#include <osg/ref_ptr>

#include "gui/view/InfraredRequest.h"
#include "gui/view/ModelFaces.h"
#include "gui/workbench/OrbitCamera.h"
#include "irsg/geometry/view/Pose.h"
#include "smatcore/project/Project.h"

namespace smat::gui {

/// A model of the view: copies of its own of what is drawn, so that nothing is shared with the
/// infrared renderer's thread.
struct DisplayModel {
    QString name;
    ModelKey key;
    std::filesystem::path database;            ///< resolved; empty for none
    osg::ref_ptr<osg::MatrixTransform> placed; ///< in its visible colours
    osg::ref_ptr<osg::MatrixTransform> marks;  ///< what is drawn over its faces
    std::shared_ptr<const ModelFaces> faces;   ///< null where the infrared cannot read it
    std::shared_ptr<const irsg::SignatureDatabase> signature; ///< null where it cannot be read
    irsg::Pose pose;
    irsg::Vec3 centre_m;   ///< of its bounding box, in model axes
    double radius_m = 1.0; ///< of the same
    double reach_m = 0.0;  ///< of the farthest corner from the model's origin
};

/// What the 3-D view shows of a project: its models with their visible colours and their faces,
/// standing where the project puts them.
struct DisplayScene {
    osg::ref_ptr<osg::Group> root; ///< visible
    std::vector<DisplayModel> models;
    irsg::Vec3 referenceInModel_m; ///< of the target, the one analyses turn about
    irsg::Vec3 referencePoint_m;   ///< the same in the world
    double radius_m = 1.0;         ///< of the target about its reference point
    std::vector<QString> remarks;
    LoadedModels loaded; ///< for the infrared renderer

    /// Puts the models where the project and its settings have them.
    void place(const Project& project, const Settings& settings);
    /// Of a sphere about the reference point that holds all models.
    double reach_m() const;
    /// Of one model, and what holds all of them. The target is taken about its reference point.
    ViewBall ballOf(std::size_t model) const;
    ViewBall ballOfAll() const;
    /// The same model with other codes, as the infrared renderer has it.
    void setModel(const ModelKey& key, std::shared_ptr<const irsg::Model> model,
                  const std::shared_ptr<const ModelFaces>& faces);
    /// Gives the models with this database file an edited one; the target's reference point may
    /// move with what is opaque in it.
    void setSignature(const std::filesystem::path& file,
                      std::shared_ptr<const irsg::SignatureDatabase> signature);

  private:
    friend DisplayScene loadDisplayScene(const Project& project, const Settings& settings,
                                         const SceneBuilder::ModelLoader& models);
    void findReference();
    void placeModel(DisplayModel& model, const irsg::Pose& pose);
    ProjectModel target_;
};

/// Loads the models of a project and puts them at the poses that `settings` give. Throws
/// irsg::InputError with the diagnostics of all models. The infrared models come from `models`, or
/// from their files where it is empty.
DisplayScene loadDisplayScene(const Project& project, const Settings& settings,
                              const SceneBuilder::ModelLoader& models = {});

} // namespace smat::gui
