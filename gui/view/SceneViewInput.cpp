// Mouse and keys of the view, and what is under the mouse.
#include <algorithm>
#include <cmath>

#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QStyleHints>
#include <QWheelEvent>

#include "gui/view/SceneViewImpl.h"

namespace smat::gui {

std::vector<FaceHit> SceneView::facesAt(const QPointF& point) const {
    const ViewProjection through = projection();
    const irsg::Vec3 direction = through.ray(point);
    std::vector<FaceHit> hits;
    for (std::size_t i = 0; i < impl_->scene.models.size(); ++i) {
        const DisplayModel& model = impl_->scene.models[i];
        if (!model.faces)
            continue;
        const irsg::Rotation toModel = model.pose.attitude.rotation().transposed();
        const irsg::Vec3 eye = toModel * (through.eye.position_m - model.pose.position_m);
        for (const auto& hit : model.faces->along(eye, toModel * direction))
            hits.push_back(
                {static_cast<int>(i), hit.codes, model.pose.toWorld(hit.point_m), hit.distance_m});
    }
    std::ranges::stable_sort(hits, {}, &FaceHit::distance_m);
    return hits;
}

QString SceneView::indexWords(const FaceHit& hit) const {
    const DisplayModel& model = impl_->scene.models.at(static_cast<std::size_t>(hit.model));
    const auto named = [](const QString& word, int index, const std::string& name) {
        const QString number = QStringLiteral("%1 %2").arg(word).arg(index);
        return name.empty() ? number
                            : QStringLiteral("%1 (%2)").arg(number, QString::fromStdString(name));
    };
    std::string temperature, material;
    if (model.signature) {
        const auto& temperatures = model.signature->temperatures;
        if (const auto entry = temperatures.find(hit.codes.temperature);
            entry != temperatures.end())
            temperature = entry->second.name;
        const auto& materials = model.signature->materials;
        if (const auto entry = materials.find(hit.codes.material); entry != materials.end())
            material = entry->second.name;
    }
    QStringList words{named(tr("temperature"), hit.codes.temperature, temperature),
                      named(tr("material"), hit.codes.material, material)};
    if (impl_->scene.models.size() > 1)
        words << model.name;
    return words.join("     ");
}

void SceneView::pick(const QPointF& point) {
    const auto hits = facesAt(point);
    if (hits.empty()) {
        lastPick_.reset();
        setHighlighted({});
        emit nothingPicked();
        return;
    }
    // At the same place again: the next one behind with other indices.
    std::size_t number = 0;
    const auto sameFace = [](const FaceHit& a, const FaceHit& b) {
        return a.model == b.model && a.codes == b.codes;
    };
    if (lastPick_ && QLineF(lastPick_->at, point).length() < 3.0 && lastPick_->camera == camera() &&
        lastPick_->number < hits.size()) {
        number = lastPick_->number;
        while (number < hits.size() && sameFace(hits[number], hits[lastPick_->number]))
            ++number;
        if (number == hits.size())
            number = 0;
    }
    lastPick_ = LastPick{point, number, camera()};
    const FaceHit& hit = hits[number];
    setHighlighted({hit.codes.temperature, hit.codes.material, hit.model});
    emit facePicked(hit.codes.temperature, hit.codes.material, hit.model, hit.point_m);
}

void SceneView::hover(const std::optional<QPointF>& point) {
    hoverAt_ = point;
    const QString words = point && !dragFrom_ ? readoutAt(*point) : QString();
    if (words == readout_)
        return;
    readout_ = words;
    refreshHud();
}

void SceneView::mousePressEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton && insetRect().contains(event->position())) {
        showCamera(cameras_.isInspecting() ? ViewCamera::sensor : ViewCamera::inspection);
        return;
    }
    const bool shifts = event->button() != Qt::LeftButton || event->modifiers() & Qt::ShiftModifier;
    pressAt_ = event->position();
    dragsSensor_ = event->modifiers() & Qt::ControlModifier && !shifts;
    dragPans_ = shifts;
}

void SceneView::mouseMoveEvent(QMouseEvent* event) {
    if (event->buttons() == Qt::NoButton || !pressAt_) {
        hover(event->position());
        return;
    }
    // A hand that trembles still clicks.
    if (!dragFrom_ && QLineF(*pressAt_, event->position()).length() <
                          QGuiApplication::styleHints()->startDragDistance())
        return;
    const QPointF moved = event->position() - dragFrom_.value_or(*pressAt_);
    dragFrom_ = event->position();
    constexpr double degreesPerPixel = 0.4;
    if (dragPans_)
        cameras_.pan(moved.x(), moved.y(), projection());
    else
        this->moved(dragsSensor_).turn(moved.x() * degreesPerPixel, moved.y() * degreesPerPixel);
    hover(event->position());
    tellMoved(dragsSensor_);
}

void SceneView::mouseReleaseEvent(QMouseEvent* event) {
    if (!pressAt_)
        return;
    const bool clicked = !dragFrom_ && event->button() == Qt::LeftButton;
    pressAt_.reset();
    dragFrom_.reset();
    if (clicked)
        pick(event->position());
    hover(event->position());
}

void SceneView::mouseDoubleClickEvent(QMouseEvent*) {
    pressAt_.reset();
    fit();
}

void SceneView::leaveEvent(QEvent* event) {
    hover(std::nullopt);
    QOpenGLWidget::leaveEvent(event);
}

void SceneView::wheelEvent(QWheelEvent* event) {
    const bool sensor = event->modifiers() & Qt::ControlModifier;
    moved(sensor).approach(std::pow(0.9, event->angleDelta().y() / 120.0));
    tellMoved(sensor);
}

void SceneView::keyPressEvent(QKeyEvent* event) {
    const double step = event->modifiers() & Qt::ShiftModifier ? 1.0 : 10.0;
    const bool sensor = event->modifiers() & Qt::ControlModifier;
    switch (event->key()) {
    case Qt::Key_Left:
        moved(sensor).turn(-step, 0.0);
        break;
    case Qt::Key_Right:
        moved(sensor).turn(step, 0.0);
        break;
    case Qt::Key_Up:
        moved(sensor).turn(0.0, step);
        break;
    case Qt::Key_Down:
        moved(sensor).turn(0.0, -step);
        break;
    case Qt::Key_PageUp:
        moved(sensor).approach(0.8);
        break;
    case Qt::Key_PageDown:
        moved(sensor).approach(1.25);
        break;
    case Qt::Key_Home:
        fit();
        return;
    case Qt::Key_Escape:
        setHighlighted({});
        emit nothingPicked();
        return;
    default:
        QOpenGLWidget::keyPressEvent(event);
        return;
    }
    tellMoved(sensor);
}

} // namespace smat::gui
