#include "gui/tools/StageCard.h"

#include <algorithm>

#include <QPainter>
#include <QPainterPath>

namespace smat::gui {

StageCard::StageCard(const QString& name, const QString& title, QWidget* parent)
    : QAbstractButton(parent) {
    setObjectName(name);
    setText(title);
    setCheckable(true);
    setAutoExclusive(true);
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void StageCard::setCurve(std::vector<double> values, const QString& number) {
    curve_ = std::move(values);
    number_ = number;
    setAccessibleDescription(number);
    update();
}

QSize StageCard::sizeHint() const {
    return {130, 4 * fontMetrics().height() + 24};
}

QSize StageCard::minimumSizeHint() const {
    constexpr int margins_px = 11, least_px = 56;
    return {std::max(least_px, fontMetrics().horizontalAdvance(text()) + margins_px),
            sizeHint().height()};
}

void StageCard::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF frame = QRectF(rect()).adjusted(1.0, 1.0, -1.0, -1.0);
    painter.setPen(QPen(palette().color(isChecked() ? QPalette::Highlight : QPalette::Mid),
                        isChecked() ? 2.0 : 1.0));
    painter.setBrush(palette().color(underMouse() ? QPalette::AlternateBase : QPalette::Base));
    painter.drawRoundedRect(frame, 5.0, 5.0);
    if (hasFocus()) {
        painter.setPen(QPen(palette().color(QPalette::Highlight), 1.0, Qt::DotLine));
        painter.setBrush(Qt::NoBrush);
        painter.drawRoundedRect(frame.adjusted(3.0, 3.0, -3.0, -3.0), 4.0, 4.0);
    }
    const int line = fontMetrics().height();
    const QRect inside = rect().adjusted(5, 5, -4, -5);
    painter.setPen(palette().color(QPalette::Text));
    painter.drawText(inside, Qt::AlignLeft | Qt::AlignTop,
                     fontMetrics().elidedText(text(), Qt::ElideRight, inside.width()));
    painter.drawText(inside, Qt::AlignLeft | Qt::AlignBottom,
                     fontMetrics().elidedText(number_, Qt::ElideRight, inside.width()));
    if (curve_.size() < 2)
        return;
    const QRectF room = QRectF(inside).adjusted(0.0, line + 5.0, 0.0, -line - 5.0);
    painter.setPen(palette().color(QPalette::Mid));
    painter.drawLine(room.bottomLeft(), room.bottomRight());
    QPainterPath path;
    for (std::size_t i = 0; i < curve_.size(); ++i) {
        const QPointF point(room.left() + room.width() * static_cast<double>(i) /
                                              static_cast<double>(curve_.size() - 1),
                            room.bottom() - room.height() * std::clamp(curve_[i], 0.0, 1.0));
        i == 0 ? path.moveTo(point) : path.lineTo(point);
    }
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(palette().color(QPalette::Highlight), 1.6));
    painter.drawPath(path);
}

} // namespace smat::gui

#include "moc_StageCard.cpp"
