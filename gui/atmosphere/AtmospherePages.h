#pragma once

#include <filesystem>
#include <functional>
#include <memory>

#include <QObject>

#include "gui/widgets/Dialogs.h"

namespace smat::gui {

class AtmosphereDocument;
class AtmospherePage;
class PageTabs;
class Workbench;

/// Opens air as pages of the window: parameters, what the project has, imports.
class AtmospherePages : public QObject {
    Q_OBJECT

  public:
    AtmospherePages(Workbench& workbench, Dialogs& dialogs, PageTabs& tabs);

    /// A page for air without a file.
    void makeNew();
    /// The page of the project's atmospheres; one is enough.
    void showProjectAtmosphere();
    void importTables();
    /// Opens a file of AtmosphereSmart, or shows the page where it is open already, or tells what
    /// is wrong with it. True: whatever it was, it is dealt with.
    bool open(const std::filesystem::path& file);

  private:
    AtmospherePage* pageOf(const std::filesystem::path& file) const;
    AtmospherePage& addPage(std::unique_ptr<AtmosphereDocument> document);
    /// Asks what becomes of unsaved edits of a file, or of air without one, that an earlier run
    /// left behind; what is recovered is shown on a page.
    void offerCopies(const std::filesystem::path& file,
                     const std::function<AtmospherePage&()>& page);
    /// The same for the air of the project that no page shows.
    void offerCopiesOfProject();

    Workbench& workbench_;
    Dialogs& dialogs_;
    PageTabs& tabs_;
};

} // namespace smat::gui
