#include "gui/view/DisplayScene.h"

#include <osg/ComputeBoundsVisitor>
#include <osg/Geometry>
#include <osg/MatrixTransform>
#include <osg/NodeVisitor>
#include <osg/StateSet>

#include "irsg/radiometry/Errors.h"
#include "irsg/scene/model/ModelLoader.h"
#include "irsg/scene/model/ModelPlacing.h"
#include "irsg/scene/radiance/SceneRadiometry.h"

namespace smat::gui {
namespace {

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
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            matrix(column, row) =
                rotation[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)];
    matrix.setTrans(pose.position_m.x, pose.position_m.y, pose.position_m.z);
    return matrix;
}

/// Runs a part of the work that the view can do without.
template <typename Work>
void attempt(const Work& work) {
    try {
        work();
    } catch (const irsg::InputError&) {
        // The analysis says what is wrong with it; the view shows the model all the same.
    }
}

} // namespace

void DisplayScene::placeTarget(const irsg::Pose& pose) {
    if (models.empty())
        return;
    models.front().pose = pose;
    models.front().placed->setMatrix(poseMatrix(pose));
    models.front().marks->setMatrix(poseMatrix(pose));
    referencePoint_m = pose.toWorld(referenceInModel_m);
}

void DisplayScene::setSignature(const std::filesystem::path& file,
                                std::shared_ptr<const irsg::SignatureDatabase> signature) {
    for (DisplayModel& model : models)
        if (model.database == file)
            model.signature = signature;
    if (!models.empty() && models.front().database == file) {
        findReference();
        referencePoint_m = models.front().pose.toWorld(referenceInModel_m);
    }
}

void DisplayScene::setModel(const ModelKey& key, std::shared_ptr<const irsg::Model> model,
                            const std::shared_ptr<const ModelFaces>& faces) {
    loaded[key] = std::move(model);
    for (DisplayModel& one : models)
        if (one.key == key)
            one.faces = faces;
    // What of it is opaque may be another part.
    if (!models.empty() && models.front().key == key) {
        findReference();
        referencePoint_m = models.front().pose.toWorld(referenceInModel_m);
    }
}

void DisplayScene::findReference() {
    // The centre of what is opaque in the infrared, as the infrared renderer takes it; of all where
    // there is no database to tell.
    const DisplayModel& model = models.front();
    const auto known = loaded.find({target_.file, target_.options});
    if (target_.referencePoint_m)
        referenceInModel_m = *target_.referencePoint_m;
    if (target_.referencePoint_m || !model.signature || known == loaded.end())
        return;
    irsg::Entity entity;
    entity.model = known->second;
    entity.database = model.signature;
    entity.fallbackMaterial = target_.fallbackMaterial;
    const irsg::BoundingBox opaque = entity.model->boundsOf([&](const irsg::IrCodes& codes) {
        const irsg::Material* material = irsg::materialEntry(entity, codes.material);
        return material == nullptr || material->isOpaque();
    });
    referenceInModel_m = opaque.valid() ? opaque.centre() : entity.model->bounds().centre();
}

DisplayScene loadDisplayScene(const Project& project, const Settings& settings,
                              const SceneBuilder::ModelLoader& models) {
    DisplayScene scene;
    scene.root = new osg::Group;
    SceneBuilder builder(models);
    std::vector<irsg::Diagnostic> diagnostics;
    for (std::size_t i = 0; i < project.models.size(); ++i) {
        const ProjectModel& given = project.models[i];
        const ModelKey key = ModelKey::of(project, given);
        irsg::LoadedGraph loaded;
        try {
            loaded = irsg::loadGraph(key.file, irsg::LoadPurpose::visible);
        } catch (const irsg::InputError& error) {
            diagnostics.insert(diagnostics.end(), error.diagnostics().begin(),
                               error.diagnostics().end());
            continue;
        }
        for (const auto& remark : loaded.remarks)
            scene.remarks.push_back(QString::fromStdString(remark));
        UnlitFaces unlit;
        loaded.node->accept(unlit);

        DisplayModel model;
        model.key = key;
        model.name =
            QString::fromStdString(given.name.empty() ? given.file.stem().string() : given.name);
        model.pose = i == 0 ? targetPoseOf(settings) : given.pose;
        // As the infrared has it; where it cannot read the model, about the file's own origin.
        osg::ref_ptr<osg::MatrixTransform> turned = new osg::MatrixTransform(
            irsg::turnAndScale(irsg::completed(given.options.placing, loaded.axes, key.file)));
        attempt([&] {
            const auto infrared = builder.model(key.file, key.options);
            scene.loaded[key] = infrared;
            turned->setMatrix(infrared->fromFile());
            model.faces = std::make_shared<const ModelFaces>(*infrared);
        });
        turned->addChild(loaded.node);
        model.placed = new osg::MatrixTransform(poseMatrix(model.pose));
        model.placed->addChild(turned);
        model.marks = new osg::MatrixTransform(poseMatrix(model.pose));
        scene.root->addChild(model.placed);
        if (!given.database.empty()) {
            model.database = project.resolve(given.database);
            attempt([&] { model.signature = builder.database(model.database); });
        }
        scene.models.push_back(std::move(model));
        if (i > 0)
            continue;

        // The camera turns about the target's own reference point.
        osg::ComputeBoundsVisitor bounds;
        turned->accept(bounds);
        const osg::Vec3d centre = bounds.getBoundingBox().center();
        scene.referenceInModel_m = {centre.x(), centre.y(), centre.z()};
        scene.radius_m = bounds.getBoundingBox().radius();
        scene.target_ = given;
        scene.target_.file = key.file;
        scene.findReference();
        scene.placeTarget(scene.models.front().pose);
    }
    if (!diagnostics.empty())
        throw irsg::InputError(std::move(diagnostics));

    // Scaled models keep their shading; both walls of a shell can be looked at.
    osg::StateSet* state = scene.root->getOrCreateStateSet();
    state->setMode(GL_NORMALIZE, osg::StateAttribute::ON);
    return scene;
}

} // namespace smat::gui
