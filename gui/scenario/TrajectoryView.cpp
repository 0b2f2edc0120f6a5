#include "gui/scenario/TrajectoryView.h"

#include <algorithm>

#include <QApplication>
#include <QClipboard>
#include <QHeaderView>
#include <QKeyEvent>

#include "gui/database/Nodes.h"
#include "gui/scenario/TrajectoryModel.h"
#include "gui/widgets/CheckedCell.h"

namespace smat::gui {
namespace {

/// All numbers from 0 below `count`.
std::set<int> firstNumbers(int count) {
    std::set<int> numbers;
    for (int i = 0; i < count; ++i)
        numbers.insert(i);
    return numbers;
}

} // namespace

TrajectoryView::TrajectoryView(TrajectoryModel& model, QWidget* parent)
    : QTableView(parent), model_(model) {
    setObjectName("trajectoryTable");
    setAccessibleName(tr("Trajectory"));
    setModel(&model_);
    setItemDelegate(new CheckedCell(
        "trajectoryCell",
        [this](const QModelIndex& cell, const QString& text) {
            return model_.problemOf(cell, text);
        },
        [this](const QString& sentence) { emit problem(sentence); }, this));
    setSelectionMode(QAbstractItemView::ContiguousSelection);
    setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed |
                    QAbstractItemView::AnyKeyPressed);
    setAlternatingRowColors(true);
    setFrameShape(QFrame::NoFrame);
    setShowGrid(false);
    setTabKeyNavigation(false);
    horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    horizontalHeader()->setMinimumSectionSize(fontMetrics().horizontalAdvance("00000.0"));
    horizontalHeader()->setHighlightSections(false);
    verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 8);
    verticalHeader()->setDefaultAlignment(Qt::AlignCenter);
    setMinimumHeight(5 * (fontMetrics().height() + 8));
}

void TrajectoryView::paste() {
    const PastedRows pasted = rowsOf(QApplication::clipboard()->text());
    if (!pasted.problem.isEmpty()) {
        emit problem(pasted.problem);
        return;
    }
    const int columns = static_cast<int>(pasted.rows.front().size());
    const QModelIndex from = currentIndex().isValid() ? currentIndex() : model_.index(0, 0);
    if (from.column() + columns > model_.columnCount()) {
        emit problem(tr("%1 columns do not fit: from this one on the table has %2")
                         .arg(columns)
                         .arg(model_.columnCount() - from.column()));
        return;
    }
    emit problem(model_.pasteAt(from.row(), from.column(), pasted.rows));
}

void TrajectoryView::pasteAll() {
    const PastedRows pasted = rowsOf(QApplication::clipboard()->text());
    if (!pasted.problem.isEmpty()) {
        emit problem(pasted.problem);
        return;
    }
    const int columns = static_cast<int>(pasted.rows.front().size());
    if (columns != model_.columnCount()) {
        emit problem(tr("the table has %1 columns; these rows have %2")
                         .arg(model_.columnCount())
                         .arg(columns));
        return;
    }
    emit problem(model_.takeAll(pasted.rows));
}

void TrajectoryView::copyCells(const std::set<int>& rows, const std::set<int>& columns) const {
    QString text;
    for (const int row : rows) {
        QStringList cells;
        for (const int column : columns)
            cells << model_.index(row, column).data().toString();
        text += cells.join('\t') + '\n';
    }
    QApplication::clipboard()->setText(text);
}

void TrajectoryView::copy() const {
    std::set<int> rows, columns;
    for (const QModelIndex& index : selectionModel()->selectedIndexes()) {
        // The row to add to holds nothing.
        if (index.row() + 1 < model_.rowCount())
            rows.insert(index.row());
        columns.insert(index.column());
    }
    if (!rows.empty())
        copyCells(rows, columns);
}

void TrajectoryView::copyAll() const {
    copyCells(firstNumbers(model_.rowCount() - 1), firstNumbers(model_.columnCount()));
}

void TrajectoryView::insertRow() {
    const int row = currentIndex().isValid() ? currentIndex().row() : model_.rowCount() - 1;
    const int column = std::max(currentIndex().column(), 0);
    emit problem(model_.insertRow(row));
    setCurrentIndex(model_.index(row, column));
}

void TrajectoryView::removeRows() {
    std::set<int> rows;
    for (const QModelIndex& index : selectionModel()->selectedIndexes())
        rows.insert(index.row());
    const int first = rows.empty() ? 0 : *rows.begin();
    const int column = std::max(currentIndex().column(), 0);
    emit problem(model_.removeRows({rows.begin(), rows.end()}));
    setCurrentIndex(model_.index(std::min(first, model_.rowCount() - 1), column));
}

void TrajectoryView::keyPressEvent(QKeyEvent* event) {
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

#include "moc_TrajectoryView.cpp"
