#pragma once

#include "gui/widgets/NumericTableView.h"

namespace smat::gui {

class TrajectoryModel;

/// The rows of a trajectory; what is pasted below the last becomes new rows.
class TrajectoryView : public NumericTableView {
    Q_OBJECT

  public:
    explicit TrajectoryView(TrajectoryModel& model, QWidget* parent = nullptr);

    /// Pastes in place of all rows: columns as they stand in the table, in any order of times.
    void pasteAll();
    void copyAll() const;
    void insertRow() override;
    void removeRows() override;

  private:
    QString pasteAt(const QModelIndex& cell, const Rows& block) override;

    TrajectoryModel& model_;
};

} // namespace smat::gui
