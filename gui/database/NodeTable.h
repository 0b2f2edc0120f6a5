#pragma once

#include <QAbstractTableModel>

#include "gui/database/Nodes.h"
#include "gui/widgets/NumericTableView.h"

namespace smat::gui {

/// The nodes of one table with an empty row at its end to add to. Takes what the rules allow.
class NodeTableModel : public QAbstractTableModel {
    Q_OBJECT

  public:
    explicit NodeTableModel(QObject* parent = nullptr);

    void setRules(NodeRules rules);
    const NodeRules& rules() const { return rules_; }
    void setNodes(const Nodes& nodes);
    const Nodes& nodes() const { return nodes_; }

    /// Why a text cannot stand in a cell; empty where it can.
    QString problemOf(const QModelIndex& cell, const QString& text) const;
    /// Takes nodes as an edit by the user: answers why they cannot be, or emits `edited`.
    QString take(const Nodes& nodes, const QString& what);

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;

  signals:
    /// By the user. `what`: "at 4.2 um", "row 3", "pasted rows".
    void edited(const smat::gui::Nodes& nodes, const QString& what);

  private:
    Nodes with(const QModelIndex& cell, double value) const;
    QString unitOf(const QModelIndex& cell) const {
        return cell.column() == 0 ? rules_.xUnit : rules_.yUnit;
    }

    NodeRules rules_;
    Nodes nodes_;
};

/// The table of nodes. A node that becomes current is told of.
class NodeTable : public NumericTableView {
    Q_OBJECT

  public:
    explicit NodeTable(NodeTableModel& model, QWidget* parent = nullptr);

    /// Pastes in place of all rows; a descending axis is turned round.
    void pasteAll();
    /// The chosen rows, or all where at most one is chosen.
    void copy() const override;
    void insertRow() override;
    void removeRows() override;
    void selectNode(int row);

  signals:
    void nodeSelected(int row);

  protected:
    void currentChanged(const QModelIndex& current, const QModelIndex& previous) override;

  private:
    QString pasteAt(const QModelIndex& cell, const Rows& block) override;

    NodeTableModel& model_;
};

} // namespace smat::gui
