#include "gui/image/ColorBar.h"

#include <QComboBox>
#include <QLineEdit>
#include <QPainter>
#include <QVBoxLayout>
#include <QwtScaleEngine>

#include "gui/Theme.h"
#include "gui/plot/PlotData.h"

namespace smat::gui {

/// The strip of colours with its ticks and its title.
class ColorBar::Scale : public QWidget {
  public:
    explicit Scale(ColorBar* bar) : QWidget(bar), bar_(bar) {
        setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Expanding);
        setMinimumHeight(120);
    }
    void setTitle(const QString& title) {
        title_ = title;
        update();
    }

  protected:
    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        const auto style = PlotStyle::screen(palette());
        const QFontMetricsF metrics(font());
        const double margin = metrics.height() / 2.0 + 2.0;
        const QRectF strip(6.0, margin, 22.0, height() - 2.0 * margin);
        const int steps = static_cast<int>(strip.height());
        for (int i = 0; i < steps; ++i) {
            const irsg::Rgb color = bar_->map_->at(1.0 - (i + 0.5) / steps);
            painter.fillRect(QRectF(strip.left(), strip.top() + i, strip.width(), 1.0),
                             QColor(color.red, color.green, color.blue));
        }
        painter.setPen(style.frame);
        painter.drawRect(strip);

        const auto& limits = bar_->limits_;
        const int count = std::max(3, static_cast<int>(strip.height() / (3.0 * metrics.height())));
        const auto ticks = QwtLinearScaleEngine()
                               .divideScale(limits.low, limits.high, count, 0)
                               .ticks(QwtScaleDiv::MajorTick);
        double widest = 0.0;
        for (const double tick : ticks) {
            const double part = (tick - limits.low) / (limits.high - limits.low);
            const double y = strip.bottom() - part * strip.height();
            const QString words = QString::number(tick, 'g', 4);
            painter.setPen(style.frame);
            painter.drawLine(QPointF(strip.right(), y), QPointF(strip.right() + 5.0, y));
            painter.setPen(style.text);
            painter.drawText(QPointF(strip.right() + 9.0, y + metrics.ascent() * 0.36), words);
            widest = std::max(widest, metrics.horizontalAdvance(words));
        }
        painter.setPen(style.text);
        painter.translate(std::min(strip.right() + 9.0 + widest + metrics.height(), width() - 4.0),
                          strip.center().y());
        painter.rotate(-90.0);
        painter.drawText(
            QRectF(-strip.height() / 2.0, -metrics.ascent(), strip.height(), metrics.height()),
            Qt::AlignCenter, title_);
    }

  private:
    ColorBar* bar_;
    QString title_;
};

ColorBar::ColorBar(QWidget* parent) : QWidget(parent) {
    setObjectName("colorBar");
    map_ = &irsg::ColorMap::named(irsg::ColorMap::defaultName);
    setFixedWidth(132);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(8, 0, 0, 0);
    column->setSpacing(6);
    high_ = new QLineEdit(this);
    high_->setObjectName("limitHigh");
    high_->setToolTip(tr("Value of the last colour; brighter pixels have a colour of their own"));
    scale_ = new Scale(this);
    low_ = new QLineEdit(this);
    low_->setObjectName("limitLow");
    low_->setToolTip(tr("Value of the first colour; darker pixels have a colour of their own"));
    mode_ = new QComboBox(this);
    mode_->setObjectName("limitMode");
    mode_->addItems({tr("Target"), tr("Full range"), tr("Locked")});
    mode_->setToolTip(
        tr("How the limits of the colours are found: Target shows the object on its background and "
           "leaves out its few hottest pixels"));
    for (QWidget* widget : {static_cast<QWidget*>(high_), static_cast<QWidget*>(scale_),
                            static_cast<QWidget*>(low_), static_cast<QWidget*>(mode_)})
        column->addWidget(widget);
    column->setStretchFactor(scale_, 1);
    connect(low_, &QLineEdit::editingFinished, this, &ColorBar::readLimits);
    connect(high_, &QLineEdit::editingFinished, this, &ColorBar::readLimits);
    connect(mode_, &QComboBox::activated, this, [this] { emit modeChosen(mode()); });
}

void ColorBar::setTitle(const QString& title) {
    scale_->setTitle(title);
}

void ColorBar::setColors(const irsg::ColorMap& map, const irsg::DisplayLimits& limits) {
    map_ = &map;
    limits_ = limits;
    low_->setText(readableNumber(limits.low));
    high_->setText(readableNumber(limits.high));
    scale_->update();
}

LimitMode ColorBar::mode() const {
    return static_cast<LimitMode>(mode_->currentIndex());
}

void ColorBar::setMode(LimitMode mode) {
    mode_->setCurrentIndex(static_cast<int>(mode));
}

void ColorBar::readLimits() {
    bool lowGood = false;
    bool highGood = false;
    const double low = low_->text().toDouble(&lowGood);
    const double high = high_->text().toDouble(&highGood);
    const bool unchanged = low_->text() == readableNumber(limits_.low) &&
                           high_->text() == readableNumber(limits_.high);
    if (unchanged)
        return;
    if (!lowGood || !highGood || !(low < high)) {
        // What cannot be used gives way to what is in effect.
        setColors(*map_, limits_);
        return;
    }
    setMode(LimitMode::locked);
    setColors(*map_, {low, high});
    emit limitsEdited(limits_);
}

} // namespace smat::gui
