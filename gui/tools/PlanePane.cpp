#include "gui/tools/PlanePane.h"

#include <memory>

#include <QPainter>

#include "irsg/image/ColorMap.h"

namespace smat::gui {

PlanePane::PlanePane(const QString& name, QWidget* parent) : QWidget(parent) {
    setObjectName(name);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void PlanePane::setPlane(const QString& title, std::vector<float> values, int width, int height,
                         const irsg::DisplayLimits& limits) {
    title_ = title;
    plane_.setValues(width, height, std::make_shared<const std::vector<float>>(std::move(values)));
    plane_.setColors(irsg::ColorMap::named(irsg::ColorMap::defaultName), limits);
    plane_.color();
    update();
}

void PlanePane::clear(const QString& title) {
    title_ = title;
    plane_ = ColoredPlane();
    update();
}

void PlanePane::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setPen(palette().color(QPalette::Text));
    int top = 0;
    for (const QString& line : title_.split('\n')) {
        painter.drawText(QRect(0, top, width(), fontMetrics().height()),
                         Qt::AlignLeft | Qt::AlignVCenter,
                         fontMetrics().elidedText(line, Qt::ElideRight, width()));
        top += fontMetrics().height();
    }
    if (plane_.isEmpty())
        return;
    const QRectF room(0.0, top + 4.0, width(), height() - top - 4.0);
    const QSizeF size =
        QSizeF(plane_.width(), plane_.height()).scaled(room.size(), Qt::KeepAspectRatio);
    const QRectF target(room.topLeft(), size);
    plane_.draw(painter, target, target, devicePixelRatioF());
}

} // namespace smat::gui

#include "moc_PlanePane.cpp"
