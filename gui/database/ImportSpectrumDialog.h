#pragma once

#include <filesystem>
#include <optional>

#include <QDialog>

#include "gui/database/EditorContext.h"

class QComboBox;
class QDialogButtonBox;
class QLabel;
class QLineEdit;

namespace smat::gui {

/// Reads a user-defined spectrum from a CSV file with the unit that a person gives where the file
/// states none, and shows meanwhile what comes of it.
class ImportSpectrumDialog : public QDialog {
    Q_OBJECT

  public:
    ImportSpectrumDialog(const EditorContext& context, const std::filesystem::path& file,
                         QWidget* parent = nullptr);

    /// As it would be filed; none while something is wrong.
    const std::optional<irsg::UserSpectrum>& spectrum() const { return spectrum_; }

  private:
    void read();

    const EditorContext& context_;
    std::filesystem::path file_;
    std::optional<irsg::UserSpectrum> spectrum_;
    QLineEdit* name_ = nullptr;
    QComboBox* unit_ = nullptr;
    QLineEdit* distance_ = nullptr;
    QLabel* outcome_ = nullptr;
    QDialogButtonBox* buttons_ = nullptr;
};

} // namespace smat::gui
