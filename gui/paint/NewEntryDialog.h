#pragma once

#include <QDialog>

#include "gui/database/DatabaseEdits.h"

class QLineEdit;

namespace smat::gui {

/// Asks for the name of an entry that is made while a model is painted.
class NewEntryDialog : public QDialog {
    Q_OBJECT

  public:
    NewEntryDialog(EntryKind kind, int index, QWidget* parent = nullptr);
    std::string name() const;

  private:
    QLineEdit* name_ = nullptr;
};

} // namespace smat::gui
