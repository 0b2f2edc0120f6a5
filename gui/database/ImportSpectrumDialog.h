#pragma once

#include <optional>

#include "gui/database/ImportDialog.h"

class QComboBox;
class QLineEdit;

namespace smat::gui {

/// Reads a user-defined spectrum from a CSV file with the unit that a person gives where the file
/// states none.
class ImportSpectrumDialog : public ImportDialog {
    Q_OBJECT

  public:
    ImportSpectrumDialog(const EditorContext& context, const std::filesystem::path& file,
                         QWidget* parent = nullptr);

    /// As it would be filed; none while something is wrong.
    const std::optional<irsg::UserSpectrum>& spectrum() const { return spectrum_; }

  private:
    QString readFile() override;

    std::optional<irsg::UserSpectrum> spectrum_;
    QLineEdit* name_ = nullptr;
    QComboBox* unit_ = nullptr;
    QLineEdit* distance_ = nullptr;
};

} // namespace smat::gui
