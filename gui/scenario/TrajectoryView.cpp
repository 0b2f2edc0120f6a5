#include "gui/scenario/TrajectoryView.h"

#include <algorithm>

#include <QHeaderView>

#include "gui/scenario/TrajectoryModel.h"

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
    : NumericTableView(
          model, "trajectoryCell",
          [&model](const QModelIndex& cell, const QString& text) {
              return model.problemOf(cell, text);
          },
          parent),
      model_(model) {
    setObjectName("trajectoryTable");
    setAccessibleName(tr("Trajectory"));
    setSelectionMode(QAbstractItemView::ContiguousSelection);
    horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    horizontalHeader()->setMinimumSectionSize(fontMetrics().horizontalAdvance("00000.0"));
    setMinimumHeight(5 * (fontMetrics().height() + 8));
}

QString TrajectoryView::pasteAt(const QModelIndex& cell, const Rows& block) {
    const int columns = static_cast<int>(block.front().size());
    if (cell.column() + columns > model_.columnCount())
        return tr("%1 columns do not fit: from this one on the table has %2")
            .arg(columns)
            .arg(model_.columnCount() - cell.column());
    return model_.pasteAt(cell.row(), cell.column(), block);
}

void TrajectoryView::pasteAll() {
    const auto rows = clipboardRows();
    if (!rows)
        return;
    const int columns = static_cast<int>(rows->front().size());
    if (columns != model_.columnCount()) {
        emit problem(tr("the table has %1 columns; these rows have %2")
                         .arg(model_.columnCount())
                         .arg(columns));
        return;
    }
    emit problem(model_.takeAll(*rows));
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
    const std::set<int> rows = chosenRows();
    const int first = rows.empty() ? 0 : *rows.begin();
    const int column = std::max(currentIndex().column(), 0);
    emit problem(model_.removeRows({rows.begin(), rows.end()}));
    setCurrentIndex(model_.index(std::min(first, model_.rowCount() - 1), column));
}

} // namespace smat::gui

#include "moc_TrajectoryView.cpp"
