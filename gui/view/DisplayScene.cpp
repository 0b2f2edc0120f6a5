#include "gui/view/DisplayScene.h"

#include <osg/ComputeBoundsVisitor>
#include <osg/Geometry>
#include <osg/MatrixTransform>
#include <osg/NodeVisitor>
#include <osg/StateSet>

#include "irsg/radiometry/Errors.h"
#include "irsg/scene/ModelLoader.h"
#include "irsg/scene/SceneRadiometry.h"
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

/// Faces without normals cannot be lit: they show their own colour instead of black.
class UnlitFaces : public osg::NodeVisitor {
  public:
    UnlitFaces() : osg::NodeVisitor(TRAVERSE_ALL_CHILDREN) {}
    void apply(osg::Geometry& geometry) override {
        if (geometry.getNormalArray() == nullptr)
            geometry.getOrCreateStateSet()->setMode(
                GL_LIGHTING, osg::StateAttribute::OFF | osg::StateAttribute::PROTECTED);
    }
};

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

/// The centre of what is opaque in the infrared, as the infrared renderer takes it; of all where
/// there is no database to tell.
std::optional<irsg::Vec3> infraredReference(const Project& project, const ProjectModel& target) {
    if (target.referencePoint_m)
        return target.referencePoint_m;
    try {
        SceneBuilder builder;
        irsg::Entity entity;
        entity.model = builder.model(project.resolve(target.file),
                                     {.noseAxis = target.noseAxis, .forceTwoSided = false});
        entity.database = builder.database(project.resolve(target.database));
        entity.fallbackMaterial = target.fallbackMaterial;
        const irsg::BoundingBox opaque = entity.model->boundsOf([&](const irsg::IrCodes& codes) {
            const irsg::Material* material = irsg::materialEntry(entity, codes.material);
            return material == nullptr || material->isOpaque();
        });
        return opaque.valid() ? opaque.centre() : entity.model->bounds().centre();
    } catch (const irsg::InputError&) {
        // The analysis says what is wrong with the database; the view shows the model all the same.
        return std::nullopt;
    }
}

} // namespace

void DisplayScene::placeTarget(const irsg::Pose& pose) {
    if (target)
        target->setMatrix(poseMatrix(pose));
    referencePoint_m = pose.toWorld(referenceInModel_m);
}

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
        UnlitFaces unlit;
        loaded.node->accept(unlit);
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
        scene.referenceInModel_m = infraredReference(project, model)
                                       .value_or(irsg::Vec3{centre.x(), centre.y(), centre.z()});
        scene.target = placed;
        scene.placeTarget(pose);
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
