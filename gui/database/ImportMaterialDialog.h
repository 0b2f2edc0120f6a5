#pragma once

#include <optional>

#include "gui/database/ImportDialog.h"

class QLineEdit;

namespace smat::gui {

/// Reads emissivity, transmissivity, reflectivity, n and k of a material from a CSV file, or a
/// table of its reflectance over directions (CSV, Zemax BSDF), into a new entry or one that is
/// there. What comes of it is what the material is in the band, and which faces carry it.
class ImportMaterialDialog : public ImportDialog {
    Q_OBJECT

  public:
    /// `index`: the one that is meant; else a free one is offered.
    ImportMaterialDialog(const EditorContext& context, const std::filesystem::path& file,
                         std::optional<int> index, QWidget* parent = nullptr);

    /// Of the entry that it goes to.
    int index() const { return index_; }
    /// As it would be filed; none while something is wrong.
    const std::optional<irsg::Material>& material() const { return material_; }

  private:
    QString readFile() override;
    QString wordsOf(const irsg::Material& material) const;

    int index_ = 0;
    std::optional<irsg::Material> material_;
    QLineEdit *indexField_ = nullptr, *name_ = nullptr;
};

} // namespace smat::gui
