#include "gui/image/FiguresTable.h"

#include <algorithm>

#include <QClipboard>
#include <QGuiApplication>
#include <QHeaderView>
#include <QKeyEvent>
#include <QStyle>
#include <QStyledItemDelegate>

#include "irsg/core/Errors.h"

namespace smat::gui {
namespace {

constexpr int rowPadding_px = 8;

/// Goes on in a second line where the column is too narrow.
class WrappedText : public QStyledItemDelegate {
  public:
    using QStyledItemDelegate::QStyledItemDelegate;

  protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
        QStyledItemDelegate::initStyleOption(option, index);
        option->features |= QStyleOptionViewItem::WrapText;
    }
};

} // namespace

FiguresTable::FiguresTable(QWidget* parent) : QTableWidget(parent) {
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setAlternatingRowColors(true);
    setShowGrid(false);
    setFrameShape(QFrame::NoFrame);
    setWordWrap(false);
    setItemDelegateForColumn(0, new WrappedText(this));
    verticalHeader()->hide();
    verticalHeader()->setDefaultSectionSize(fontMetrics().height() + rowPadding_px);
    horizontalHeader()->setHighlightSections(false);
    horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    horizontalHeader()->setStretchLastSection(true);
    setToolTip(tr("Ctrl+C copies the numbers"));
}

void FiguresTable::setFigures(const QStringList& headings, const QList<QStringList>& rows) {
    setColumnCount(static_cast<int>(headings.size()));
    setHorizontalHeaderLabels(headings);
    setRowCount(static_cast<int>(rows.size()));
    for (int r = 0; r < rows.size(); ++r) {
        if (rows[r].size() != headings.size())
            throw irsg::LogicError("a row of a table has not as many cells as headings");
        for (int c = 0; c < rows[r].size(); ++c) {
            auto* cell = item(r, c);
            if (cell == nullptr) {
                cell = new QTableWidgetItem;
                setItem(r, c, cell);
            }
            cell->setText(rows[r][c]);
            cell->setToolTip(rows[r][c]);
        }
    }
    fitColumns();
}

void FiguresTable::fitColumns() {
    constexpr double namesShare = 0.5;
    for (int c = 0; c + 1 < columnCount(); ++c)
        setColumnWidth(c, std::max(sizeHintForColumn(c), horizontalHeader()->sectionSizeHint(c)));
    int others = 0;
    for (int c = 1; c < columnCount(); ++c)
        others += std::max(sizeHintForColumn(c), horizontalHeader()->sectionSizeHint(c));
    const int width = viewport()->width();
    if (columnCount() > 1)
        setColumnWidth(0, std::min(columnWidth(0),
                                   std::max(static_cast<int>(namesShare * width), width - others)));
    // A name that has less room than it needs goes on in a second line, a number never.
    const int margins = 2 * (style()->pixelMetric(QStyle::PM_FocusFrameHMargin, nullptr, this) + 1);
    const QRect room(0, 0, columnWidth(0) - margins, 10 * fontMetrics().height());
    for (int r = 0; r < rowCount(); ++r)
        setRowHeight(
            r, fontMetrics().boundingRect(room, Qt::TextWordWrap, item(r, 0)->text()).height() +
                   rowPadding_px);
}

void FiguresTable::resizeEvent(QResizeEvent* event) {
    QTableWidget::resizeEvent(event);
    // Rows that are being added have no cells yet; they are fitted when they have.
    if (rowCount() > 0 && item(rowCount() - 1, 0) != nullptr)
        fitColumns();
}

QString FiguresTable::allText() const {
    QStringList lines, headings;
    for (int c = 0; c < columnCount(); ++c)
        headings << horizontalHeaderItem(c)->text();
    lines << headings.join('\t');
    for (int r = 0; r < rowCount(); ++r) {
        QStringList cells;
        for (int c = 0; c < columnCount(); ++c)
            cells << item(r, c)->text();
        lines << cells.join('\t');
    }
    return lines.join('\n') + '\n';
}

void FiguresTable::copy() const {
    const auto ranges = selectedRanges();
    if (selectedItems().size() < 2) {
        QGuiApplication::clipboard()->setText(allText());
        return;
    }
    QStringList lines;
    for (const auto& range : ranges)
        for (int r = range.topRow(); r <= range.bottomRow(); ++r) {
            QStringList cells;
            for (int c = range.leftColumn(); c <= range.rightColumn(); ++c)
                cells << item(r, c)->text();
            lines << cells.join('\t');
        }
    QGuiApplication::clipboard()->setText(lines.join('\n') + '\n');
}

void FiguresTable::keyPressEvent(QKeyEvent* event) {
    if (event->matches(QKeySequence::Copy))
        copy();
    else
        QTableWidget::keyPressEvent(event);
}

} // namespace smat::gui

#include "moc_FiguresTable.cpp"
