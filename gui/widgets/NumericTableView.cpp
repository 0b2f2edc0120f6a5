#include "gui/widgets/NumericTableView.h"

#include <utility>

#include <QApplication>
#include <QClipboard>
#include <QHeaderView>
#include <QKeyEvent>

#include "gui/widgets/NumberText.h"

namespace smat::gui {

NumericTableView::NumericTableView(QAbstractItemModel& model, const QString& cell,
                                   CheckedCell::Check problemOf, QWidget* parent)
    : QTableView(parent) {
    setModel(&model);
    setItemDelegate(new CheckedCell(
        cell, std::move(problemOf), [this](const QString& sentence) { emit problem(sentence); },
        this));
    setReadOnly(false);
    setSelectionMode(QAbstractItemView::ExtendedSelection);
    setAlternatingRowColors(true);
    setFrameShape(QFrame::NoFrame);
    setShowGrid(false);
    setTabKeyNavigation(false);
    horizontalHeader()->setHighlightSections(false);
    verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 8);
    verticalHeader()->setDefaultAlignment(Qt::AlignCenter);
}

void NumericTableView::setReadOnly(bool readOnly) {
    readOnly_ = readOnly;
    setEditTriggers(readOnly
                        ? QAbstractItemView::NoEditTriggers
                        : QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed |
                              QAbstractItemView::AnyKeyPressed);
}

std::set<int> NumericTableView::chosenRows() const {
    std::set<int> rows;
    for (const QModelIndex& index : selectionModel()->selectedIndexes())
        rows.insert(index.row());
    return rows;
}

std::optional<NumericTableView::Rows> NumericTableView::clipboardRows() {
    PastedRows pasted = rowsOf(QApplication::clipboard()->text());
    if (pasted.problem.isEmpty())
        return std::move(pasted.rows);
    emit problem(pasted.problem);
    return std::nullopt;
}

void NumericTableView::paste() {
    if (readOnly_)
        return;
    const QModelIndex cell = currentIndex().isValid() ? currentIndex() : model()->index(0, 0);
    if (const auto block = clipboardRows())
        emit problem(pasteAt(cell, *block));
}

void NumericTableView::copyCells(const std::set<int>& rows, const std::set<int>& columns) const {
    QString text;
    for (const int row : rows) {
        QStringList cells;
        for (const int column : columns)
            cells << model()->index(row, column).data().toString();
        text += cells.join('\t') + '\n';
    }
    QApplication::clipboard()->setText(text);
}

void NumericTableView::copy() const {
    std::set<int> rows = chosenRows(), columns;
    // A row to add to holds nothing.
    std::erase_if(rows, [this](int row) { return !model()->index(row, 0).data().isValid(); });
    for (const QModelIndex& index : selectionModel()->selectedIndexes())
        columns.insert(index.column());
    if (!rows.empty())
        copyCells(rows, columns);
}

void NumericTableView::keyPressEvent(QKeyEvent* event) {
    if (event->matches(QKeySequence::Copy))
        copy();
    else if (event->matches(QKeySequence::Paste))
        paste();
    else if (event->key() == Qt::Key_Delete)
        removeRows();
    else if (event->key() == Qt::Key_Insert)
        insertRow();
    else
        QTableView::keyPressEvent(event);
}

} // namespace smat::gui

#include "moc_NumericTableView.cpp"
