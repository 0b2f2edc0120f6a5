#pragma once

#include <set>

#include <QTableView>

namespace smat::gui {

class TrajectoryModel;

/// The rows of a trajectory as a person edits them: cells are checked while one types, blocks are
/// pasted from and copied to spreadsheets (Ctrl+V, Ctrl+C), rows inserted (Insert) and removed
/// (Delete).
class TrajectoryView : public QTableView {
    Q_OBJECT

  public:
    explicit TrajectoryView(TrajectoryModel& model, QWidget* parent = nullptr);

    /// Pastes as spreadsheets do, from the current cell right and down; rows are added at the end.
    void paste();
    /// Pastes in place of all rows: columns as they stand in the table, in any order of times.
    void pasteAll();
    /// The chosen cells, tabs between columns.
    void copy() const;
    void copyAll() const;
    void insertRow();
    void removeRows();

  signals:
    /// What is wrong with what is being typed or was pasted; empty when all is well again.
    void problem(const QString& sentence);

  protected:
    void keyPressEvent(QKeyEvent* event) override;

  private:
    void copyCells(const std::set<int>& rows, const std::set<int>& columns) const;

    TrajectoryModel& model_;
};

} // namespace smat::gui
