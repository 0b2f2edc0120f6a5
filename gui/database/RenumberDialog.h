#pragma once

#include <QDialog>

#include "gui/database/EditorContext.h"

class QDialogButtonBox;
class QLabel;
class QLineEdit;

namespace smat::gui {

/// Asks for the index, or the name of a spectrum, that an entry is to have, and says meanwhile what
/// becomes of the faces and temperatures that use it.
class RenumberDialog : public QDialog {
    Q_OBJECT

  public:
    RenumberDialog(const EditorContext& context, const EntryKey& entry, QWidget* parent = nullptr);

    /// What was entered; the entry itself where it is no free index or name.
    EntryKey wanted() const;

  private:
    void validate();

    const EditorContext& context_;
    EntryKey entry_;
    QLineEdit* field_ = nullptr;
    QLabel* consequence_ = nullptr;
    QDialogButtonBox* buttons_ = nullptr;
};

} // namespace smat::gui
