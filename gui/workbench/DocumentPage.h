#pragma once

#include <QString>

namespace smat::gui {

/// A page with a file of its own that is edited in it: Save and Save as of the menus are about that
/// file while the page is shown, and closing it asks for what is not saved.
class DocumentPage {
  public:
    virtual ~DocumentPage() = default;
    /// What it is, in a menu: "scenario".
    virtual QString noun() const = 0;
    /// True where it was saved.
    virtual bool save() = 0;
    virtual bool saveAs() = 0;
    /// Saves edits or gives them up, as the person wants it; false where it is better to stay.
    virtual bool mayClose() = 0;
};

} // namespace smat::gui
