#pragma once

#include <QObject>

#include "gui/settings/SettingForm.h"
#include "gui/widgets/Dialogs.h"
#include "smatcore/project/AnalysisKind.h"

class QMainWindow;

namespace smat::gui {

class PageTabs;
class ProjectFiles;
class Workbench;
struct Preferences;

/// The dialogs that the window opens, and what becomes of their answers.
class MainDialogs : public QObject {
    Q_OBJECT

  public:
    MainDialogs(QMainWindow& window, Workbench& workbench, Dialogs& dialogs,
                Preferences& preferences, ProjectFiles& files, PageTabs& tabs);

    /// A new analysis that begins with these settings, and a name where the project has it.
    void newAnalysis(AnalysisKind kind, const Settings& settings, const QString& name = {});
    /// One that the project names.
    void startAgain(const QString& name);
    void keepShownAnalysis();
    void removeAnalysis(const QString& name);
    void convertModel();
    void showProjectProperties();
    /// Codes and a database for a model that has none.
    void makeFirstSignature();
    /// The settings of the project, at the page of this title.
    void showSettings(const QString& page);
    void importImagingSensor();
    void exportImagingSensor();
    void showPreferences();
    /// `viewRenderer` is that of the 3-D view.
    void showAbout(const QString& viewRenderer);
    void showGuide();

  private:
    FileChooser fileChooser();
    void say(const QString& sentence);

    QMainWindow& window_;
    Workbench& workbench_;
    Dialogs& dialogs_;
    Preferences& preferences_;
    ProjectFiles& files_;
    PageTabs& tabs_;
    QString sceneRenderer_; ///< of the last result
};

} // namespace smat::gui
