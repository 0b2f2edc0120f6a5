// The two cameras of the view: what moves them, and the picture of the other one in a corner.
#include <algorithm>
#include <cmath>

#include <osg/PolygonMode>

#include "gui/view/SceneViewImpl.h"
#include "irsg/radiometry/Units.h"
#include "smatcore/settings/SettingKeys.h"

namespace smat::gui {
namespace {

constexpr double insetPart = 0.3; ///< of the view's shorter way
constexpr double insetMargin_px = 14.0;

} // namespace

void SceneView::showCamera(ViewCamera camera) {
    if (camera == cameras_.shown())
        return;
    cameras_.show(camera);
    inspected();
}

void SceneView::fit() {
    cameras_.fit(impl_->scene.radius_m, narrowFieldOfView_rad());
    inspected();
}

void SceneView::lookAt(ViewSide side) {
    cameras_.lookAt(side);
    inspected();
}

double SceneView::narrowFieldOfView_rad() const {
    const double tanHalf = std::tan(frame_.horizontalFieldOfView_rad / 2.0);
    const double aspect = static_cast<double>(frame_.height_px) / frame_.width_px;
    return 2.0 * std::atan(tanHalf * std::min(1.0, aspect));
}

void SceneView::showWholeModel() {
    cameras_.useSensor().range_m =
        OrbitCamera::rangeToShow(impl_->scene.radius_m, narrowFieldOfView_rad());
    sensorMoved();
}

void SceneView::sensorMoved() {
    inspected();
    emit cameraMoved(cameras_.sensor());
}

void SceneView::inspected() {
    lastPick_.reset();
    arrange();
    sceneChanged();
    tellCamera();
}

void SceneView::tellCamera() {
    if (toldCamera_ == cameras_.shown())
        return;
    toldCamera_ = cameras_.shown();
    emit displayChanged();
}

OrbitCamera& SceneView::moved(bool sensor) {
    return sensor ? cameras_.useSensor() : cameras_.inspect();
}

void SceneView::tellMoved(bool sensor) {
    if (sensor)
        sensorMoved();
    else
        inspected();
}

void SceneView::setInsetVisible(bool on) {
    inset_ = on;
    arrange();
    redraw();
}

QRectF SceneView::insetRect() const {
    if (!inset_ || !cameras_.other() || impl_->scene.models.empty())
        return {};
    const QSizeF room = QSizeF(size()) * insetPart;
    QRectF inner = frameRectIn(frame_, room);
    inner.moveTopRight(QPointF(width() - insetMargin_px, insetMargin_px));
    return inner;
}

void SceneView::aimInset() {
    const QRectF inner = insetRect();
    if (inner.isNull())
        return;
    const auto from = cameras_.other()->viewpoint(impl_->scene.referencePoint_m, targetYaw_rad_);
    const auto vec = [](const irsg::Vec3& v) { return osg::Vec3d(v.x, v.y, v.z); };
    osg::Camera& camera = *impl_->inset;
    camera.setViewMatrixAsLookAt(vec(from.position_m), vec(from.position_m + from.forward()),
                                 vec(from.up));
    const double aspect = inner.width() / inner.height();
    const double tanHeight = std::tan(fieldOfViewOf(frame_, inner.size()) / 2.0) / aspect;
    camera.setProjectionMatrixAsPerspective(2.0 * irsg::degrees(std::atan(tanHeight)), aspect, 1.0,
                                            10.0);
    // In pixels of the window, from its bottom left corner.
    const double ratio = devicePixelRatioF();
    camera.setViewport(new osg::Viewport(inner.left() * ratio, (height() - inner.bottom()) * ratio,
                                         inner.width() * ratio, inner.height() * ratio));
}

void SceneView::Impl::arrangeInset(bool visible) {
    if (!inset) {
        inset = new osg::Camera;
        inset->setReferenceFrame(osg::Transform::ABSOLUTE_RF);
        inset->setRenderOrder(osg::Camera::POST_RENDER);
        inset->setClearMask(GL_DEPTH_BUFFER_BIT | GL_COLOR_BUFFER_BIT);
        // The picture stays one of faces where the large one shows their edges.
        inset->getOrCreateStateSet()->setAttribute(new osg::PolygonMode,
                                                   osg::StateAttribute::OVERRIDE);
    }
    inset->removeChildren(0, inset->getNumChildren());
    if (!visible || !scene.root)
        return;
    inset->addChild(background);
    inset->addChild(scene.root);
    root->addChild(inset);
}

Settings SceneView::shownSettings() const {
    Settings shown = settings_;
    const OrbitCamera& camera = cameras_.camera();
    const auto rounded = [](double value) { return QString::number(value, 'f', 2).toStdString(); };
    shown.set(key::cameraAzimuth, rounded(camera.azimuth_deg));
    shown.set(key::cameraElevation, rounded(camera.elevation_deg));
    shown.set(key::cameraRange, rounded(camera.range_m));
    return shown;
}

} // namespace smat::gui
