#pragma once

#include <QDialog>

#include "gui/database/EditorContext.h"

class QDialogButtonBox;
class QLabel;
class QLineEdit;
class QTreeWidget;
class QTreeWidgetItem;

namespace smat::gui {

class NodePlot;

/// Entries of another database to choose from: a check each, the index or name that it is to have
/// here, and what happens where that is taken. The library of materials is one such database.
class CopyEntriesDialog : public QDialog {
    Q_OBJECT

  public:
    CopyEntriesDialog(const EditorContext& context, irsg::SignatureDatabase source,
                      const QString& title, QWidget* parent = nullptr);

    const irsg::SignatureDatabase& source() const { return source_; }
    /// What was chosen, clashes resolved.
    std::vector<EntryCopy> copies() const;
    /// Checks an entry, as a click on it does.
    void choose(const EntryKey& key);

  private:
    void fill();
    void addItem(QTreeWidgetItem* group, const EntryKey& key, const QString& name,
                 const std::string& notes);
    EntryKey keyOf(const QTreeWidgetItem* item) const;
    std::vector<QTreeWidgetItem*> entries() const;
    void filter(const QString& text);
    void validate();
    void preview();

    const EditorContext& context_;
    irsg::SignatureDatabase source_;
    std::vector<EntryKey> keys_;
    QLineEdit* search_ = nullptr;
    QTreeWidget* list_ = nullptr;
    NodePlot* plot_ = nullptr;
    QLabel *notes_ = nullptr, *verdict_ = nullptr;
    QDialogButtonBox* buttons_ = nullptr;
};

} // namespace smat::gui
