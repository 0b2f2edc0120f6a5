#include "gui/image/IndexLegend.h"

#include <QFontMetricsF>
#include <QPainter>

#include "gui/widgets/Theme.h"

namespace smat::gui {
namespace {

constexpr int swatch_px = 14;

QIcon swatchOf(const QColor& color) {
    QPixmap pixmap(swatch_px, swatch_px);
    pixmap.fill(color);
    return QIcon(pixmap);
}

} // namespace

IndexLegend::IndexLegend(QWidget* parent) : QListWidget(parent) {
    setObjectName("indexLegend");
    setFrameShape(QFrame::NoFrame);
    setIconSize(QSize(swatch_px, swatch_px));
    setSelectionMode(QAbstractItemView::SingleSelection);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setTextElideMode(Qt::ElideMiddle);
    setFixedWidth(190);
    setFocusPolicy(Qt::TabFocus);
}

void IndexLegend::setIndices(const QString& title, std::vector<SeenIndex> seen) {
    title_ = title;
    seen_ = std::move(seen);
    clear();
    setAccessibleName(title);
    for (const SeenIndex& one : seen_) {
        auto* item = new QListWidgetItem(swatchOf(one.color), one.words(), this);
        item->setToolTip(tr("%1: %2 pixels").arg(one.words()).arg(one.pixels));
    }
}

void IndexLegend::mark(std::optional<int> index) {
    int row = -1;
    for (std::size_t i = 0; index && i < seen_.size(); ++i)
        if (seen_[i].index == *index)
            row = static_cast<int>(i);
    setCurrentRow(row);
}

void IndexLegend::drawLegend(QPainter& painter, QSize size, const PlotStyle& style,
                             const QFont& font) const {
    painter.setFont(font);
    const QFontMetricsF metrics(font);
    const double line = 1.35 * metrics.height(), side = 0.8 * metrics.height();
    const auto write = [&](double x, double y, const QString& text) {
        const double width = size.width() - x;
        painter.setPen(style.text);
        painter.drawText(QRectF(x, y, width, line), Qt::AlignLeft | Qt::AlignVCenter,
                         metrics.elidedText(text, Qt::ElideRight, width));
    };
    write(0.0, 0.0, title_);
    const auto room = std::max<std::size_t>(static_cast<std::size_t>(size.height() / line), 3) - 2;
    double y = line;
    for (std::size_t i = 0; i < seen_.size() && i < room; ++i, y += line) {
        painter.fillRect(QRectF(0.0, y + 0.5 * (line - side), side, side), seen_[i].color);
        write(1.5 * side, y, seen_[i].words());
    }
    if (seen_.size() > room)
        write(0.0, y, tr("and %1 more").arg(seen_.size() - room));
}

} // namespace smat::gui

#include "moc_IndexLegend.cpp"
