#include "gui/view/SceneView.h"

#include <cmath>

#include <QKeyEvent>
#include <QMouseEvent>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QPainter>
#include <QWheelEvent>
#include <osg/ColorMask>
#include <osg/PolygonMode>
#include <osgViewer/GraphicsWindow>
#include <osgViewer/Viewer>

#include "gui/Theme.h"
#include "gui/plot/CrosshairOverlay.h"
#include "gui/view/ViewBackground.h"

namespace smat::gui {

struct SceneView::Parts {
    osg::ref_ptr<osgViewer::Viewer> viewer;
    osg::ref_ptr<osgViewer::GraphicsWindowEmbedded> window;
    osg::ref_ptr<osg::Group> root = new osg::Group;
    osg::ref_ptr<osg::Camera> background;
    DisplayScene scene;
    QMetaObject::Connection contextGoes;
};

SceneView::SceneView(QWidget* parent) : QOpenGLWidget(parent), parts_(std::make_unique<Parts>()) {
    setObjectName("sceneView");
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(320, 240);
    setToolTip(tr("Drag to turn, wheel for range, double click to see the whole model"));
    QSurfaceFormat format;
    format.setDepthBufferSize(24);
    format.setSamples(4);
    setFormat(format);
    // Transparent faces mix with what lies behind them; the widget itself stays opaque.
    parts_->root->getOrCreateStateSet()->setAttribute(
        new osg::ColorMask(true, true, true, false));
    hud_ = new CrosshairOverlay(this, [this](QPainter& painter) { paintHud(painter); });
    hud_->show();
}

SceneView::~SceneView() {
    disconnect(parts_->contextGoes);
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
    const QSize pixels = size() * devicePixelRatio();
    parts_->window = new osgViewer::GraphicsWindowEmbedded(0, 0, pixels.width(), pixels.height());
    parts_->viewer = new osgViewer::Viewer;
    parts_->viewer->setThreadingModel(osgViewer::Viewer::SingleThreaded);
    parts_->viewer->setKeyEventSetsDone(0);
    parts_->viewer->setLightingMode(osg::View::HEADLIGHT);
    // Faces that look away from the eye are seen, too.
    parts_->viewer->getLight()->setAmbient(osg::Vec4(0.45F, 0.46F, 0.5F, 1.0F));
    parts_->viewer->getLight()->setDiffuse(osg::Vec4(0.75F, 0.74F, 0.72F, 1.0F));
    auto* camera = parts_->viewer->getCamera();
    camera->setGraphicsContext(parts_->window);
    camera->setClearMask(GL_DEPTH_BUFFER_BIT | GL_COLOR_BUFFER_BIT);
    parts_->root->removeChildren(0, parts_->root->getNumChildren());
    parts_->background = makeViewBackground(isDark(palette()));
    parts_->root->addChild(parts_->background);
    if (parts_->scene.root)
        parts_->root->addChild(parts_->scene.root);
    parts_->viewer->setSceneData(parts_->root);
    disconnect(parts_->contextGoes);
    parts_->contextGoes = connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, [this] {
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
    if (!parts_->viewer)
        return;
    parts_->root->releaseGLObjects(parts_->window->getState());
    parts_->viewer->setSceneData(nullptr);
    parts_->viewer = nullptr;
    parts_->window = nullptr;
}

void SceneView::paintGL() {
    // Framebuffer 0 is not this widget, and the one that is changes at every resize.
    const QSize pixels = size() * devicePixelRatio();
    parts_->window->setDefaultFboId(defaultFramebufferObject());
    parts_->window->resized(0, 0, pixels.width(), pixels.height());
    parts_->viewer->getCamera()->setViewport(0, 0, pixels.width(), pixels.height());
    aim();
    parts_->viewer->frame();
    ++frameCount_;
}

void SceneView::aim() {
    const auto eye = camera_.viewpoint(parts_->scene.referencePoint_m, targetYaw_rad_);
    const auto vec = [](const irsg::Vec3& v) { return osg::Vec3d(v.x, v.y, v.z); };
    auto* camera = parts_->viewer->getCamera();
    camera->setViewMatrixAsLookAt(vec(eye.position_m), vec(eye.position_m + eye.forward()),
                                  vec(eye.up));

    // The sensor's frame fits into the widget, whichever of the two is wider.
    const double sensor = static_cast<double>(frame_.width_px) / frame_.height_px;
    const double widget = static_cast<double>(width()) / std::max(height(), 1);
    const double tanWidth =
        std::tan(frame_.horizontalFieldOfView_rad / 2.0) * std::max(1.0, widget / sensor);
    const double tanHeight = tanWidth / widget;
    const double degrees = 2.0 * std::atan(tanHeight) * 180.0 / osg::PI;
    camera->setProjectionMatrixAsPerspective(degrees, widget, 1.0, 10.0);
}

QRectF SceneView::frameRect() const {
    const double sensor = static_cast<double>(frame_.width_px) / frame_.height_px;
    QSizeF inner(width(), width() / sensor);
    if (inner.height() > height())
        inner = QSizeF(height() * sensor, height());
    return {QPointF((width() - inner.width()) / 2.0, (height() - inner.height()) / 2.0), inner};
}

void SceneView::setScene(DisplayScene scene) {
    if (context() != nullptr)
        makeCurrent();
    if (parts_->scene.root) {
        if (parts_->window)
            parts_->scene.root->releaseGLObjects(parts_->window->getState());
        parts_->root->removeChild(parts_->scene.root);
    }
    parts_->scene = std::move(scene);
    if (parts_->scene.root)
        parts_->root->addChild(parts_->scene.root);
    if (context() != nullptr)
        doneCurrent();
    redraw();
}

void SceneView::setTargetPose(const irsg::Pose& pose) {
    parts_->scene.placeTarget(pose);
    redraw();
}

void SceneView::setCamera(const OrbitCamera& camera, double targetYaw_rad) {
    if (camera == camera_ && targetYaw_rad == targetYaw_rad_)
        return;
    camera_ = camera;
    targetYaw_rad_ = targetYaw_rad;
    redraw();
}

void SceneView::setFrame(const ViewFrame& frame) {
    frame_ = frame;
    redraw();
}

void SceneView::setWireframe(bool on) {
    auto* mode = new osg::PolygonMode(osg::PolygonMode::FRONT_AND_BACK,
                                      on ? osg::PolygonMode::LINE : osg::PolygonMode::FILL);
    parts_->root->getOrCreateStateSet()->setAttribute(mode);
    redraw();
}

void SceneView::setAxesVisible(bool on) {
    axesVisible_ = on;
    hud_->update();
}

void SceneView::showWholeModel() {
    const double tanHalf = std::tan(frame_.horizontalFieldOfView_rad / 2.0);
    const double aspect = static_cast<double>(frame_.height_px) / frame_.width_px;
    const double narrow = 2.0 * std::atan(tanHalf * std::min(1.0, aspect));
    camera_.range_m = OrbitCamera::rangeToShow(parts_->scene.radius_m, narrow);
    userMoved();
}

void SceneView::userMoved() {
    redraw();
    emit cameraMoved(camera_);
}

void SceneView::redraw() {
    update();
    hud_->update();
}

void SceneView::mousePressEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton)
        dragFrom_ = event->position();
}

void SceneView::mouseMoveEvent(QMouseEvent* event) {
    if (!(event->buttons() & Qt::LeftButton) || !dragFrom_)
        return;
    const QPointF moved = event->position() - *dragFrom_;
    dragFrom_ = event->position();
    constexpr double degreesPerPixel = 0.4;
    camera_.turn(moved.x() * degreesPerPixel, moved.y() * degreesPerPixel);
    userMoved();
}

void SceneView::mouseDoubleClickEvent(QMouseEvent*) {
    showWholeModel();
}

void SceneView::wheelEvent(QWheelEvent* event) {
    camera_.approach(std::pow(0.9, event->angleDelta().y() / 120.0));
    userMoved();
}

void SceneView::keyPressEvent(QKeyEvent* event) {
    const double step = event->modifiers() & Qt::ShiftModifier ? 1.0 : 10.0;
    switch (event->key()) {
    case Qt::Key_Left:
        camera_.turn(-step, 0.0);
        break;
    case Qt::Key_Right:
        camera_.turn(step, 0.0);
        break;
    case Qt::Key_Up:
        camera_.turn(0.0, step);
        break;
    case Qt::Key_Down:
        camera_.turn(0.0, -step);
        break;
    case Qt::Key_PageUp:
        camera_.approach(0.8);
        break;
    case Qt::Key_PageDown:
        camera_.approach(1.25);
        break;
    case Qt::Key_Home:
        showWholeModel();
        return;
    default:
        QOpenGLWidget::keyPressEvent(event);
        return;
    }
    userMoved();
}

void SceneView::resizeEvent(QResizeEvent* event) {
    QOpenGLWidget::resizeEvent(event);
    hud_->resize(size());
}

void SceneView::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange && parts_->background) {
        parts_->root->removeChild(parts_->background);
        parts_->background = makeViewBackground(isDark(palette()));
        parts_->root->insertChild(0, parts_->background);
        redraw();
    }
    QOpenGLWidget::changeEvent(event);
}

void SceneView::paintHud(QPainter& painter) const {
    const bool dark = isDark(palette());
    QColor ink = dark ? QColor("#cfd5df") : QColor("#3c4452");

    // The corners of the sensor's frame.
    const QRectF frame = frameRect().adjusted(6, 6, -6, -6);
    ink.setAlphaF(0.45F);
    painter.setPen(QPen(ink, 1.2));
    const double arm = 16.0;
    for (const auto& [corner, right, down] :
         {std::tuple{frame.topLeft(), 1.0, 1.0}, std::tuple{frame.topRight(), -1.0, 1.0},
          std::tuple{frame.bottomLeft(), 1.0, -1.0}, std::tuple{frame.bottomRight(), -1.0, -1.0}}) {
        painter.drawLine(corner, corner + QPointF(arm * right, 0.0));
        painter.drawLine(corner, corner + QPointF(0.0, arm * down));
    }

    ink.setAlphaF(0.95F);
    painter.setPen(ink);
    const QString words = QStringLiteral("azimuth %1°   elevation %2°   range %3 m")
                              .arg(camera_.azimuth_deg, 0, 'f', 1)
                              .arg(camera_.elevation_deg, 0, 'f', 1)
                              .arg(camera_.range_m, 0, 'g', 6);
    painter.drawText(frame.adjusted(12, 8, -12, -8), Qt::AlignTop | Qt::AlignLeft, words);
    if (axesVisible_)
        paintAxes(painter);
}

void SceneView::paintAxes(QPainter& painter) const {
    struct Axis {
        irsg::Vec3 along;
        QString name;
        QColor color;
    };
    const Axis axes[] = {{{1, 0, 0}, tr("E"), QColor("#d64545")},
                         {{0, 1, 0}, tr("N"), QColor("#2f9e58")},
                         {{0, 0, 1}, tr("Up"), QColor("#3b7be0")}};
    const auto eye = camera_.viewpoint({}, targetYaw_rad_);
    const double length = 34.0;
    const QPointF origin = frameRect().bottomLeft() + QPointF(64.0, -64.0);
    QFont font = painter.font();
    font.setBold(true);
    painter.setFont(font);
    for (const auto& axis : axes) {
        const QPointF tip(irsg::dot(axis.along, eye.right), -irsg::dot(axis.along, eye.up));
        painter.setPen(QPen(axis.color, 2.4, Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(origin, origin + tip * length);
        const QPointF middle = origin + tip * (length + 13.0);
        painter.drawText(QRectF(middle - QPointF(20, 10), QSizeF(40, 20)), Qt::AlignCenter,
                         axis.name);
    }
}

} // namespace smat::gui
