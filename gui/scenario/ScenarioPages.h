#pragma once

#include <filesystem>

#include <QObject>

#include "gui/widgets/Dialogs.h"
#include "smatcore/simulate/Scenario.h"

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
    /// Begins a scenario with the models and the view of the project (scenarioOf): asks for its
    /// file, writes and opens it.
    void begin();

  private:
    void write(const Scenario& scenario, const std::filesystem::path& file);
    ScenarioPage* pageOf(const std::filesystem::path& file) const;

    Workbench& workbench_;
    Dialogs& dialogs_;
    PageTabs& tabs_;
};

} // namespace smat::gui
