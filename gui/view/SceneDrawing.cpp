#include "gui/view/SceneDrawing.h"

#include <cmath>

#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <osg/ColorMask>
#include <osg/GLObjects>
#include <osg/PolygonMode>

#include "gui/view/ViewBackground.h"
#include "irsg/radiometry/Units.h"

namespace smat::gui {
namespace {

void aimCamera(osg::Camera& camera, const RenderingAim& aim) {
    const auto vec = [](const irsg::Vec3& v) { return osg::Vec3d(v.x, v.y, v.z); };
    const irsg::Viewpoint& from = aim.from;
    camera.setViewMatrixAsLookAt(vec(from.position_m), vec(from.position_m + from.forward()),
                                 vec(from.up));
    const double tanHeight = std::tan(aim.horizontalFieldOfView_rad / 2.0) / aim.aspect;
    camera.setProjectionMatrixAsPerspective(2.0 * irsg::degrees(std::atan(tanHeight)), aim.aspect,
                                            1.0, 10.0);
}

} // namespace

QSurfaceFormat SceneDrawing::surfaceFormat() {
    QSurfaceFormat format;
    format.setDepthBufferSize(24);
    // Edges, rails and rigging, where the driver has it; in software a frame takes twice as long.
    format.setSamples(4);
    return format;
}

QString SceneDrawing::rendererOf(QOpenGLContext& context) {
    const auto* name = context.functions()->glGetString(GL_RENDERER);
    const auto* version = context.functions()->glGetString(GL_VERSION);
    return QStringLiteral("%1, OpenGL %2")
        .arg(reinterpret_cast<const char*>(name), reinterpret_cast<const char*>(version));
}

SceneDrawing::SceneDrawing() {
    // Transparent faces mix with what lies behind them; the widget itself stays opaque.
    root_->getOrCreateStateSet()->setAttribute(new osg::ColorMask(true, true, true, false));
}

void SceneDrawing::begin(const QSize& pixels, bool dark) {
    pixels_ = pixels;
    window_ = new osgViewer::GraphicsWindowEmbedded(0, 0, pixels.width(), pixels.height());
    viewer_ = new osgViewer::Viewer;
    viewer_->setThreadingModel(osgViewer::Viewer::SingleThreaded);
    // Models are read whole before they are shown; nothing is fetched while they are drawn.
    viewer_->setDatabasePager(nullptr);
    viewer_->setImagePager(nullptr);
    viewer_->setKeyEventSetsDone(0);
    viewer_->setLightingMode(osg::View::HEADLIGHT);
    // Faces that look away from the eye are seen, too.
    viewer_->getLight()->setAmbient(osg::Vec4(0.45F, 0.46F, 0.5F, 1.0F));
    viewer_->getLight()->setDiffuse(osg::Vec4(0.75F, 0.74F, 0.72F, 1.0F));
    auto* camera = viewer_->getCamera();
    camera->setGraphicsContext(window_);
    camera->setClearMask(GL_DEPTH_BUFFER_BIT | GL_COLOR_BUFFER_BIT);
    camera->setViewport(0, 0, pixels.width(), pixels.height());
    background_ = makeViewBackground(dark);
    viewer_->setSceneData(root_);
}

void SceneDrawing::end(const DisplayScene& scene) {
    if (!viewer_)
        return;
    osg::State* state = window_->getState();
    root_->releaseGLObjects(state);
    if (scene.root)
        scene.root->releaseGLObjects(state);
    sheet_.node()->releaseGLObjects(state);
    viewer_->setSceneData(nullptr);
    viewer_ = nullptr;
    window_ = nullptr;
}

void SceneDrawing::forget(const DisplayScene& scene) {
    if (scene.root && window_) {
        scene.root->releaseGLObjects(window_->getState());
        for (const DisplayModel& model : scene.models)
            model.marks->releaseGLObjects(window_->getState());
    }
    hasGlObjectsToDelete_ = true;
    marked_.reset();
}

void SceneDrawing::setBackground(bool dark) {
    if (background_)
        background_ = makeViewBackground(dark);
}

void SceneDrawing::setWireframe(bool on) {
    auto* mode = new osg::PolygonMode(osg::PolygonMode::FRONT_AND_BACK,
                                      on ? osg::PolygonMode::LINE : osg::PolygonMode::FILL);
    root_->getOrCreateStateSet()->setAttribute(mode);
}

void SceneDrawing::setPicture(const InfraredPicture& picture) {
    if (sheet_.setPicture(picture.colors, picture.coarse))
        hasGlObjectsToDelete_ = true;
}

void SceneDrawing::arrange(DisplayScene& scene, const OverlayLook& look, bool hasInset) {
    if (!background_)
        return;
    if (marked_ != look) {
        marked_ = look;
        hasGlObjectsToDelete_ = true;
        fillMarks(scene, look);
    }
    root_->removeChildren(0, root_->getNumChildren());
    root_->addChild(look.overInfrared ? sheet_.node() : background_.get());
    if (scene.root && !look.overInfrared && !look.codes)
        root_->addChild(scene.root);
    for (const DisplayModel& model : scene.models)
        if (model.marks->getNumChildren() > 0)
            root_->addChild(model.marks);
    if (inset_)
        inset_->removeChildren(0, inset_->getNumChildren());
    if (hasInset && scene.root)
        arrangeInset(scene);
}

void SceneDrawing::arrangeInset(const DisplayScene& scene) {
    if (!inset_) {
        inset_ = new osg::Camera;
        inset_->setReferenceFrame(osg::Transform::ABSOLUTE_RF);
        inset_->setRenderOrder(osg::Camera::POST_RENDER);
        inset_->setClearMask(GL_DEPTH_BUFFER_BIT | GL_COLOR_BUFFER_BIT);
        // The picture stays one of faces where the large one shows their edges.
        inset_->getOrCreateStateSet()->setAttribute(new osg::PolygonMode,
                                                    osg::StateAttribute::OVERRIDE);
    }
    inset_->addChild(background_);
    inset_->addChild(scene.root);
    root_->addChild(inset_);
}

bool SceneDrawing::resize(const QSize& pixels) {
    if (pixels == pixels_)
        return false;
    pixels_ = pixels;
    window_->resized(0, 0, pixels.width(), pixels.height());
    viewer_->getCamera()->setViewport(0, 0, pixels.width(), pixels.height());
    return true;
}

void SceneDrawing::aimInset(const RenderingAim& aim, const QRectF& pixels) {
    if (!inset_)
        return;
    aimCamera(*inset_, aim);
    inset_->setViewport(
        new osg::Viewport(pixels.left(), pixels.top(), pixels.width(), pixels.height()));
}

void SceneDrawing::draw(unsigned framebuffer, const RenderingAim& aim) {
    window_->setDefaultFboId(framebuffer);
    aimCamera(*viewer_->getCamera(), aim);
    viewer_->frame();
    if (hasGlObjectsToDelete_) {
        hasGlObjectsToDelete_ = false;
        osg::flushAllDeletedGLObjects(window_->getState()->getContextID());
    }
}

} // namespace smat::gui
