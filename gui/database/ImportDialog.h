#pragma once

#include <filesystem>

#include <QDialog>

#include "gui/database/EditorContext.h"

class QDialogButtonBox;
class QFormLayout;
class QLabel;

namespace smat::gui {

/// Reads something for the database from a file while a person says how, and shows what comes of
/// it: what is wrong, line by line, or what it would be.
class ImportDialog : public QDialog {
    Q_OBJECT

  protected:
    ImportDialog(const EditorContext& context, std::filesystem::path file, QWidget* parent);

    const EditorContext& context() const { return context_; }
    const std::filesystem::path& file() const { return file_; }
    /// Lays out the fields, outcome and buttons below them, and reads for the first time.
    void start(QFormLayout* fields);
    /// Reads anew: a field has changed.
    void read();

  private:
    /// Reads as the fields say and says what comes of it. Throws InputError.
    virtual QString readFile() = 0;

    const EditorContext& context_;
    std::filesystem::path file_;
    QLabel* outcome_ = nullptr;
    QDialogButtonBox* buttons_ = nullptr;
};

} // namespace smat::gui
