#include "gui/analysis/ResultItemDelegate.h"

#include <QApplication>
#include <QPainter>

namespace smat::gui {
namespace {

constexpr int margin = 6;
constexpr int iconSize = 20;

QRect textArea(const QRect& row) {
    return row.adjusted(2 * margin + iconSize, margin, -margin, -margin);
}

QFont detailFont(QFont font) {
    font.setPointSizeF(font.pointSizeF() * 0.88);
    return font;
}

} // namespace

void ResultItemDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                               const QModelIndex& index) const {
    QStyleOptionViewItem row = option;
    initStyleOption(&row, index);
    row.text.clear();
    row.icon = {};
    const QStyle* style = row.widget != nullptr ? row.widget->style() : QApplication::style();
    style->drawControl(QStyle::CE_ItemViewItem, &row, painter, row.widget);

    const bool selected = (option.state & QStyle::State_Selected) != 0;
    const QRect area = textArea(option.rect);
    const QFontMetrics metrics(option.font);
    const auto elided = [&](const QFontMetrics& of, const QString& text) {
        return of.elidedText(text, Qt::ElideRight, area.width());
    };
    painter->save();
    qvariant_cast<QIcon>(index.data(Qt::DecorationRole))
        .paint(painter, QRect(option.rect.left() + margin, option.rect.center().y() - iconSize / 2,
                              iconSize, iconSize));
    painter->setPen(
        option.palette.color(selected ? QPalette::HighlightedText : QPalette::WindowText));
    painter->drawText(QRect(area.topLeft(), QSize(area.width(), metrics.height())),
                      Qt::AlignLeft | Qt::AlignVCenter, elided(metrics, index.data().toString()));
    painter->setFont(detailFont(option.font));
    if (!selected)
        painter->setPen(option.palette.color(QPalette::PlaceholderText));
    painter->drawText(area, Qt::AlignLeft | Qt::AlignBottom,
                      elided(QFontMetrics(painter->font()), index.data(detailRole).toString()));
    painter->restore();
}

QSize ResultItemDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const {
    const int lines =
        QFontMetrics(option.font).height() + QFontMetrics(detailFont(option.font)).height();
    return {120, lines + 2 * margin + 2};
}

void ResultItemDelegate::updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                                              const QModelIndex&) const {
    QRect area = option.rect;
    area.setLeft(textArea(option.rect).left() - 4);
    editor->setGeometry(area);
}

} // namespace smat::gui

#include "moc_ResultItemDelegate.cpp"
