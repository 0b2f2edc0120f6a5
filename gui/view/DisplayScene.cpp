#include "gui/view/DisplayScene.h"

#include <algorithm>

#include <osg/AlphaFunc>
#include <osg/BoundingBox>
#include <osg/ComputeBoundsVisitor>
#include <osg/Geometry>
#include <osg/Material>
#include <osg/MatrixTransform>
#include <osg/NodeVisitor>
#include <osg/StateSet>

#include "irsg/core/Collect.h"
#include "irsg/core/Errors.h"
#include "irsg/geometry/conversion/ModelLoader.h"
#include "irsg/geometry/conversion/OsgValues.h"
#include "irsg/geometry/conversion/TextureCut.h"
#include "irsg/geometry/model/ModelPlacing.h"
#include "irsg/radiance/SceneRadiometry.h"

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

/// Shows textured faces where their alpha is not below a half, as far as their material lets
/// anything be seen at all.
class CutTextures : public osg::NodeVisitor {
  public:
    CutTextures() : osg::NodeVisitor(TRAVERSE_ALL_CHILDREN) {}
    void apply(osg::Node& node) override {
        if (osg::StateSet* state = node.getStateSet())
            cut(*state);
        traverse(node);
    }

  private:
    static void cut(osg::StateSet& state) {
        irsg::TextureState texture;
        texture.update(state);
        if (!texture.isOn() || !irsg::AlphaMask::of(texture))
            return;
        const auto* material =
            dynamic_cast<const osg::Material*>(state.getAttribute(osg::StateAttribute::MATERIAL));
        const float covers = material ? material->getDiffuse(osg::Material::FRONT).a() : 1.0f;
        state.setAttributeAndModes(
            new osg::AlphaFunc(osg::AlphaFunc::GEQUAL, texture.least * covers));
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

void DisplayScene::placeModel(DisplayModel& model, const irsg::Pose& pose) {
    model.pose = pose;
    model.placed->setMatrix(poseMatrix(pose));
    model.marks->setMatrix(poseMatrix(pose));
    if (&model == &models.front())
        referencePoint_m = pose.toWorld(referenceInModel_m);
}

void DisplayScene::place(const Project& project, const Settings& settings) {
    // Another number of models is read anew in a moment.
    for (std::size_t i = 0; i < std::min(models.size(), project.models.size()); ++i)
        placeModel(models[i], poseOf(project, settings, i));
}

double DisplayScene::reach_m() const {
    double reach = radius_m;
    for (std::size_t i = 1; i < models.size(); ++i) {
        const ViewBall ball = ballOf(i);
        reach = std::max(reach, irsg::length(ball.centre_m - referencePoint_m) + ball.radius_m);
    }
    return reach;
}

ViewBall DisplayScene::ballOf(std::size_t model) const {
    if (model == 0 || model >= models.size())
        return {referencePoint_m, radius_m};
    return {models[model].pose.toWorld(models[model].centre_m), models[model].radius_m};
}

ViewBall DisplayScene::ballOfAll() const {
    if (models.size() < 2)
        return ballOf(0);
    osg::BoundingBoxd box;
    for (std::size_t i = 0; i < models.size(); ++i) {
        const ViewBall ball = ballOf(i);
        const osg::Vec3d centre(ball.centre_m.x, ball.centre_m.y, ball.centre_m.z);
        const osg::Vec3d half(ball.radius_m, ball.radius_m, ball.radius_m);
        box.expandBy(centre - half);
        box.expandBy(centre + half);
    }
    ViewBall all{{box.center().x(), box.center().y(), box.center().z()}, 0.0};
    for (std::size_t i = 0; i < models.size(); ++i) {
        const ViewBall ball = ballOf(i);
        all.radius_m =
            std::max(all.radius_m, irsg::length(ball.centre_m - all.centre_m) + ball.radius_m);
    }
    return all;
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
        irsg::collect(diagnostics,
                      [&] { loaded = irsg::loadGraph(key.file, irsg::LoadPurpose::visible); });
        if (!loaded.node)
            continue;
        for (const auto& remark : loaded.remarks)
            scene.remarks.push_back(QString::fromStdString(remark));
        UnlitFaces unlit;
        loaded.node->accept(unlit);
        if (key.options.cutsTextureAlpha) {
            CutTextures cut;
            loaded.node->accept(cut);
        }

        DisplayModel model;
        model.key = key;
        model.name =
            QString::fromStdString(given.name.empty() ? given.file.stem().string() : given.name);
        model.pose = poseOf(project, settings, i);
        // As the infrared has it; where it cannot read the model, about the file's own origin.
        osg::ref_ptr<osg::MatrixTransform> turned = new osg::MatrixTransform(irsg::toOsg(
            irsg::turnAndScale(irsg::completed(given.options.placing, loaded.axes, key.file))));
        attempt([&] {
            const auto infrared = builder.model(key.file, key.options);
            scene.loaded[key] = infrared;
            turned->setMatrix(irsg::toOsg(infrared->fromFile()));
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
        osg::ComputeBoundsVisitor bounds;
        turned->accept(bounds);
        const osg::BoundingBox& box = bounds.getBoundingBox();
        const osg::Vec3d centre = box.center();
        model.centre_m = {centre.x(), centre.y(), centre.z()};
        model.radius_m = box.radius();
        for (unsigned int corner = 0; corner < 8; ++corner)
            model.reach_m =
                std::max(model.reach_m, static_cast<double>(box.corner(corner).length()));
        scene.models.push_back(std::move(model));
        if (i > 0)
            continue;

        // The camera turns about the target's own reference point.
        scene.referenceInModel_m = scene.models.front().centre_m;
        scene.radius_m = scene.models.front().radius_m;
        scene.target_ = given;
        scene.target_.file = key.file;
        scene.findReference();
        scene.placeModel(scene.models.front(), scene.models.front().pose);
    }
    if (!diagnostics.empty())
        throw irsg::InputError(std::move(diagnostics));

    // Scaled models keep their shading; both walls of a shell can be looked at.
    osg::StateSet* state = scene.root->getOrCreateStateSet();
    state->setMode(GL_NORMALIZE, osg::StateAttribute::ON);
    return scene;
}

} // namespace smat::gui
