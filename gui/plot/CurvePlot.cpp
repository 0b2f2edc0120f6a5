#include "gui/plot/CurvePlot.h"

#include <algorithm>

#include <QPainter>
#include <QWidget>

#include "gui/plot/CrosshairOverlay.h"
#include "gui/plot/CurveItem.h"

namespace smat::gui {

namespace {

/// A sentence in lines of a box beside the cursor.
QStringList wrapped(const QString& sentence) {
    constexpr qsizetype longest = 64;
    QStringList lines{QString()};
    for (const QString& word : sentence.split(' ')) {
        if (!lines.back().isEmpty() && lines.back().size() + word.size() >= longest)
            lines << QString();
        lines.back() += (lines.back().isEmpty() ? "" : " ") + word;
    }
    return lines;
}

} // namespace

void CurvePlot::setCurveVisible(int curve, bool visible) {
    CurveItem* item = items_.at(static_cast<std::size_t>(curve));
    item->setShown(visible);
    QwtText text(curves()[static_cast<std::size_t>(curve)].name);
    text.setColor(visible ? style_.text : style_.faintText);
    item->setName(text);
    redraw();
}

bool CurvePlot::isCurveVisible(int curve) const {
    return items_.at(static_cast<std::size_t>(curve))->isShown();
}

bool CurvePlot::hasErrors() const {
    return std::any_of(curves().begin(), curves().end(),
                       [](const Curve& curve) { return !curve.error.empty(); });
}

void CurvePlot::setErrorBandsVisible(bool visible) {
    errorBands_ = visible;
    for (CurveItem* item : items_)
        item->setBandVisible(visible);
    redraw();
}

QPen CurvePlot::penOf(std::size_t curve) const {
    return QPen(style_.curve(static_cast<int>(curve)), 2.0);
}

void CurvePlot::adopt(CurveItem* item) {
    item->setLine(penOf(items_.size()));
    item->setHollowFill(style_.canvas);
    item->setBandVisible(errorBands_);
    items_.push_back(item);
}

void CurvePlot::dressItems() {
    for (std::size_t i = 0; i < items_.size(); ++i) {
        items_[i]->setLine(penOf(i));
        items_[i]->setHollowFill(style_.canvas);
        setCurveVisible(static_cast<int>(i), items_[i]->isShown());
    }
}

void CurvePlot::toggle(const CurveItem* item) {
    const auto found = std::find(items_.begin(), items_.end(), item);
    if (found != items_.end())
        setCurveVisible(static_cast<int>(found - items_.begin()), !item->isShown());
}

std::vector<bool> CurvePlot::shownCurves() const {
    std::vector<bool> shown;
    for (const CurveItem* item : items_)
        shown.push_back(item->isShown());
    return shown;
}

void CurvePlot::showCurves(const std::vector<bool>& shown) {
    for (std::size_t i = 0; i < std::min(shown.size(), items_.size()); ++i)
        if (!shown[i])
            setCurveVisible(static_cast<int>(i), false);
}

void CurvePlot::showAsIn(const CurvePlot& other) {
    setErrorBandsVisible(other.errorBands_);
    for (int i = 0; i < std::min(curveCount(), other.curveCount()); ++i)
        if (!other.isCurveVisible(i))
            setCurveVisible(i, false);
}

QString CurvePlot::readoutsAt(double at, double period) const {
    QString text;
    for (std::size_t i = 0; i < items_.size(); ++i)
        if (items_[i]->isShown())
            text += "   " + curves()[i].name + ": " + curves()[i].readoutAt(at, period);
    for (const QString& sentence : warningsAt(at, period))
        text += "   " + QObject::tr("warning: %1").arg(sentence);
    return text;
}

QStringList CurvePlot::warningsAt(double at, double period) const {
    QStringList sentences;
    for (std::size_t i = 0; i < items_.size(); ++i) {
        const Curve& curve = curves()[i];
        const QString own =
            items_[i]->isShown() && (period > 0.0 ? curve.valueAt(at, period) : curve.valueAt(at))
                ? curve.warningAt(at, period)
                : QString();
        if (!own.isEmpty() && !sentences.contains(own))
            sentences << own;
    }
    return sentences;
}

void CurvePlot::paintReadouts(
    QPainter& painter, const QPointF& cursor, const QString& heading, double at, double period,
    const std::function<std::optional<QPointF>(double value)>& place) const {
    std::vector<ReadoutLine> lines{{QColor(), heading}};
    for (std::size_t i = 0; i < items_.size(); ++i) {
        const Curve& curve = curves()[i];
        const auto value = period > 0.0 ? curve.valueAt(at, period) : curve.valueAt(at);
        if (!items_[i]->isShown() || !value)
            continue;
        const QColor color = style_.curve(static_cast<int>(i));
        painter.setPen(QPen(style_.canvas, 1.5));
        painter.setBrush(color);
        if (const auto point = place(*value))
            painter.drawEllipse(*point, 4.5, 4.5);
        lines.push_back({color, curve.name + "  " + curve.readoutAt(at, period)});
    }
    for (const QString& sentence : warningsAt(at, period))
        for (const QString& line : wrapped(QObject::tr("warning: %1").arg(sentence)))
            lines.push_back({QColor(), line});
    drawReadoutBox(painter, cursor, sheet()->rect(), lines, style_.background, style_.frame,
                   style_.text);
}

} // namespace smat::gui
