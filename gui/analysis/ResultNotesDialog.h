#pragma once

#include <QDialog>

class QPlainTextEdit;

namespace smat::gui {

struct ResultEntry;

/// Asks for what a person wants to be known of a result.
class ResultNotesDialog : public QDialog {
    Q_OBJECT

  public:
    ResultNotesDialog(const ResultEntry& entry, QWidget* parent = nullptr);

    int id() const { return id_; }
    QString notes() const;

  private:
    int id_;
    QPlainTextEdit* text_ = nullptr;
};

} // namespace smat::gui
