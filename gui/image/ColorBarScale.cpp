#include "gui/image/ColorBarScale.h"

#include <algorithm>

#include <QPainter>

#include "gui/widgets/Theme.h"
#include "irsg/image/AxisTicks.h"

namespace smat::gui {
namespace {

constexpr double left = 6.0, stripWidth = 22.0, swatchHeight = 12.0, swatchPitch = 20.0;

QColor colorOf(const irsg::Rgb& color) {
    return {color.red, color.green, color.blue};
}

QString pixels(std::size_t count) {
    return ColorBar::tr("%1 px").arg(count);
}

} // namespace

ColorBar::Scale::Scale(const ColorBar* bar, QWidget* parent, std::optional<PlotStyle> style)
    : QWidget(parent), bar_(bar), style_(std::move(style)) {
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Expanding);
    setMinimumHeight(45);
}

PlotStyle ColorBar::Scale::style() const {
    return style_.value_or(PlotStyle::screen(palette()));
}

QList<ColorBar::Scale::Swatch> ColorBar::Scale::swatchesBelow() const {
    QList<Swatch> swatches;
    if (bar_->outOfRange_.below > 0)
        swatches << Swatch{bar_->limits_.marksOutside ? bar_->map_->below() : bar_->map_->at(0.0),
                           tr("%1 below").arg(pixels(bar_->outOfRange_.below))};
    if (bar_->outOfRange_.nan > 0)
        swatches << Swatch{bar_->map_->notANumber(),
                           tr("NaN %1").arg(pixels(bar_->outOfRange_.nan))};
    return swatches;
}

void ColorBar::Scale::drawSwatch(QPainter& painter, double top, const Swatch& swatch) const {
    const PlotStyle style = this->style();
    const QRectF box(left, top, stripWidth, swatchHeight);
    painter.fillRect(box, colorOf(swatch.color));
    painter.setPen(style.frame);
    painter.drawRect(box);
    painter.setPen(style.text);
    painter.drawText(
        QRectF(box.right() + 7.0, top - 4.0, width() - box.right() - 7.0, swatchHeight + 8.0),
        Qt::AlignLeft | Qt::AlignVCenter, swatch.words);
}

void ColorBar::Scale::drawStrip(QPainter& painter, const QRectF& strip) const {
    const int steps = static_cast<int>(strip.height());
    for (int i = 0; i < steps; ++i)
        painter.fillRect(QRectF(strip.left(), strip.top() + i, strip.width(), 1.0),
                         colorOf(bar_->map_->at(1.0 - (i + 0.5) / steps)));
    painter.setPen(style().frame);
    painter.drawRect(strip);
}

double ColorBar::Scale::drawTicks(QPainter& painter, const QRectF& strip) const {
    const PlotStyle style = this->style();
    const QFontMetricsF metrics(font());
    const auto& limits = bar_->limits_;
    const auto ticksEvery = [&](double lines) {
        return irsg::axisTicks(
            limits, std::max(2, static_cast<int>(strip.height() / (lines * metrics.height()))));
    };
    // Well apart; closer together where hardly a round number would be left of them.
    irsg::AxisTicks ticks = ticksEvery(2.2);
    if (ticks.values.size() < 3)
        ticks = ticksEvery(1.3);
    double widest = 0.0;
    for (std::size_t i = 0; i < ticks.values.size(); ++i) {
        const double part = limits.position(ticks.values[i]);
        const double y = strip.bottom() - part * strip.height();
        const QString words = QString::fromStdString(ticks.labels[i]);
        painter.setPen(style.frame);
        painter.drawLine(QPointF(strip.right(), y), QPointF(strip.right() + 5.0, y));
        painter.setPen(style.text);
        painter.drawText(QPointF(strip.right() + 9.0, y + metrics.ascent() * 0.36), words);
        widest = std::max(widest, metrics.horizontalAdvance(words));
    }
    if (ticks.exponent != 0)
        painter.drawText(QPointF(strip.right() + 9.0, strip.top() - metrics.height() * 0.75),
                         QStringLiteral("×10") +
                             QString::fromStdString(irsg::superscript(ticks.exponent)));
    return widest;
}

void ColorBar::Scale::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    paint(painter);
}

void ColorBar::Scale::paint(QPainter& painter) const {
    painter.setFont(font());
    const QFontMetricsF metrics(font());

    // Swatches over and under the strip take their room from it.
    double top = metrics.height() * 1.5, bottom = height() - metrics.height() / 2.0 - 2.0;
    if (bar_->outOfRange_.above > 0) {
        drawSwatch(painter, 2.0,
                   {bar_->limits_.marksOutside ? bar_->map_->above() : bar_->map_->at(1.0),
                    tr("%1 above").arg(pixels(bar_->outOfRange_.above))});
        top += swatchPitch * 0.7;
    }
    const QList<Swatch> below = swatchesBelow();
    bottom -= swatchPitch * static_cast<double>(below.size());
    double next = bottom + swatchPitch * 0.6;
    for (const Swatch& swatch : below) {
        drawSwatch(painter, next, swatch);
        next += swatchPitch;
    }

    const QRectF strip(left, top, stripWidth, std::max(bottom - top, 10.0));
    drawStrip(painter, strip);
    const double widest = drawTicks(painter, strip);

    // The title, upwards beside the ticks, cut where there is no room for it.
    painter.setPen(style().text);
    painter.translate(std::min(strip.right() + 9.0 + widest + metrics.height(), width() - 4.0),
                      strip.center().y());
    painter.rotate(-90.0);
    painter.drawText(
        QRectF(-strip.height() / 2.0, -metrics.ascent(), strip.height(), metrics.height()),
        Qt::AlignCenter, metrics.elidedText(bar_->title_, Qt::ElideMiddle, strip.height()));
}

} // namespace smat::gui
