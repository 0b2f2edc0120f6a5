#pragma once

#include <filesystem>
#include <map>

#include <QMainWindow>

#include "gui/Dialogs.h"
#include "gui/Workbench.h"
#include "gui/settings/SettingForm.h"

class QAction;
class QMenu;
class QTabWidget;

namespace smat::gui {

class ResultPage;
class ResultsDock;
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
    /// Null where the desktop has no OpenGL.
    SceneView* sceneView() const { return view_; }
    /// The page that is shown; null for the 3-D view.
    ResultPage* currentPage() const;

  protected:
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

  private:
    void makeActions();
    void makeAnalysisActions(QMenu* menu);
    void makeViewMenu();
    void makeCentre();
    void chooseProject();
    void fillRecent(QMenu* menu);
    void newAnalysis(AnalysisKind kind, const Settings& settings, const QString& name = {});
    void exportShown();
    void onProjectOpened();
    void showModel();
    void onSettingsChanged();
    void showResults(const QList<int>& ids);
    void closeResultsOf(int id);
    void showAbout();
    void refreshActions();
    void restoreLayout();
    FileChooser fileChooser();

    Workbench& workbench_;
    Dialogs dialogs_;
    QTabWidget* tabs_ = nullptr;
    SceneView* view_ = nullptr;
    ResultsDock* results_ = nullptr;
    QAction* export_ = nullptr;
    QMenu* ofProject_ = nullptr;
    std::map<AnalysisKind, QAction*> analyses_;
    QString sceneRenderer_;
};

} // namespace smat::gui
