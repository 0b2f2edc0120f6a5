
#include <QMenu>
#include <QMenuBar>
#include <QTabWidget>
#include <QToolBar>

#include "gui/CommandPalette.h"
#include "gui/HelpDialogs.h"
#include "gui/MainWindow.h"
#include "gui/Theme.h"
#include "gui/WindowLayout.h"
#include "gui/analysis/ResultsDock.h"
#include "gui/database/DatabaseDock.h"
#include "gui/project/ProjectFiles.h"
#include "gui/settings/SettingsDialog.h"
#include "gui/start/DataFolder.h"
#include "gui/tools/AirTools.h"
#include "gui/tools/MonteCarloPage.h"
#include "gui/view/ModelPage.h"
#include "gui/view/SceneView.h"
#include "smatcore/analysis/kinds/AnalysisDefinition.h"

namespace smat::gui {

void MainWindow::makeMenus() {
    bar_ = addToolBar(tr("Tool bar"));
    bar_->setObjectName("toolBar");
    bar_->setIconSize(QSize(22, 22));
    bar_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    bar_->setMovable(false);

    makeFileMenu(menuBar()->addMenu(tr("&File")));
    makeEditMenu(menuBar()->addMenu(tr("&Edit")));
    makeViewMenu(menuBar()->addMenu(tr("&View")));
    makeAnalysisMenu(menuBar()->addMenu(tr("&Analysis")));
    auto* tools = menuBar()->addMenu(tr("&Tools"));
    makeToolsMenu(tools);
    tools->menuAction()->setVisible(!tools->isEmpty());
    makeHelpMenu(menuBar()->addMenu(tr("&Help")));
}

QAction* MainWindow::addAction(QMenu* menu, const QString& name, const QString& drawing,
                               const QString& text, const QKeySequence& keys,
                               const std::function<void()>& act) {
    auto* action = drawing.isEmpty() ? menu->addAction(text) : menu->addAction(icon(drawing), text);
    action->setObjectName(name);
    action->setShortcut(keys);
    connect(action, &QAction::triggered, this, act);
    return action;
}

void MainWindow::makeFileMenu(QMenu* menu) {
    addAction(menu, "newProject", "new", tr("&New project…"), QKeySequence::New,
              [this] { files_->newProject(); });
    auto* open = addAction(menu, "openProject", "open", tr("&Open…"), QKeySequence::Open,
                           [this] { chooseFile(); });
    open->setToolTip(tr("Open a project, a model, a result or an image (Ctrl+O)"));
    addAction(menu, "openModel", "model", tr("Open &model…"),
              QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_O), [this] { files_->chooseModel(); });
    auto* recent = menu->addMenu(icon("recent"), tr("Open &recent"));
    recent->setObjectName("recentFiles");
    connect(recent, &QMenu::aboutToShow, this, [this, recent] { fillRecent(recent); });
    auto* samplesMenu = menu->addMenu(icon("model"), tr("Sam&ples"));
    samplesMenu->setObjectName("samples");
    for (const Sample& sample : samples()) {
        auto* action = samplesMenu->addAction(sample.title, this,
                                              [this, file = sample.project] { this->open(file); });
        action->setToolTip(sample.words);
    }
    samplesMenu->setEnabled(!samplesMenu->isEmpty());
    menu->addSeparator();
    auto* save = addAction(menu, "saveProject", "save", tr("&Save project"), QKeySequence::Save,
                           [this] { files_->save(); });
    save->setIconText(tr("Save"));
    save->setToolTip(tr("Save the project (Ctrl+S)"));
    auto* saveAs =
        addAction(menu, "saveProjectAs", {}, tr("Save project &as…"),
                  QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S), [this] { files_->saveAs(); });
    ofProjectFile_ = {save, saveAs};
    ofProjectFile_.append(addAction(menu, "projectProperties", {}, tr("Project proper&ties…"),
                                    QKeySequence(Qt::ALT | Qt::Key_Return),
                                    [this] { showProjectProperties(); }));
    menu->addSeparator();
    ofProjectFile_.append(addAction(menu, "openDatabase", "database", tr("Open &database…"), {},
                                    [this] { databaseDock_->openDatabase(); }));
    addAction(menu, "saveDatabase", {}, tr("Save data&base"),
              QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_D), [this] { databaseDock_->save(); });
    addAction(menu, "saveDatabaseAs", {}, tr("Save database as…"), {},
              [this] { databaseDock_->saveAs(); });
    menu->addSeparator();
    addAction(menu, "convertModel", "import", tr("&Import or convert a model…"),
              QKeySequence(Qt::CTRL | Qt::Key_I), [this] { convertModel(); });
    export_ = addAction(menu, "exportShown", "export", tr("&Export…"),
                        QKeySequence(Qt::CTRL | Qt::Key_E), [this] { exportShown(); });
    export_->setIconText(tr("Export"));
    export_->setToolTip(tr("Write the page that is shown to a file (Ctrl+E)"));
    menu->addSeparator();
    addAction(menu, "closeResult", {}, tr("&Close page"), QKeySequence(Qt::CTRL | Qt::Key_W),
              [this] {
                  if (tabs_->currentIndex() > 0)
                      delete tabs_->currentWidget();
              });
    addAction(menu, "quit", "quit", tr("&Quit"), QKeySequence(Qt::CTRL | Qt::Key_Q),
              [this] { close(); });
    bar_->addAction(open);
    bar_->addAction(save);
    bar_->addAction(export_);
    bar_->addSeparator();
}

void MainWindow::makeEditMenu(QMenu* menu) {
    auto* undo = workbench_.undoStack().createUndoAction(this, tr("&Undo"));
    undo->setObjectName("undo");
    undo->setIcon(icon("undo"));
    undo->setIconText(tr("Undo"));
    undo->setShortcut(QKeySequence::Undo);
    auto* redo = workbench_.undoStack().createRedoAction(this, tr("&Redo"));
    redo->setObjectName("redo");
    redo->setIcon(icon("redo"));
    redo->setIconText(tr("Redo"));
    redo->setShortcuts(
        {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), QKeySequence(Qt::CTRL | Qt::Key_Y)});
    undo->setProperty("listedAs", tr("Undo"));
    redo->setProperty("listedAs", tr("Redo"));
    menu->addActions({undo, redo});
    menu->addSeparator();
    addAction(menu, "preferences", "preferences", tr("&Preferences…"),
              QKeySequence(Qt::CTRL | Qt::Key_Comma), [this] { showPreferences(); });
}

void MainWindow::makeViewMenu(QMenu* menu) {
    if (view_ != nullptr) {
        page_->fillMenu(menu);
        auto* whole = menu->addAction(icon("home"), tr("Show the whole &model"), this, [this] {
            tabs_->setCurrentIndex(0);
            view_->showWholeModel();
        });
        whole->setObjectName("showWholeModel");
        ofProjectFile_.append(whole);
        ofProjectFile_.append(page_->modelActions());
        menu->addSeparator();
    }
    for (auto* dock : findChildren<QDockWidget*>(QString(), Qt::FindDirectChildrenOnly))
        menu->addAction(dock->toggleViewAction());
    addAction(menu, "collapseDocks", {}, tr("All docks away, or &back"), QKeySequence(Qt::Key_F6),
              [this] { layout_->toggleDocks(); });
}

void MainWindow::makeAnalysisMenu(QMenu* menu) {
    menu->setToolTipsVisible(true);
    int number = 0;
    for (const AnalysisKind kind : allAnalysisKinds()) {
        const QString word = QString::fromStdString(name(kind));
        auto* action = menu->addAction(icon(kind->icon), tr("New &%1 analysis…").arg(word), this,
                                       [this, kind] { newAnalysis(kind, workbench_.settings()); });
        action->setObjectName("new-" + word);
        action->setIconText(QString(word).replace(0, 1, word.left(1).toUpper()));
        action->setShortcut(QKeySequence(Qt::CTRL | static_cast<Qt::Key>(Qt::Key_1 + number++)));
        action->setData(tr("New %1 analysis (Ctrl+%2)").arg(word).arg(number));
        analyses_[kind] = action;
        bar_->addAction(action);
    }
    // Those the project names, as the starting point of a new one.
    ofProject_ = menu->addMenu(tr("&Of this project"));
    ofProject_->setObjectName("projectAnalyses");
    ofProject_->setToolTipsVisible(true);
    keepAnalysis_ =
        addAction(menu, "keepAnalysis", {}, tr("&Keep the shown analysis in the project"),
                  QKeySequence(Qt::CTRL | Qt::Key_K), [this] { keepShownAnalysis(); });
    menu->addSeparator();
    ofProjectFile_.append(addAction(menu, "analysisSettings", "sun", tr("Analysis s&ettings…"),
                                    QKeySequence(Qt::Key_F8),
                                    [this] { showSettings(SettingsDialog::tr("Band and mode")); }));
}

void MainWindow::makeToolsMenu(QMenu* menu) {
    addAction(menu, "compareImages", "compare", tr("&Compare images…"),
              QKeySequence(Qt::CTRL | Qt::Key_D), [this] { compareImages(); });
    addAirTools(*menu, workbench_, dialogs_,
                [this](QWidget* page, const QIcon& picture, const QString& title) {
                    addPage(page, picture, title);
                });
    addAction(menu, "monteCarlo", "montecarlo", tr("&Monte Carlo"), QKeySequence(), [this] {
        const AnalysisKind kind = AnalysisKind::monteCarlo;
        addPage(new MonteCarloPage(workbench_, dialogs_), icon(kind->icon), tr(kind->title));
    });
    menu->addSeparator();
    ofProjectFile_.append(addAction(menu, "options", "options", tr("&Options…"),
                                    QKeySequence(Qt::Key_F9),
                                    [this] { showSettings(SettingsDialog::tr("Antialiasing")); }));
}

void MainWindow::makeHelpMenu(QMenu* menu) {
    addAction(menu, "openGuide", "info", tr("User &guide"), QKeySequence(Qt::SHIFT | Qt::Key_F1),
              [this] { openGuide(); });
    auto* keys = addAction(menu, "showShortcuts", "keyboard", tr("&Keys and mouse"), {}, [this] {
        ShortcutsDialog dialog(*menuBar(), results_->commands(), this);
        dialogs_.run(dialog);
    });
    keys->setShortcuts({QKeySequence(Qt::Key_F1), QKeySequence(Qt::Key_Question)});
    addAction(menu, "findCommand", "find", tr("&Find a command…"),
              QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_P), [this] {
                  CommandPalette palette(*menuBar(), this);
                  QPointer<QAction> chosen;
                  if (dialogs_.run(palette))
                      chosen = palette.chosen();
                  if (chosen != nullptr)
                      chosen->trigger();
              });
    addAction(menu, "showAbout", "info", tr("&About SMAT"), {}, [this] { showAbout(); });
}

} // namespace smat::gui
