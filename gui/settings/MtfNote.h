#pragma once

#include <filesystem>

#include <QLabel>

namespace smat::gui {

/// What an MTF database says about itself: header, axes and gains, or why it is none.
class MtfNote : public QLabel {
    Q_OBJECT

  public:
    explicit MtfNote(QWidget* parent = nullptr);
    /// Nothing is shown without a file.
    void tell(const std::filesystem::path& file);
};

} // namespace smat::gui
