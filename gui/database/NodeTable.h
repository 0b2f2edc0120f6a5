#pragma once

#include <QAbstractTableModel>
#include <QTableView>

#include "gui/database/Nodes.h"

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

    NodeRules rules_;
    Nodes nodes_;
};

/// The table as a person edits it: cells are checked while one types, rows are pasted from and
/// copied to spreadsheets (Ctrl+V, Ctrl+C), inserted (Insert) and removed (Delete).
class NodeTable : public QTableView {
    Q_OBJECT

  public:
    explicit NodeTable(NodeTableModel& model, QWidget* parent = nullptr);

    /// Pastes as spreadsheets do, from the current cell down; rows are added at the end.
    void paste();
    /// Pastes in place of all rows; a descending axis is turned round.
    void pasteAll();
    void copy() const;
    void insertRow();
    void removeRows();
    void selectNode(int row);
    void setReadOnly(bool readOnly);

  signals:
    /// What is wrong with what is being typed or was pasted; empty when all is well again.
    void problem(const QString& sentence);
    void nodeSelected(int row);

  protected:
    void keyPressEvent(QKeyEvent* event) override;
    void currentChanged(const QModelIndex& current, const QModelIndex& previous) override;

  private:
    void report(const QString& sentence);

    NodeTableModel& model_;
    bool readOnly_ = false;
};

} // namespace smat::gui
