#include "gui/view/SceneView.h"

#include <cmath>

#include <QKeyEvent>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QPainter>
#include <osg/ColorMask>
#include <osg/GLObjects>
#include <osg/PolygonMode>

#include "gui/Theme.h"
#include "gui/plot/CrosshairOverlay.h"
#include "gui/view/InfraredDisplay.h"
#include "gui/view/SceneViewImpl.h"
#include "gui/view/ViewBackground.h"
#include "gui/view/ViewHud.h"
#include "irsg/radiometry/Units.h"
#include "smatcore/project/EnvironmentInput.h"
#include "smatcore/settings/SettingKeys.h"

namespace smat::gui {

namespace {

/// Asked once, on a surface of its own.
bool isSoftwareRenderer() {
    static const bool is = [] {
        QOpenGLContext context;
        QOffscreenSurface surface;
        surface.create();
        if (!context.create() || !context.makeCurrent(&surface))
            return false;
        const auto* name =
            reinterpret_cast<const char*>(context.functions()->glGetString(GL_RENDERER));
        const QString renderer = QString::fromLatin1(name).toLower();
        context.doneCurrent();
        return renderer.contains("llvmpipe") || renderer.contains("softpipe") ||
               renderer.contains("swrast") || renderer.contains("software");
    }();
    return is;
}

} // namespace

SceneView::SceneView(QWidget* parent) : QOpenGLWidget(parent), impl_(std::make_unique<Impl>()) {
    setObjectName("sceneView");
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(320, 240);
    setMouseTracking(true);
    QSurfaceFormat format;
    format.setDepthBufferSize(24);
    // A renderer in software pays for every sample: it smooths what is drawn over the model alone.
    format.setSamples(isSoftwareRenderer() ? 0 : 4);
    setFormat(format);
    // Transparent faces mix with what lies behind them; the widget itself stays opaque.
    impl_->root->getOrCreateStateSet()->setAttribute(new osg::ColorMask(true, true, true, false));
    map_ = &irsg::ColorMap::named(irsg::ColorMap::defaultName);
    hud_ = new CrosshairOverlay(this, [this](QPainter& painter) {
        impl_->hud = hud();
        impl_->hud->paint(painter);
    });
    hud_->show();

    infrared_ = new InfraredDisplay(this);
    connect(infrared_, &InfraredDisplay::drawn, this, &SceneView::onDrawn);
    connect(infrared_, &InfraredDisplay::failed, this, &SceneView::onFailed);
    rest_.setSingleShot(true);
    rest_.setInterval(140);
    connect(&rest_, &QTimer::timeout, this, [this] { sendRequest(false); });
    waiting_.setInterval(100);
    connect(&waiting_, &QTimer::timeout, this, &SceneView::onWaiting);
}

SceneView::~SceneView() {
    delete infrared_;
    disconnect(impl_->contextGoes);
    if (context() != nullptr) {
        makeCurrent();
        releaseGl();
        doneCurrent();
    }
}

QString SceneView::problem() {
    QOpenGLContext context;
    if (!context.create())
        return tr("This desktop gives no OpenGL context, so the model cannot be shown in 3-D.\n"
                  "Analyses, images and plots work all the same.");
    return {};
}

void SceneView::initializeGL() {
    // Qt makes a new context when the widget moves to another window: start anew with it.
    releaseGl();
    impl_->pixels = size() * devicePixelRatio();
    impl_->window =
        new osgViewer::GraphicsWindowEmbedded(0, 0, impl_->pixels.width(), impl_->pixels.height());
    impl_->viewer = new osgViewer::Viewer;
    impl_->viewer->setThreadingModel(osgViewer::Viewer::SingleThreaded);
    // Models are read whole before they are shown; nothing is fetched while they are drawn.
    impl_->viewer->setDatabasePager(nullptr);
    impl_->viewer->setImagePager(nullptr);
    impl_->viewer->setKeyEventSetsDone(0);
    impl_->viewer->setLightingMode(osg::View::HEADLIGHT);
    // Faces that look away from the eye are seen, too.
    impl_->viewer->getLight()->setAmbient(osg::Vec4(0.45F, 0.46F, 0.5F, 1.0F));
    impl_->viewer->getLight()->setDiffuse(osg::Vec4(0.75F, 0.74F, 0.72F, 1.0F));
    auto* camera = impl_->viewer->getCamera();
    camera->setGraphicsContext(impl_->window);
    camera->setClearMask(GL_DEPTH_BUFFER_BIT | GL_COLOR_BUFFER_BIT);
    camera->setViewport(0, 0, impl_->pixels.width(), impl_->pixels.height());
    impl_->background = makeViewBackground(isDark(palette()));
    impl_->viewer->setSceneData(impl_->root);
    arrange();
    disconnect(impl_->contextGoes);
    impl_->contextGoes = connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, [this] {
        makeCurrent();
        releaseGl();
        doneCurrent();
    });
    const auto* name = context()->functions()->glGetString(GL_RENDERER);
    const auto* version = context()->functions()->glGetString(GL_VERSION);
    renderer_ =
        QStringLiteral("%1, OpenGL %2")
            .arg(reinterpret_cast<const char*>(name), reinterpret_cast<const char*>(version));
}

void SceneView::releaseGl() {
    if (!impl_->viewer)
        return;
    osg::State* state = impl_->window->getState();
    impl_->root->releaseGLObjects(state);
    if (impl_->scene.root)
        impl_->scene.root->releaseGLObjects(state);
    impl_->sheet.node()->releaseGLObjects(state);
    impl_->viewer->setSceneData(nullptr);
    impl_->viewer = nullptr;
    impl_->window = nullptr;
}

void SceneView::arrange() {
    if (!impl_->background)
        return;
    const bool infrared = showsPicture();
    const OverlayLook look{look_.selection, infrared, look_.wireframe, devicePixelRatioF()};
    if (impl_->marked != look) {
        impl_->marked = look;
        impl_->hasGlObjectsToDelete = true;
        fillMarks(impl_->scene, look);
    }
    osg::Group& root = *impl_->root;
    root.removeChildren(0, root.getNumChildren());
    root.addChild(infrared ? impl_->sheet.node() : impl_->background.get());
    if (impl_->scene.root && !infrared)
        root.addChild(impl_->scene.root);
    for (const DisplayModel& model : impl_->scene.models)
        if (model.marks->getNumChildren() > 0)
            root.addChild(model.marks);
    impl_->arrangeInset(!insetRect().isNull());
}

void SceneView::paintGL() {
    // Framebuffer 0 is not this widget, and the one that is changes at every resize.
    impl_->window->setDefaultFboId(defaultFramebufferObject());
    if (const QSize pixels = size() * devicePixelRatio(); pixels != impl_->pixels) {
        impl_->pixels = pixels;
        impl_->window->resized(0, 0, pixels.width(), pixels.height());
        impl_->viewer->getCamera()->setViewport(0, 0, pixels.width(), pixels.height());
        arrange();
    }
    aim();
    aimInset();
    impl_->viewer->frame();
    if (impl_->hasGlObjectsToDelete) {
        impl_->hasGlObjectsToDelete = false;
        osg::flushAllDeletedGLObjects(impl_->window->getState()->getContextID());
    }
    ++frameCount_;
}

irsg::Viewpoint SceneView::eye() const {
    return showsPicture() ? picture_.eye
                          : camera().viewpoint(impl_->scene.referencePoint_m, targetYaw_rad_);
}

double SceneView::fieldOfView_rad() const {
    return fieldOfViewOf(frame_, size());
}

ViewProjection SceneView::projection() const {
    return ViewProjection::of(eye(), size(), fieldOfView_rad());
}

void SceneView::aim() {
    const auto from = eye();
    const auto vec = [](const irsg::Vec3& v) { return osg::Vec3d(v.x, v.y, v.z); };
    auto* camera = impl_->viewer->getCamera();
    camera->setViewMatrixAsLookAt(vec(from.position_m), vec(from.position_m + from.forward()),
                                  vec(from.up));
    const double aspect = static_cast<double>(width()) / std::max(height(), 1);
    const double tanHeight = std::tan(fieldOfView_rad() / 2.0) / aspect;
    camera->setProjectionMatrixAsPerspective(2.0 * irsg::degrees(std::atan(tanHeight)), aspect, 1.0,
                                             10.0);
}

void SceneView::setScene(DisplayScene scene) {
    if (context() != nullptr)
        makeCurrent();
    if (impl_->scene.root && impl_->window) {
        impl_->scene.root->releaseGLObjects(impl_->window->getState());
        for (const DisplayModel& model : impl_->scene.models)
            model.marks->releaseGLObjects(impl_->window->getState());
    }
    impl_->scene = std::move(scene);
    impl_->hasGlObjectsToDelete = true;
    impl_->marked.reset();
    look_.selection = {};
    lastPick_.reset();
    // What is being edited stands in for files of the new models, too.
    for (const auto& [file, database] : edited_)
        impl_->scene.setSignature(file, database);
    projectMap_ = false;
    if (impl_->scene.models.empty())
        cameras_.forgetInspection();
    dropPicture();
    arrange();
    if (context() != nullptr)
        doneCurrent();
    sceneChanged();
    tellCamera();
}

void SceneView::setProject(const Project& project, const Settings& settings) {
    if (!project_ || *project_ != project)
        project_ = std::make_shared<const Project>(project);
    else if (settings_ == settings)
        return;
    // The project's colours count until another map is chosen in the view.
    if (const std::string& map = settings.text(key::displayColorMap);
        settings_.text(key::displayColorMap) != map || !projectMap_) {
        projectMap_ = true;
        setColorMap(map);
    }
    if (const std::string& scale = settings.text(key::displayScale);
        settings_.text(key::displayScale) != scale ||
        settings_[key::displayMarkOutside] != settings[key::displayMarkOutside]) {
        ColorRule rule = rule_;
        rule.scale = irsg::colorScaleNamed(scale);
        rule.marksOutside = settings[key::displayMarkOutside];
        setColorRule(rule);
    }
    settings_ = settings;
    impl_->scene.placeTarget(targetPoseOf(settings));
    frame_ = {irsg::radians(settings[key::sensorFov]), settings[key::sensorWidth],
              settings[key::sensorHeight]};
    cameras_.setSensor(
        {settings[key::cameraAzimuth], settings[key::cameraElevation], settings[key::cameraRange]});
    targetYaw_rad_ = irsg::radians(settings[key::targetYaw]);
    const irsg::SunPosition sun = sunOf(project, settings);
    towardsSun_ = irsg::direction(sun.azimuth_rad, sun.elevation_rad);
    sceneChanged();
}

void SceneView::setTargetPose(const irsg::Pose& pose) {
    impl_->scene.placeTarget(pose);
    sceneChanged();
}

void SceneView::setCamera(const OrbitCamera& camera, double targetYaw_rad) {
    if (camera == cameras_.sensor() && targetYaw_rad == targetYaw_rad_)
        return;
    cameras_.setSensor(camera);
    targetYaw_rad_ = targetYaw_rad;
    sceneChanged();
}

void SceneView::setFrame(const ViewFrame& frame) {
    if (frame == frame_)
        return;
    frame_ = frame;
    sceneChanged();
}

void SceneView::setWireframe(bool on) {
    look_.wireframe = on;
    auto* mode = new osg::PolygonMode(osg::PolygonMode::FRONT_AND_BACK,
                                      on ? osg::PolygonMode::LINE : osg::PolygonMode::FILL);
    impl_->root->getOrCreateStateSet()->setAttribute(mode);
    arrange();
    redraw();
}

void SceneView::setViewAxesVisible(bool on) {
    viewAxes_ = on;
    refreshHud();
}

void SceneView::setModelAxesVisible(bool on) {
    modelAxes_ = on;
    refreshHud();
}

void SceneView::setSunVectorVisible(bool on) {
    sunVector_ = on;
    refreshHud();
}

void SceneView::setHighlighted(const FaceSelection& selection) {
    if (selection == look_.selection)
        return;
    look_.selection = selection;
    arrange();
    redraw();
}

void SceneView::sceneChanged() {
    redraw();
    if (display_ == ViewDisplay::infrared)
        askInfrared();
}

void SceneView::redraw() {
    update();
    refreshHud();
}

void SceneView::refreshHud() {
    if (impl_->hud != hud())
        hud_->update();
}

void SceneView::resizeEvent(QResizeEvent* event) {
    QOpenGLWidget::resizeEvent(event);
    hud_->resize(size());
    sceneChanged();
}

void SceneView::showEvent(QShowEvent* event) {
    QOpenGLWidget::showEvent(event);
    sceneChanged();
}

void SceneView::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange && impl_->background) {
        impl_->background = makeViewBackground(isDark(palette()));
        arrange();
        redraw();
    }
    QOpenGLWidget::changeEvent(event);
}

ViewHud SceneView::hud() const {
    ViewHud hud;
    hud.frame = frame_;
    hud.projection = projection();
    hud.camera = camera();
    hud.inspecting = cameras_.isInspecting();
    hud.inset = insetRect();
    hud.hasProject = project_ != nullptr;
    hud.hasModel = !impl_->scene.models.empty();
    if (hud.hasModel) {
        hud.reference_m = impl_->scene.referencePoint_m;
        hud.attitude = impl_->scene.models.front().pose.attitude;
        hud.radius_m = impl_->scene.radius_m;
    }
    hud.towardsSun = towardsSun_;
    hud.viewAxes = viewAxes_;
    hud.modelAxes = modelAxes_;
    hud.sunVector = sunVector_;
    // On an infrared picture its own brightness counts, not the theme's.
    hud.dark = showsPicture() ? qGray(picture_.colors.pixel(0, 0)) < 128 : isDark(palette());
    hud.readout = readout_;
    hud.problem = display_ == ViewDisplay::infrared ? problem_ : QStringList();
    if (const double waited_s = infrared_->waiting_s();
        display_ == ViewDisplay::infrared && waited_s > 0.3)
        hud.busy = tr("infrared: computing… %1 s").arg(waited_s, 0, 'f', 1);
    return hud;
}

} // namespace smat::gui
