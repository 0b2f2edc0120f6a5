#pragma once

#include <optional>

#include <QAbstractTableModel>
#include <QWidget>

#include "gui/database/EditorContext.h"

class QHBoxLayout;
class QLineEdit;
class QSortFilterProxyModel;
class QTableView;
class QToolButton;

namespace smat::gui {

/// The entries of one kind: index with a swatch, name, faces of the model that use it, and the
/// value that says most: mean emissivity in the band, temperature in the project's state.
class EntryListModel : public QAbstractTableModel {
    Q_OBJECT

  public:
    EntryListModel(EditorContext& context, EntryKind kind, QObject* parent = nullptr);

    enum Column { indexColumn, nameColumn, facesColumn, valueColumn };
    void refresh();
    std::optional<EntryKey> keyAt(int row) const;
    int rowOf(const EntryKey& key) const;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

  private:
    struct Row {
        EntryKey key;
        QString name, value;
        int faces = 0;
        QColor swatch;
        bool operator==(const Row&) const = default;
    };
    std::vector<Row> rowsNow() const;

    EditorContext& context_;
    EntryKind kind_;
    std::vector<Row> rows_;
};

/// The list with its filter and the buttons that add, duplicate, renumber and remove entries.
/// Before an index goes that faces use, it says so.
class EntryList : public QWidget {
    Q_OBJECT

  public:
    EntryList(EditorContext& context, EntryKind kind, QWidget* parent = nullptr);

    std::optional<EntryKey> current() const;
    void select(const EntryKey& key);
    QTableView* view() const { return view_; }
    /// A button behind those of the list.
    QToolButton* addButton(const QString& icon, const QString& name, const QString& tip);

  signals:
    void currentChanged();

  private:
    void refresh();
    void add();
    void duplicate();
    void renumber();
    void remove();
    bool agreed(const QString& title, const QString& text, const QString& button) const;

    EditorContext& context_;
    EntryKind kind_;
    EntryListModel* model_ = nullptr;
    QSortFilterProxyModel* filter_ = nullptr;
    QTableView* view_ = nullptr;
    QLineEdit* search_ = nullptr;
    QHBoxLayout* bar_ = nullptr;
    std::optional<EntryKey> shown_;
};

} // namespace smat::gui
