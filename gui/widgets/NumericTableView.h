#pragma once

#include <optional>
#include <set>
#include <vector>

#include <QTableView>

#include "gui/widgets/CheckedCell.h"

namespace smat::gui {

/// A table of numbers as a person edits it: cells are checked while one types, blocks are pasted
/// from and copied to spreadsheets (Ctrl+V, Ctrl+C), rows inserted (Insert) and removed (Delete).
/// What that does to the rows is the subclass's.
class NumericTableView : public QTableView {
    Q_OBJECT

  public:
    /// `cell` names the fields in which one types; `problemOf` is that of CheckedCell.
    NumericTableView(QAbstractItemModel& model, const QString& cell, CheckedCell::Check problemOf,
                     QWidget* parent);

    void setReadOnly(bool readOnly);
    /// Pastes as spreadsheets do, from the current cell right and down.
    void paste();
    /// The chosen cells, tabs between columns.
    virtual void copy() const;
    virtual void insertRow() = 0;
    virtual void removeRows() = 0;

  signals:
    /// What is wrong with what is being typed or was pasted; empty when all is well again.
    void problem(const QString& sentence);

  protected:
    using Rows = std::vector<std::vector<double>>; ///< each as long as the first

    void keyPressEvent(QKeyEvent* event) override;
    bool isReadOnly() const { return readOnly_; }
    /// The rows in which a cell is chosen.
    std::set<int> chosenRows() const;
    /// What the clipboard holds; reports where that is no rows of numbers.
    std::optional<Rows> clipboardRows();
    void copyCells(const std::set<int>& rows, const std::set<int>& columns) const;

  private:
    /// Puts a block at a cell. Answers why it cannot be; empty where it is done.
    virtual QString pasteAt(const QModelIndex& cell, const Rows& block) = 0;

    bool readOnly_ = false;
};

} // namespace smat::gui
