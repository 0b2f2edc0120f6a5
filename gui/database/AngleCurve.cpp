#include "gui/database/AngleCurve.h"

#include <cmath>
#include <numbers>

#include <QPainter>
#include <QPainterPath>

#include "gui/widgets/Theme.h"

namespace smat::gui {

namespace {

AngleCurve::Value powerOfCosine(double factor) {
    return [factor](double cosine) { return factor == 0.0 ? 1.0 : std::pow(cosine, factor); };
}

} // namespace

AngleCurve::AngleCurve(QString quantity, QWidget* parent)
    : QWidget(parent), quantity_(std::move(quantity)) {
    setMinimumSize(200, 130);
    setToolTip(tr("Emission against the angle between the surface's normal and the sensor"));
}

AngleCurve::Values AngleCurve::tabulated(const Value& value) {
    Values values;
    for (int angle_deg = 0; angle_deg <= 90; ++angle_deg)
        values.push_back(
            value(angle_deg == 90 ? 0.0 : std::cos(angle_deg * std::numbers::pi / 180.0)));
    return values;
}

void AngleCurve::showFactor(double factor) {
    show(powerOfCosine(factor),
         {powerOfCosine(0.0), powerOfCosine(0.25), powerOfCosine(1.0), powerOfCosine(3.0)});
}

void AngleCurve::show(const Value& value, const std::vector<Value>& toCompare) {
    shown_ = tabulated(value);
    why_.clear();
    compared_.clear();
    for (const Value& each : toCompare)
        compared_.push_back(tabulated(each));
    update();
}

void AngleCurve::clear(const QString& why) {
    why_ = why;
    shown_.clear();
    compared_.clear();
    update();
}

void AngleCurve::paintEvent(QPaintEvent*) {
    const PlotStyle style = PlotStyle::screen(palette());
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    QFont small = font();
    small.setPointSizeF(small.pointSizeF() * 0.88);
    painter.setFont(small);
    const QRectF area = QRectF(rect()).adjusted(52, 10, -14, -36);
    painter.setPen(QPen(style.grid, 1.0));
    painter.setBrush(style.canvas);
    painter.drawRect(area);
    painter.setPen(style.text);
    for (const int angle : {0, 30, 60, 90}) {
        const double x = area.left() + area.width() * angle / 90.0;
        painter.drawText(QRectF(x - 20, area.bottom() + 2, 40, 15), Qt::AlignCenter,
                         QStringLiteral("%1°").arg(angle));
    }
    painter.drawText(QRectF(area.left(), area.bottom() + 17, area.width(), 16), Qt::AlignCenter,
                     tr("viewing angle"));
    for (const double level : {0.0, 0.5, 1.0})
        painter.drawText(QRectF(16, area.bottom() - level * area.height() - 8, 31, 16),
                         Qt::AlignRight | Qt::AlignVCenter, QString::number(level));

    painter.save();
    painter.translate(9.0, area.center().y());
    painter.rotate(-90.0);
    painter.drawText(QRectF(-area.height() / 2.0, -8.0, area.height(), 16.0), Qt::AlignCenter,
                     quantity_);
    painter.restore();

    painter.setPen(style.text);
    constexpr double margin = 8.0;
    painter.drawText(area.adjusted(margin, margin, -margin, -margin),
                     Qt::AlignCenter | Qt::TextWordWrap, why_);

    const auto curve = [&](const Values& values) {
        QPainterPath path;
        for (std::size_t i = 0; i < values.size(); ++i) {
            const QPointF at(area.left() + area.width() * static_cast<double>(i) / 90.0,
                             area.bottom() - values[i] * area.height());
            i == 0 ? path.moveTo(at) : path.lineTo(at);
        }
        return path;
    };
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(style.faintText, 1.0, Qt::DotLine));
    for (const Values& values : compared_)
        painter.drawPath(curve(values));
    painter.setPen(QPen(style.curve(0), 2.2));
    painter.drawPath(curve(shown_));
}

} // namespace smat::gui

#include "moc_AngleCurve.cpp"
