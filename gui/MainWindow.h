#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <utility>
#include <vector>

#include <QMainWindow>

#include "gui/Dialogs.h"
#include "gui/LatestTask.h"
#include "gui/Workbench.h"
#include "gui/project/SceneIndex.h"
#include "gui/settings/Preferences.h"
#include "gui/settings/SettingForm.h"

class QAction;
class QMenu;
class QTabWidget;
class QToolBar;

namespace smat::gui {

class DatabaseDock;
class ComparisonWindow;
class LoadingBar;
class ModelPage;
class ProjectFiles;
class ResultPage;
class ResultsDock;
class StartPage;
class WindowLayout;
class SceneLoader;
class SceneTreeDock;
class SceneView;

/// The window of the workbench: the 3-D view and the results as tabs, docks beside them. Everything
/// it does goes through a Workbench.
class MainWindow : public QMainWindow {
    Q_OBJECT

  public:
    explicit MainWindow(Workbench& workbench, Dialogs dialogs = Dialogs::ofDesktop(),
                        QWidget* parent = nullptr);
    ~MainWindow() override;

    /// Opens a project or a model; what is wrong with it is told, and nothing that was open is
    /// lost.
    bool open(const std::filesystem::path& file);
    /// Opens files of any kind, each by what it is: one image as a tab or two as a comparison,
    /// saved results, of which several plots are overlaid as well, else a project or a model.
    void openFiles(const QStringList& files);
    /// What a start of the program does: opens a file, if one is named, and offers what a crash
    /// left behind (see ProjectFiles::begin). Returns whether something is open.
    bool begin(const std::filesystem::path& file);
    /// A fault of this program: keeps unsaved changes and says so.
    void tellInternalError(const QString& what);
    /// Who opens files of other kinds that are dropped here: asked in turn for a file with one of
    /// these suffixes ("exr") until one answers true.
    void openWith(const QStringList& suffixes,
                  std::function<bool(const std::filesystem::path&)> opener);
    ProjectFiles& files() { return *files_; }
    SceneTreeDock& tree() { return *tree_; }
    /// Null where the desktop has no OpenGL.
    SceneView* sceneView() const { return view_; }
    /// While the models of the view are being read, off this thread.
    bool isLoadingModel() const;
    DatabaseDock& databaseEditor() { return *databaseDock_; }
    /// The page that is shown; null for the 3-D view.
    ResultPage* currentPage() const;
    /// Shows a window of a tool as a tab that can be closed. A page that is Exportable takes part
    /// in File, Export.
    void addPage(QWidget* page, const QIcon& icon, const QString& title);

    /// A tab that compares two images: those of two files, or empty for somebody to fill. It goes
    /// again where neither file can be read.
    ComparisonWindow* compareImages(const QStringList& files = {});
    /// The same of two results that are images; nothing for others.
    ComparisonWindow* compareResults(int a, int b);
    /// One file as a tab of its own, two as a comparison, read off this thread.
    void openImages(const QStringList& files);
    /// Whether these are one or two images to be looked at: .exr by name, others by what they hold.
    /// A single .csv is none: it comes back as a result, with its provenance.
    static bool areImages(const QStringList& files);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

  private:
    // MainMenus.cpp
    void makeMenus();
    void makeFileMenu(QMenu* menu);
    void makeEditMenu(QMenu* menu);
    void makeViewMenu(QMenu* menu);
    void makeAnalysisMenu(QMenu* menu);
    void makeToolsMenu(QMenu* menu);
    void makeHelpMenu(QMenu* menu);
    QAction* addAction(QMenu* menu, const QString& name, const QString& drawing,
                       const QString& text, const QKeySequence& keys,
                       const std::function<void()>& act);
    void fillProjectAnalyses();

    void makeCentre();
    void joinTreeAndView();
    void makeDocks();
    void connectWorkbench();

    // MainDialogs.cpp
    void convertModel();
    void showProjectProperties();
    void keepShownAnalysis();
    void showPreferences();
    /// The settings of the project, at the page of this title.
    void showSettings(const QString& page);
    void showAbout();

    // MainImages.cpp
    void chooseFile();
    void openOther(const std::filesystem::path& file);
    void overlayResultsFrom(std::size_t first);

    void fillRecent(QMenu* menu);
    void newAnalysis(AnalysisKind kind, const Settings& settings, const QString& name = {});
    void exportShown();
    void onProjectOpened();
    void onProjectChanged();
    void refreshTitle();
    void makeLoader();
    void showModel();
    void onSettingsChanged();
    void refreshActions();
    void makeStartPage();
    void openGuide();
    FileChooser fileChooser();

    Workbench& workbench_;
    Dialogs dialogs_;
    Preferences preferences_;
    ProjectFiles* files_ = nullptr;
    SceneTreeDock* tree_ = nullptr;
    QTabWidget* tabs_ = nullptr;
    QToolBar* bar_ = nullptr;
    ModelPage* page_ = nullptr;
    SceneView* view_ = nullptr; ///< of the page
    LoadingBar* loading_ = nullptr;
    SceneLoader* loader_ = nullptr;
    StartPage* start_ = nullptr;
    WindowLayout* layout_ = nullptr;
    ResultsDock* results_ = nullptr;
    DatabaseDock* databaseDock_ = nullptr;
    QAction* export_ = nullptr;
    QAction* keepAnalysis_ = nullptr;
    QMenu* ofProject_ = nullptr;
    QList<QAction*> ofProjectFile_; ///< that need a project
    std::vector<std::pair<QStringList, std::function<bool(const std::filesystem::path&)>>> openers_;
    std::map<AnalysisKind, QAction*> analyses_;
    std::vector<ProjectModel> shownModels_;
    QString sceneRenderer_;
    LatestTask imageTask_;
};

} // namespace smat::gui
