#include "gui/view/DisplayScene.h"

#include <osg/ComputeBoundsVisitor>
#include <osg/MatrixTransform>
#include <osg/StateSet>

#include "irsg/radiometry/Errors.h"
#include "irsg/scene/ModelLoader.h"
#include "smatcore/project/SceneBuilder.h"

namespace smat::gui {
namespace {

/// The model axes (x starboard, y nose, z up) in terms of the file's.
osg::Matrixd noseTurn(irsg::NoseAxis axis) {
    switch (axis) {
    case irsg::NoseAxis::plusX:
        return osg::Matrixd::rotate(osg::PI_2, osg::Vec3d(0, 0, 1));
    case irsg::NoseAxis::minusX:
        return osg::Matrixd::rotate(-osg::PI_2, osg::Vec3d(0, 0, 1));
    case irsg::NoseAxis::minusY:
        return osg::Matrixd::rotate(osg::PI, osg::Vec3d(0, 0, 1));
    case irsg::NoseAxis::plusY:
        break;
    }
    return {};
}

osg::Matrixd poseMatrix(const irsg::Pose& pose) {
    const auto rotation = pose.attitude.rotation().m;
    osg::Matrixd matrix;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column)
            matrix(column, row) =
                rotation[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)];
    }
    matrix.setTrans(pose.position_m.x, pose.position_m.y, pose.position_m.z);
    return matrix;
}

} // namespace

DisplayScene loadDisplayScene(const Project& project, const Settings& settings) {
    DisplayScene scene;
    scene.root = new osg::Group;
    std::vector<irsg::Offence> offences;
    for (std::size_t i = 0; i < project.models.size(); ++i) {
        const ProjectModel& model = project.models[i];
        irsg::LoadedGraph loaded;
        try {
            loaded = irsg::loadGraph(project.resolve(model.file), irsg::LoadPurpose::visible);
        } catch (const irsg::InputError& error) {
            offences.insert(offences.end(), error.offences().begin(), error.offences().end());
            continue;
        }
        for (const auto& remark : loaded.remarks)
            scene.remarks.push_back(QString::fromStdString(remark));
        const irsg::Pose pose = i == 0 ? targetPoseOf(settings) : model.pose;
        osg::ref_ptr<osg::MatrixTransform> turned =
            new osg::MatrixTransform(noseTurn(model.noseAxis));
        turned->addChild(loaded.node);
        osg::ref_ptr<osg::MatrixTransform> placed = new osg::MatrixTransform(poseMatrix(pose));
        placed->addChild(turned);
        scene.root->addChild(placed);
        if (i > 0)
            continue;

        // The camera turns about the target's own reference point.
        osg::ComputeBoundsVisitor bounds;
        turned->accept(bounds);
        const osg::Vec3d centre = bounds.getBoundingBox().center();
        const irsg::Vec3 reference =
            model.referencePoint_m.value_or(irsg::Vec3{centre.x(), centre.y(), centre.z()});
        scene.referencePoint_m = pose.toWorld(reference);
        scene.radius_m = bounds.getBoundingBox().radius();
    }
    if (!offences.empty())
        throw irsg::InputError(std::move(offences));

    // Scaled models keep their shading; both walls of a shell can be looked at.
    osg::StateSet* state = scene.root->getOrCreateStateSet();
    state->setMode(GL_NORMALIZE, osg::StateAttribute::ON);
    return scene;
}

} // namespace smat::gui
