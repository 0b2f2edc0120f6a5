#include "gui/image/ColorBar.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QPainter>
#include <QVBoxLayout>

#include "gui/image/ColorBarScale.h"
#include "gui/widgets/NumberBoxes.h"
#include "gui/widgets/NumberFormat.h"
#include "gui/widgets/NumberText.h"
#include "gui/widgets/RefusedText.h"
#include "irsg/core/Errors.h"

namespace smat::gui {
namespace {

QString modeWord(LimitMode mode) {
    switch (mode) {
    case LimitMode::target:
        return ColorBar::tr("Target");
    case LimitMode::full:
        return ColorBar::tr("Full range");
    case LimitMode::percentile:
        return ColorBar::tr("Percentiles");
    case LimitMode::locked:
        return ColorBar::tr("Locked");
    }
    return {};
}

QString scaleWord(irsg::ColorScale scale) {
    switch (scale) {
    case irsg::ColorScale::automatic:
        return ColorBar::tr("Automatic");
    case irsg::ColorScale::linear:
        return ColorBar::tr("Linear");
    case irsg::ColorScale::squareRoot:
        return ColorBar::tr("Square root");
    case irsg::ColorScale::logarithmic:
        return ColorBar::tr("Logarithmic");
    case irsg::ColorScale::equalized:
        return ColorBar::tr("Equalized");
    }
    return {};
}

/// Of the scale that was found to show the object.
QString chosenWord(irsg::ColorScale scale) {
    return ColorBar::tr("Auto: %1").arg(scaleWord(scale).toLower());
}

} // namespace

ColorBar::ColorBar(QWidget* parent, const QList<LimitMode>& modes) : QWidget(parent) {
    setObjectName("colorBar");
    map_ = &irsg::ColorMap::named(irsg::ColorMap::defaultName);
    high_ = new QLineEdit(this);
    high_->setObjectName("limitHigh");
    high_->setToolTip(tr("Value of the last colour, which brighter pixels have, too"));
    scale_ = new Scale(this, this);
    low_ = new QLineEdit(this);
    low_->setObjectName("limitLow");
    low_->setToolTip(tr("Value of the first colour, which darker pixels have, too"));
    mode_ = new QComboBox(this);
    mode_->setObjectName("limitMode");
    for (const LimitMode mode : modes)
        mode_->addItem(modeWord(mode), static_cast<int>(mode));
    mode_->setToolTip(
        tr("How the limits of the colours are found: Target shows the object on its background, "
           "with a linear scale without its few hottest pixels, Percentiles leave out what is "
           "typed in, Locked keeps them whatever is shown"));
    makeScaleBox();
    constexpr int leastWidth_px = 136, aroundWords_px = 50;
    setFixedWidth(std::max(
        leastWidth_px, fontMetrics().horizontalAdvance(chosenWord(irsg::ColorScale::logarithmic)) +
                           aroundWords_px));
    makeMarks();
    lowPercent_ = percentBox("percentLow", 1.0, tr("Percentile of the first colour"));
    highPercent_ = percentBox("percentHigh", 99.0, tr("Percentile of the last colour"));
    layOut();
    showPercentiles();
    connectParts();
}

void ColorBar::makeScaleBox() {
    colorScale_ = new QComboBox(this);
    colorScale_->setObjectName("colorScale");
    for (const std::string& name : irsg::colorScaleNames()) {
        const irsg::ColorScale scale = irsg::colorScaleNamed(name);
        colorScale_->addItem(scaleWord(scale), static_cast<int>(scale));
    }
    colorScale_->setToolTip(
        tr("How colours follow values: Square root and Logarithmic show what is dim beside what "
           "glows, Equalized gives every colour the same number of pixels; Automatic is linear "
           "where that shows the object, else square root or logarithmic"));
}

void ColorBar::makeMarks() {
    marks_ = new QCheckBox(tr("Mark outside"), this);
    marks_->setObjectName("markOutside");
    marks_->setToolTip(
        tr("Pixels outside of the limits have colours of their own; else those of the ends"));
}

QDoubleSpinBox* ColorBar::percentBox(const QString& name, double value, const QString& tip) {
    auto* box = new RealBox(name, "%", this);
    box->setRange(0.0, 100.0);
    box->setDecimals(1);
    box->setSingleStep(0.5);
    box->setValue(value);
    box->setButtonSymbols(QAbstractSpinBox::NoButtons);
    box->setToolTip(tip);
    box->setMinimumWidth(40);
    connect(box, &QDoubleSpinBox::valueChanged, this, &ColorBar::readPercentiles);
    return box;
}

void ColorBar::layOut() {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(8, 0, 0, 0);
    column->setSpacing(6);
    auto* percents = new QHBoxLayout;
    percents->setSpacing(4);
    percents->addWidget(lowPercent_);
    percents->addWidget(highPercent_);
    for (QWidget* widget : {static_cast<QWidget*>(high_), static_cast<QWidget*>(scale_),
                            static_cast<QWidget*>(low_), static_cast<QWidget*>(colorScale_),
                            static_cast<QWidget*>(marks_), static_cast<QWidget*>(mode_)})
        column->addWidget(widget);
    column->addLayout(percents);
    column->setStretchFactor(scale_, 1);
}

void ColorBar::connectParts() {
    connect(low_, &QLineEdit::editingFinished, this, &ColorBar::readLimits);
    connect(high_, &QLineEdit::editingFinished, this, &ColorBar::readLimits);
    connect(colorScale_, &QComboBox::activated, this, [this] {
        limits_ = {limits_.low, limits_.high, shownScale(), {}, marksOutside()};
        emit scaleChosen(scale());
    });
    connect(marks_, &QCheckBox::toggled, this, [this](bool marks) {
        limits_.marksOutside = marks;
        scale_->update();
        emit marksChosen(marks);
    });
    connect(mode_, &QComboBox::activated, this, [this] {
        showPercentiles();
        emit modeChosen(mode());
    });
}

void ColorBar::setTitle(const QString& title) {
    title_ = title;
    scale_->setToolTip(title);
    scale_->update();
}

void ColorBar::setColors(const irsg::ColorMap& map, const irsg::DisplayLimits& limits) {
    map_ = &map;
    limits_ = limits;
    colorScale_->setItemText(colorScale_->findData(static_cast<int>(irsg::ColorScale::automatic)),
                             chosenWord(limits.scale));
    low_->setText(formattedNumber(limits.low));
    high_->setText(formattedNumber(limits.high));
    scale_->update();
}

void ColorBar::setOutOfRange(const OutOfRange& counts) {
    outOfRange_ = counts;
    scale_->update();
}

irsg::ColorScale ColorBar::scale() const {
    return static_cast<irsg::ColorScale>(colorScale_->currentData().toInt());
}

void ColorBar::setScale(irsg::ColorScale scale) {
    colorScale_->setCurrentIndex(colorScale_->findData(static_cast<int>(scale)));
}

void ColorBar::hideScale() {
    colorScale_->hide();
}

void ColorBar::drawLegend(QPainter& painter, QSize size, const PlotStyle& style,
                          const QFont& font) const {
    Scale twin(this, nullptr, style);
    twin.setFont(font);
    twin.resize(size);
    painter.save();
    twin.paint(painter);
    painter.restore();
}

ColorRule ColorBar::rule() const {
    return {mode(), percentiles(), scale(), marksOutside()};
}

irsg::ColorScale ColorBar::shownScale() const {
    return scale() == irsg::ColorScale::automatic ? limits_.scale : scale();
}

bool ColorBar::marksOutside() const {
    return marks_->isChecked();
}

void ColorBar::setMarksOutside(bool marks) {
    const QSignalBlocker quiet(marks_);
    marks_->setChecked(marks);
    limits_.marksOutside = marks;
    scale_->update();
}

LimitMode ColorBar::mode() const {
    return static_cast<LimitMode>(mode_->currentData().toInt());
}

void ColorBar::setMode(LimitMode mode) {
    mode_->setCurrentIndex(mode_->findData(static_cast<int>(mode)));
    showPercentiles();
}

std::pair<double, double> ColorBar::percentiles() const {
    return {lowPercent_->value(), highPercent_->value()};
}

void ColorBar::setPercentiles(double low, double high) {
    lowPercent_->setValue(low);
    highPercent_->setValue(high);
}

void ColorBar::askUpperPercentileAlone() {
    upperAlone_ = true;
    highPercent_->setToolTip(tr("Fraction of the pixels within the limits of the colours"));
    showPercentiles();
}

void ColorBar::showPercentiles() {
    const bool used = mode() == LimitMode::percentile;
    lowPercent_->setVisible(used && !upperAlone_);
    highPercent_->setVisible(used);
}

void ColorBar::readPercentiles() {
    // The one that was not typed gives way, so that the lower is below the upper.
    if (!(lowPercent_->value() < highPercent_->value())) {
        const bool lowTyped = sender() == lowPercent_;
        const double low = std::min(lowPercent_->value(), 99.9);
        const double high = std::max(highPercent_->value(), 0.1);
        const QSignalBlocker quietLow(lowPercent_), quietHigh(highPercent_);
        lowPercent_->setValue(lowTyped ? low : high - 0.1);
        highPercent_->setValue(lowTyped ? low + 0.1 : high);
    }
    emit modeChosen(mode());
}

void ColorBar::edit(const irsg::DisplayLimits& limits) {
    if (!(limits.low < limits.high) || !std::isfinite(limits.low) || !std::isfinite(limits.high))
        throw irsg::LogicError("limits of colours are not in order");
    setMode(LimitMode::locked);
    setColors(*map_, {limits.low, limits.high, shownScale(), {}, marksOutside()});
    emit limitsEdited(limits_);
}

void ColorBar::changeExposure(double stops) {
    const double factor = std::exp2(-stops);
    const irsg::DisplayLimits limits =
        map_->isDiverging()
            ? irsg::DisplayLimits{limits_.low * factor, limits_.high * factor}
            : irsg::DisplayLimits{limits_.low, limits_.low + (limits_.high - limits_.low) * factor};
    if (limits.low < limits.high && std::isfinite(limits.high))
        edit(limits);
}

void ColorBar::changeOffset(double part) {
    const double by = part * (limits_.high - limits_.low);
    if (limits_.low + by < limits_.high + by)
        edit({limits_.low + by, limits_.high + by});
}

void ColorBar::readLimits() {
    const TypedNumber low = typedNumber(low_->text()), high = typedNumber(high_->text());
    const bool unchanged = low_->text() == formattedNumber(limits_.low) &&
                           high_->text() == formattedNumber(limits_.high);
    if (unchanged)
        return;
    if (!low.value || !high.value || !(*low.value < *high.value)) {
        QLineEdit& wrong = !low.value || high.value ? *low_ : *high_;
        sayRefused(wrong,
                   !low.value    ? low.problem
                   : !high.value ? high.problem
                                 : tr("the lower limit has to be below the upper one"),
                   formattedNumber(&wrong == low_ ? limits_.low : limits_.high));
        setColors(*map_, limits_);
        return;
    }
    edit({*low.value, *high.value});
}

} // namespace smat::gui

#include "moc_ColorBar.cpp"
