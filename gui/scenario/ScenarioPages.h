#pragma once

#include <filesystem>

#include <QObject>

#include "gui/widgets/Dialogs.h"

namespace smat::gui {

class PageTabs;
class ScenarioPage;
class Workbench;

/// Opens scenarios as pages of the window.
class ScenarioPages : public QObject {
    Q_OBJECT

  public:
    ScenarioPages(Workbench& workbench, Dialogs& dialogs, PageTabs& tabs);

    /// True for a file that is a scenario: it is opened, or shown where it is open already, or what
    /// is wrong with it is told.
    bool open(const std::filesystem::path& file);

  private:
    ScenarioPage* pageOf(const std::filesystem::path& file) const;

    Workbench& workbench_;
    Dialogs& dialogs_;
    PageTabs& tabs_;
};

} // namespace smat::gui
