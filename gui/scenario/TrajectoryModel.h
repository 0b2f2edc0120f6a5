#pragma once

#include <QAbstractTableModel>

#include "smatcore/simulate/Trajectory.h"

namespace smat::gui {

/// The points of one trajectory as rows of numbers, with an empty row at the end to add to. Takes
/// what a file may hold: numbers of their range, at times that ascend; a row whose time is changed
/// goes to its place among them.
class TrajectoryModel : public QAbstractTableModel {
    Q_OBJECT

  public:
    explicit TrajectoryModel(QObject* parent = nullptr);

    void setTable(const TrajectoryTable& table);
    const TrajectoryTable& table() const { return table_; }
    TrajectoryTable::Column columnAt(int section) const;

    /// Why a text cannot stand in a cell; empty where it can.
    QString problemOf(const QModelIndex& cell, const QString& text) const;
    /// Takes rows as an edit by the user: answers why they cannot be, or emits `edited`. They need
    /// not be in the order of their times.
    QString take(std::vector<TrajectoryTable::Row> rows, const QString& step);
    /// Inserts the row halfway between this one and the one before; before the first and behind the
    /// last one as far off as its neighbour.
    QString insertRow(int row);
    QString removeRows(const std::vector<int>& rows);
    /// Puts a block of numbers at a cell, below the last row as new rows.
    QString pasteAt(int row, int column, const std::vector<std::vector<double>>& block);
    /// Rows of numbers in the columns of the table take the place of all.
    QString takeAll(const std::vector<std::vector<double>>& block);

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;

  signals:
    void edited(const smat::TrajectoryTable& table, const QString& step);

  private:
    int points() const { return static_cast<int>(table_.rows.size()); }
    /// The rows with one number changed, or with a row more.
    std::vector<TrajectoryTable::Row> with(const QModelIndex& cell, double value) const;
    std::optional<double> typedIn(const QModelIndex& cell, const QString& text) const;
    /// The row that goes on from those, along the last leg.
    static TrajectoryTable::Row nextOf(const std::vector<TrajectoryTable::Row>& rows);

    TrajectoryTable table_;
};

} // namespace smat::gui
