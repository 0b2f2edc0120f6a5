#include "gui/analysis/RankingBars.h"

#include <algorithm>
#include <cmath>

#include <QHelpEvent>
#include <QPainter>
#include <QPen>
#include <QToolTip>

#include "gui/plot/PlotLook.h"
#include "gui/widgets/Theme.h"

namespace smat::gui {

namespace {

constexpr int barMargin = 12, titleHeight = 26, captionHeight = 36, axisHeight = 22 + captionHeight;

QString percent(const Estimate& estimate) {
    return QString::number(100.0 * estimate.value, 'f', 1);
}

} // namespace

RankingBars::RankingBars(QWidget* parent) : QWidget(parent) {
    setObjectName("rankingBars");
    setMouseTracking(true);
}

void RankingBars::setBars(std::vector<RankingBar> bars) {
    bars_ = std::move(bars);
    update();
}

void RankingBars::setHint(const QString& hint) {
    hint_ = hint;
    update();
}

RankingBars::Axis RankingBars::axis() const {
    double least = 0.0, most = 0.1;
    for (const RankingBar& bar : bars_) {
        least = std::min({least, bar.firstOrder.value, bar.firstOrder.low95, bar.total.value});
        most = std::max({most, bar.firstOrder.high95, bar.total.value});
    }
    const double span = most - least;
    const double step = span > 0.5 ? 0.2 : span > 0.2 ? 0.1 : 0.05;
    return {std::max(step * std::floor(least / step), -0.6),
            std::min(step * std::ceil(most / step), 1.2), step};
}

int RankingBars::rowHeight() const {
    const int room = height() - 2 * barMargin - titleHeight - axisHeight;
    return std::clamp(room / std::max(static_cast<int>(bars_.size()), 1), fontMetrics().height(),
                      30);
}

QString RankingBars::caption() const {
    const bool hasBelow = std::ranges::any_of(bars_, [](const RankingBar& bar) {
        return bar.firstOrder.value < 0.0 || bar.total.value < 0.0;
    });
    const QString words = tr("Sobol' index (% of the variance)");
    return hasBelow ? words + tr("; estimates of small ones may be below 0") : words;
}

void RankingBars::paintEvent(QPaintEvent*) {
    const PlotStyle style = PlotStyle::screen(palette());
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), style.background);
    painter.setFont(plotFont(1.0, true));
    painter.setPen(style.text);
    painter.drawText(QRect(barMargin, barMargin, width() - 2 * barMargin, titleHeight),
                     Qt::AlignCenter, tr("Share of the spread by scale"));
    painter.setFont(plotFont());
    if (bars_.empty()) {
        painter.setPen(style.faintText);
        painter.drawText(
            rect().adjusted(barMargin, barMargin + titleHeight, -barMargin, -barMargin),
            Qt::AlignCenter | Qt::TextWordWrap, hint_);
        return;
    }

    // Names take what they need, at most half.
    const QFontMetrics metrics(painter.font());
    int names = 0;
    for (const RankingBar& bar : bars_)
        names = std::max(names, metrics.horizontalAdvance(bar.name));
    names = std::min(names, width() / 2);
    const auto [least, most, step] = axis();
    const int left = barMargin + names + 8, right = width() - barMargin - 44;
    const int top = barMargin + titleHeight;
    const int row = rowHeight();
    const int rows =
        std::min(static_cast<int>(bars_.size()), (height() - barMargin - axisHeight - top) / row);
    const int bottom = top + rows * row;
    const auto xOf = [&](double share) {
        return left + (right - left) * std::clamp((share - least) / (most - least), 0.0, 1.0);
    };

    for (double share = least; share <= most + 1e-9; share += step) {
        painter.setPen(QPen(style.grid, 1.0));
        painter.drawLine(QPointF(xOf(share), top), QPointF(xOf(share), bottom));
        painter.setPen(style.text);
        painter.drawText(QRectF(xOf(share) - 30, bottom + 2, 60, 16), Qt::AlignCenter,
                         QString::number(std::round(100.0 * share), 'f', 0));
    }
    if (least < 0.0) {
        painter.setPen(QPen(style.text, 1.0));
        painter.drawLine(QPointF(xOf(0.0), top), QPointF(xOf(0.0), bottom));
    }
    painter.drawText(QRectF(barMargin, bottom + 20, width() - 2.0 * barMargin, captionHeight),
                     Qt::AlignHCenter | Qt::AlignTop | Qt::TextWordWrap, caption());

    for (int i = 0; i < rows; ++i) {
        const RankingBar& bar = bars_[static_cast<std::size_t>(i)];
        const double y = top + i * row, middle = y + 0.5 * row, thickness = 0.62 * row;
        painter.setPen(style.text);
        painter.drawText(QRectF(barMargin, y, names, row), Qt::AlignRight | Qt::AlignVCenter,
                         metrics.elidedText(bar.name, Qt::ElideMiddle, names));
        const auto rectTo = [&](double share) {
            return QRectF(xOf(0.0), middle - 0.5 * thickness, xOf(share) - xOf(0.0), thickness)
                .normalized();
        };
        QColor color = style.curve(0);
        painter.setPen(Qt::NoPen);
        painter.setBrush(color);
        painter.drawRect(rectTo(bar.firstOrder.value));
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(color, 1.0));
        painter.drawRect(rectTo(bar.total.value));
        // The interval of the first-order index.
        painter.setPen(QPen(style.text, 1.2));
        const double low = xOf(bar.firstOrder.low95), high = xOf(bar.firstOrder.high95);
        painter.drawLine(QPointF(low, middle), QPointF(high, middle));
        for (const double x : {low, high})
            painter.drawLine(QPointF(x, middle - 3), QPointF(x, middle + 3));
        painter.drawText(QRectF(std::max(high, xOf(bar.total.value)) + 6, y, 60, row),
                         Qt::AlignLeft | Qt::AlignVCenter, percent(bar.firstOrder));
    }
}

bool RankingBars::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip)
        return QWidget::event(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    const int i = (help->pos().y() - barMargin - titleHeight) / rowHeight();
    if (help->pos().y() < barMargin + titleHeight || i >= static_cast<int>(bars_.size())) {
        QToolTip::hideText();
        return true;
    }
    const RankingBar& bar = bars_[static_cast<std::size_t>(i)];
    const auto words = [](const Estimate& estimate) {
        return tr("%1 % (95 %: %2 to %3 %)")
            .arg(percent(estimate))
            .arg(100.0 * estimate.low95, 0, 'f', 1)
            .arg(100.0 * estimate.high95, 0, 'f', 1);
    };
    QToolTip::showText(
        help->globalPos(),
        tr("%1\nalone: %2\nwith others: %3").arg(bar.name, words(bar.firstOrder), words(bar.total)),
        this);
    return true;
}

} // namespace smat::gui

#include "moc_RankingBars.cpp"
