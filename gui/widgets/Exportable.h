#pragma once

#include <filesystem>

#include <QStringList>

namespace smat::gui {

/// A page whose content can be written to files: File, Export and Ctrl+E ask the page that is
/// shown.
class Exportable {
  public:
    virtual ~Exportable() = default;
    /// Filters of a file dialog such as "Picture (*.png)", data first; empty where there is nothing
    /// to write now.
    virtual QStringList exportFilters() const = 0;
    /// By the suffix of the file. Throws irsg::InputError.
    virtual void exportTo(const std::filesystem::path& file) const = 0;
};

} // namespace smat::gui
