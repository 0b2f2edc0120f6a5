#pragma once

#include <functional>
#include <map>

#include <QObject>

#include "gui/widgets/Dialogs.h"
#include "smatcore/project/AnalysisKind.h"

class QAction;
class QKeySequence;
class QMainWindow;
class QMenu;
class QToolBar;

namespace smat::gui {

class AtmospherePages;
class DatabaseDock;
class FileOpening;
class ImagePages;
class MainDialogs;
class PageTabs;
class ProjectFiles;
class ProjectView;
class ResultsDock;
class SceneModelActs;
class SceneTreeDock;
class ScenarioPages;
class WindowLayout;
class Workbench;

/// Those who do what the menus offer.
struct MainParts {
    QMainWindow& window;
    Workbench& workbench;
    Dialogs& dialogs;
    MainDialogs& ask;
    ProjectFiles& files;
    FileOpening& opening;
    PageTabs& tabs;
    ImagePages& images;
    ProjectView* view; ///< null where the desktop has no OpenGL
    ResultsDock& results;
    DatabaseDock& database;
    AtmospherePages& air;
    WindowLayout& layout;
    SceneModelActs& models;
    SceneTreeDock& tree;
    ScenarioPages& scenarios;
};

/// The menus and the tool bar of the window: what they offer, and what of it can be done now.
class MainMenus : public QObject {
    Q_OBJECT

  public:
    explicit MainMenus(const MainParts& parts);

    /// What can be done now.
    void refresh();
    /// Offers the analyses that the project names.
    void followProject();

  private:
    void makeFileMenu(QMenu* menu);
    void addDatabaseActions(QMenu* menu);
    void makeEditMenu(QMenu* menu);
    void addModelActions(QMenu* menu);
    void makeViewMenu(QMenu* menu);
    void keepState();
    void makeAnalysisMenu(QMenu* menu);
    void makeToolsMenu(QMenu* menu);
    void makeHelpMenu(QMenu* menu);
    QAction* add(QMenu* menu, const QString& name, const QString& drawing, const QString& text,
                 const QKeySequence& keys, const std::function<void()>& act);
    void fillRecent(QMenu* menu);

    MainParts with_;
    int states_ = 0; ///< kept so far
    QToolBar* bar_ = nullptr;
    QAction* export_ = nullptr;
    QAction* close_ = nullptr;
    QAction* beside_ = nullptr;
    QAction* saveDatabase_ = nullptr;
    QAction* saveDatabaseAs_ = nullptr;
    QAction* keepAnalysis_ = nullptr;
    QMenu* ofProject_ = nullptr;
    QList<QAction*> saves_; ///< of the project, or of the file of the page that is shown
    QList<QAction*> needProject_;
    QAction* removeModel_ = nullptr;
    QAction* makeTarget_ = nullptr;
    QAction* wholeScene_ = nullptr; ///< null without a view
    std::map<AnalysisKind, QAction*> analyses_;
};

} // namespace smat::gui
