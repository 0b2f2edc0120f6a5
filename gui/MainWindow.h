#pragma once

#include <filesystem>
#include <functional>

#include <QMainWindow>

#include "gui/settings/Preferences.h"
#include "gui/widgets/Dialogs.h"
#include "gui/workbench/PageTabs.h"
#include "gui/workbench/Workbench.h"

namespace smat::gui {

class AtmospherePages;
class ComparisonWindow;
class DatabaseDock;
class FileOpening;
class ImagePages;
class LoadingBar;
class MainDialogs;
class MainMenus;
class PaintDock;
class ProjectFiles;
class ProjectView;
class ResultPage;
class ResultPages;
class ResultsDock;
class SceneModelActs;
class SceneTreeDock;
class SceneView;
class StartPage;
class WindowLayout;
class WindowMessages;

/// The window of the workbench: the 3-D view and the results as tabs, docks beside them. It puts
/// them together; everything it does goes through a Workbench.
class MainWindow : public QMainWindow {
    Q_OBJECT

  public:
    explicit MainWindow(Workbench& workbench, Dialogs dialogs = Dialogs::ofDesktop(),
                        QWidget* parent = nullptr);
    ~MainWindow() override;

    /// Opens a project or a model; what is wrong with it is told, and nothing that was open is
    /// lost.
    bool open(const std::filesystem::path& file);
    /// Opens files of any kind, and does what a start of the program does: see FileOpening.
    void openFiles(const QStringList& files);
    bool begin(const std::filesystem::path& file);
    void openWith(const QStringList& suffixes,
                  std::function<bool(const std::filesystem::path&)> opener);
    /// A fault of this program: keeps unsaved changes and says so.
    void tellInternalError(const QString& what);

    ProjectFiles& files() { return *files_; }
    SceneTreeDock& tree() { return *tree_; }
    DatabaseDock& databaseEditor() { return *databaseDock_; }
    WindowMessages& messages() { return *messages_; }
    /// Null where the desktop has no OpenGL.
    SceneView* sceneView() const;
    /// While the models of the view are being read, off this thread.
    bool isLoadingModel() const;
    /// The page that is shown; null for the 3-D view.
    ResultPage* currentPage() const { return tabs_->currentResult(); }
    /// Shows a window of a tool as a tab that can be closed. A page that is Exportable takes part
    /// in File, Export.
    void addPage(QWidget* page, const QIcon& icon, const QString& title);
    /// See ImagePages.
    ComparisonWindow* compareImages(const QStringList& files = {});
    ComparisonWindow* compareResults(int a, int b);

  protected:
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

  private:
    void makeCentre();
    void makeDocks();
    void makePainter();
    void connectTree();
    void joinTreeAndView();
    void joinTreeAndEditor();
    void makeMessages(AtmospherePages& air);
    void makeHistory();
    void makeStartPage();
    void connectWorkbench();
    void connectResults();
    void keepTabOrder();
    bool mayEndRuns();
    void onProjectOpened();
    void onProjectChanged();
    void refreshTitle();
    void say(const QString& sentence, int time_ms = 0);

    Workbench& workbench_;
    Dialogs dialogs_;
    Preferences preferences_;
    WindowMessages* messages_ = nullptr;
    PageTabs* tabs_ = nullptr;
    ProjectView* view_ = nullptr; ///< null where the desktop has no OpenGL
    LoadingBar* loading_ = nullptr;
    StartPage* start_ = nullptr;
    SceneTreeDock* tree_ = nullptr;
    ResultsDock* results_ = nullptr;
    ResultPages* resultPages_ = nullptr;
    DatabaseDock* databaseDock_ = nullptr;
    ProjectFiles* files_ = nullptr;
    SceneModelActs* models_ = nullptr;
    FileOpening* opening_ = nullptr;
    ImagePages* images_ = nullptr;
    PaintDock* paint_ = nullptr; ///< null where the desktop has no OpenGL
    MainDialogs* ask_ = nullptr;
    WindowLayout* layout_ = nullptr;
    MainMenus* menus_ = nullptr;
};

} // namespace smat::gui
