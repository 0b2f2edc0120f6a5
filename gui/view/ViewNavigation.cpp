#include "gui/view/ViewNavigation.h"

#include <algorithm>
#include <cmath>

#include <QGuiApplication>
#include <QKeyEvent>
#include <QLineF>
#include <QMouseEvent>
#include <QStyleHints>
#include <QWheelEvent>
#include <QWidget>

namespace smat::gui {
namespace {

double narrowFieldOfView_rad(const ViewFrame& frame) {
    const double tanHalf = std::tan(frame.horizontalFieldOfView_rad / 2.0);
    const double aspect = static_cast<double>(frame.height_px) / frame.width_px;
    return 2.0 * std::atan(tanHalf * std::min(1.0, aspect));
}

} // namespace

ViewNavigation::ViewNavigation(QWidget* view, std::function<Surroundings()> surroundings)
    : QObject(view), surroundings_(std::move(surroundings)) {
    view->installEventFilter(this);
}

void ViewNavigation::take(const ViewCameras& cameras) {
    if (cameras == cameras_)
        return;
    const bool sensor = cameras.sensor() != cameras_.sensor();
    cameras_ = cameras;
    tellMoved(sensor);
}

void ViewNavigation::forgetInspection() {
    cameras_.forgetInspection();
    tellCamera();
}

void ViewNavigation::showCamera(ViewCamera camera) {
    if (camera == cameras_.shown())
        return;
    cameras_.show(camera);
    tellMoved(false);
}

void ViewNavigation::fit() {
    const Surroundings around = surroundings_();
    cameras_.fit(around.all, narrowFieldOfView_rad(around.frame));
    tellMoved(false);
}

void ViewNavigation::fitChosen() {
    const Surroundings around = surroundings_();
    cameras_.fit(around.chosen, narrowFieldOfView_rad(around.frame));
    tellMoved(false);
}

void ViewNavigation::lookAt(ViewSide side) {
    cameras_.lookAt(side);
    tellMoved(false);
}

void ViewNavigation::showWholeModel() {
    moveSensorBack(surroundings_().radius_m);
}

void ViewNavigation::showWholeScene() {
    moveSensorBack(surroundings_().reach_m);
}

void ViewNavigation::moveSensorBack(double radius_m) {
    cameras_.useSensor().range_m =
        OrbitCamera::rangeToShow(radius_m, narrowFieldOfView_rad(surroundings_().frame));
    tellMoved(true);
}

OrbitCamera& ViewNavigation::camera(bool sensor) {
    return sensor ? cameras_.useSensor() : cameras_.inspect();
}

void ViewNavigation::tellMoved(bool sensor) {
    emit moved();
    tellCamera();
    if (sensor)
        emit sensorMoved(cameras_.sensor());
}

void ViewNavigation::tellCamera() {
    if (told_ == cameras_.shown())
        return;
    told_ = cameras_.shown();
    emit cameraChanged();
}

void ViewNavigation::hover(const std::optional<QPointF>& point) {
    hoverAt_ = point;
    emit hovered();
}

bool ViewNavigation::eventFilter(QObject* watched, QEvent* event) {
    switch (event->type()) {
    case QEvent::MouseButtonPress:
        press(static_cast<const QMouseEvent&>(*event));
        return true;
    case QEvent::MouseMove:
        drag(static_cast<const QMouseEvent&>(*event));
        return true;
    case QEvent::MouseButtonRelease:
        release(static_cast<const QMouseEvent&>(*event));
        return true;
    case QEvent::MouseButtonDblClick:
        pressAt_.reset();
        fit();
        return true;
    case QEvent::Wheel:
        turnWheel(static_cast<const QWheelEvent&>(*event));
        return true;
    case QEvent::KeyPress:
        return pressKey(static_cast<const QKeyEvent&>(*event));
    case QEvent::Leave:
        hover(std::nullopt);
        [[fallthrough]];
    default:
        return QObject::eventFilter(watched, event);
    }
}

void ViewNavigation::press(const QMouseEvent& event) {
    if (event.button() == Qt::LeftButton && surroundings_().inset.contains(event.position())) {
        showCamera(cameras_.isInspecting() ? ViewCamera::sensor : ViewCamera::inspection);
        return;
    }
    const bool shifts = event.button() != Qt::LeftButton || event.modifiers() & Qt::ShiftModifier;
    pressAt_ = event.position();
    dragsSensor_ = event.modifiers() & Qt::ControlModifier && !shifts;
    dragPans_ = shifts;
}

void ViewNavigation::drag(const QMouseEvent& event) {
    if (event.buttons() == Qt::NoButton || !pressAt_) {
        hover(event.position());
        return;
    }
    // A hand that trembles still clicks.
    if (!dragFrom_ && QLineF(*pressAt_, event.position()).length() <
                          QGuiApplication::styleHints()->startDragDistance())
        return;
    const QPointF way = event.position() - dragFrom_.value_or(*pressAt_);
    dragFrom_ = event.position();
    constexpr double degreesPerPixel = 0.4;
    if (dragPans_)
        cameras_.pan(way.x(), way.y(), surroundings_().projection);
    else
        camera(dragsSensor_).turn(way.x() * degreesPerPixel, way.y() * degreesPerPixel);
    hover(event.position());
    tellMoved(dragsSensor_);
}

void ViewNavigation::release(const QMouseEvent& event) {
    if (!pressAt_)
        return;
    const bool isClick = !dragFrom_ && event.button() == Qt::LeftButton;
    pressAt_.reset();
    dragFrom_.reset();
    if (isClick)
        emit clicked(event.position(), event.modifiers());
    hover(event.position());
}

void ViewNavigation::turnWheel(const QWheelEvent& event) {
    const bool sensor = event.modifiers() & Qt::ControlModifier;
    camera(sensor).approach(std::pow(0.9, event.angleDelta().y() / 120.0));
    tellMoved(sensor);
}

bool ViewNavigation::pressKey(const QKeyEvent& event) {
    const double step = event.modifiers() & Qt::ShiftModifier ? 1.0 : 10.0;
    const bool sensor = event.modifiers() & Qt::ControlModifier;
    switch (event.key()) {
    case Qt::Key_Left:
        camera(sensor).turn(-step, 0.0);
        break;
    case Qt::Key_Right:
        camera(sensor).turn(step, 0.0);
        break;
    case Qt::Key_Up:
        camera(sensor).turn(0.0, step);
        break;
    case Qt::Key_Down:
        camera(sensor).turn(0.0, -step);
        break;
    case Qt::Key_PageUp:
        camera(sensor).approach(0.8);
        break;
    case Qt::Key_PageDown:
        camera(sensor).approach(1.25);
        break;
    case Qt::Key_Home:
        fit();
        return true;
    case Qt::Key_Escape:
        emit dismissed();
        return true;
    default:
        return false;
    }
    tellMoved(sensor);
    return true;
}

} // namespace smat::gui

#include "moc_ViewNavigation.cpp"
