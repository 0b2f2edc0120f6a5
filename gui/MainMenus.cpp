#include "gui/MainMenus.h"

#include <QDockWidget>
#include <QFileInfo>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QPointer>
#include <QToolBar>

#include "gui/CommandPalette.h"
#include "gui/FileOpening.h"
#include "gui/HelpDialogs.h"
#include "gui/MainDialogs.h"
#include "gui/WindowLayout.h"
#include "gui/analysis/AnalysisPreconditions.h"
#include "gui/analysis/ResultPage.h"
#include "gui/analysis/ResultsDock.h"
#include "gui/atmosphere/AtmospherePages.h"
#include "gui/database/DatabaseDock.h"
#include "gui/image/ImagePages.h"
#include "gui/image/LinkedViews.h"
#include "gui/project/ProjectFiles.h"
#include "gui/project/SceneModelActs.h"
#include "gui/project/SceneTreeDock.h"
#include "gui/scenario/ScenarioPages.h"
#include "gui/settings/SettingsDialog.h"
#include "gui/start/DataFolder.h"
#include "gui/tools/SelfTestDialog.h"
#include "gui/tools/ToolPages.h"
#include "gui/view/ModelPage.h"
#include "gui/view/ProjectView.h"
#include "gui/view/StatePage.h"
#include "gui/widgets/Theme.h"
#include "gui/workbench/DocumentPage.h"
#include "gui/workbench/PageTabs.h"
#include "gui/workbench/Workbench.h"
#include "smatcore/analysis/AnalysisDefinition.h"

namespace smat::gui {

MainMenus::MainMenus(const MainParts& parts) : QObject(&parts.window), with_(parts) {
    bar_ = with_.window.addToolBar(tr("Tool bar"));
    bar_->setObjectName("toolBar");
    bar_->setIconSize(QSize(22, 22));
    bar_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    bar_->setMovable(false);

    QMenuBar& menus = *with_.window.menuBar();
    makeFileMenu(menus.addMenu(tr("&File")));
    makeEditMenu(menus.addMenu(tr("&Edit")));
    makeViewMenu(menus.addMenu(tr("&View")));
    makeAnalysisMenu(menus.addMenu(tr("&Analysis")));
    auto* tools = menus.addMenu(tr("&Tools"));
    makeToolsMenu(tools);
    tools->menuAction()->setVisible(!tools->isEmpty());
    makeHelpMenu(menus.addMenu(tr("&Help")));
}

QAction* MainMenus::add(QMenu* menu, const QString& name, const QString& drawing,
                        const QString& text, const QKeySequence& keys,
                        const std::function<void()>& act) {
    auto* action = drawing.isEmpty() ? menu->addAction(text) : menu->addAction(icon(drawing), text);
    action->setObjectName(name);
    action->setShortcut(keys);
    connect(action, &QAction::triggered, this, act);
    return action;
}

void MainMenus::makeFileMenu(QMenu* menu) {
    add(menu, "newProject", "new", tr("&New project…"), QKeySequence::New,
        [this] { with_.files.newProject(); });
    auto* scenario = add(menu, "newScenario", "scenario", tr("New scenario…"), {},
                         [this] { with_.scenarios.begin(); });
    scenario->setToolTip(tr("Begins a scenario with the models of the project where they stand and "
                            "a sensor where the camera is"));
    needProject_.append(scenario);
    auto* open = add(menu, "openProject", "open", tr("&Open…"), QKeySequence::Open,
                     [this] { with_.opening.choose(); });
    open->setToolTip(tr("Open a project, a model, a scenario, a result or an image (Ctrl+O)"));
    add(menu, "openModel", "model", tr("Open &model…"),
        QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_O), [this] { with_.files.chooseModel(); });
    auto* recent = menu->addMenu(icon("recent"), tr("Open &recent"));
    recent->setObjectName("recentFiles");
    connect(recent, &QMenu::aboutToShow, this, [this, recent] { fillRecent(recent); });
    auto* samplesMenu = menu->addMenu(icon("model"), tr("Sam&ples"));
    samplesMenu->setObjectName("samples");
    for (const Sample& sample : samples()) {
        auto* action = samplesMenu->addAction(sample.title, this, [this, file = sample.project] {
            with_.opening.open({QString::fromStdString(file.string())});
        });
        action->setToolTip(sample.words);
    }
    samplesMenu->setEnabled(!samplesMenu->isEmpty());
    menu->addSeparator();
    auto* save = add(menu, "saveProject", "save", tr("&Save project"), QKeySequence::Save, [this] {
        if (DocumentPage* shown = with_.tabs.shownDocument())
            shown->save();
        else
            with_.files.save();
    });
    save->setIconText(tr("Save"));
    save->setToolTip(tr("Save the project (Ctrl+S)"));
    auto* saveAs = add(menu, "saveProjectAs", {}, tr("Save project &as…"),
                       QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S), [this] {
                           if (DocumentPage* shown = with_.tabs.shownDocument())
                               shown->saveAs();
                           else
                               with_.files.saveAs();
                       });
    saves_ = {save, saveAs};
    auto* collect =
        add(menu, "collectFiles", {}, tr("Co&llect files…"), {}, [this] { with_.files.collect(); });
    collect->setToolTip(tr("Writes a copy of the project with all files that it needs beside it"));
    needProject_.append(collect);
    needProject_.append(add(menu, "projectProperties", {}, tr("Project proper&ties…"),
                            QKeySequence(Qt::ALT | Qt::Key_Return),
                            [this] { with_.ask.showProjectProperties(); }));
    auto* first = add(menu, "firstSignature", "library", tr("First si&gnature from names…"), {},
                      [this] { with_.ask.makeFirstSignature(); });
    first->setToolTip(tr("Gives a model without codes materials and temperatures by the names in "
                         "its file"));
    needProject_.append(first);
    menu->addSeparator();
    addDatabaseActions(menu);
    menu->addSeparator();
    add(menu, "convertModel", "import", tr("&Import or convert a model…"),
        QKeySequence(Qt::CTRL | Qt::Key_I), [this] { with_.ask.convertModel(); });
    auto* takeSensor = add(menu, "importImagingSensor", {}, tr("Import imaging sensor &file…"), {},
                           [this] { with_.ask.importImagingSensor(); });
    takeSensor->setToolTip(tr("Takes the settings of an ImagingSensor file of KARMA (XML)"));
    auto* writeSensor = add(menu, "exportImagingSensor", {}, tr("&Write imaging sensor file…"), {},
                            [this] { with_.ask.exportImagingSensor(); });
    writeSensor->setToolTip(tr("Writes the settings as an ImagingSensor file of KARMA (XML)"));
    needProject_.append(takeSensor);
    needProject_.append(writeSensor);
    export_ = add(menu, "exportShown", "export", tr("&Export…"), QKeySequence(Qt::CTRL | Qt::Key_E),
                  [this] { with_.tabs.exportShown(with_.dialogs); });
    export_->setIconText(tr("Export"));
    export_->setToolTip(tr("Write the page that is shown to a file (Ctrl+E)"));
    menu->addSeparator();
    close_ = add(menu, "closeResult", {}, tr("&Close page"), QKeySequence(Qt::CTRL | Qt::Key_W),
                 [this] { with_.tabs.closeShown(); });
    add(menu, "quit", "quit", tr("&Quit"), QKeySequence(Qt::CTRL | Qt::Key_Q),
        [this] { with_.window.close(); });
    bar_->addAction(open);
    bar_->addAction(save);
    bar_->addAction(export_);
    bar_->addSeparator();
}

void MainMenus::addDatabaseActions(QMenu* menu) {
    needProject_.append(add(menu, "openDatabase", "database", tr("Open &database…"), {},
                            [this] { with_.database.files().open(); }));
    saveDatabase_ = add(menu, "saveDatabase", {}, tr("Save data&base"),
                        QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_D),
                        [this] { with_.database.files().save(); });
    saveDatabaseAs_ = add(menu, "saveDatabaseAs", {}, tr("Save database as…"), {},
                          [this] { with_.database.files().saveAs(); });
}

void MainMenus::makeEditMenu(QMenu* menu) {
    auto* undo = with_.workbench.undoStack().createUndoAction(this, tr("&Undo"));
    undo->setObjectName("undo");
    undo->setIcon(icon("undo"));
    undo->setIconText(tr("Undo"));
    undo->setShortcut(QKeySequence::Undo);
    auto* redo = with_.workbench.undoStack().createRedoAction(this, tr("&Redo"));
    redo->setObjectName("redo");
    redo->setIcon(icon("redo"));
    redo->setIconText(tr("Redo"));
    redo->setShortcuts(
        {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), QKeySequence(Qt::CTRL | Qt::Key_Y)});
    undo->setProperty("listedAs", tr("Undo"));
    redo->setProperty("listedAs", tr("Redo"));
    menu->addActions({undo, redo});
    menu->addSeparator();
    addModelActions(menu);
    menu->addSeparator();
    add(menu, "preferences", "preferences", tr("&Preferences…"),
        QKeySequence(Qt::CTRL | Qt::Key_Comma), [this] { with_.ask.showPreferences(); });
}

void MainMenus::addModelActions(QMenu* menu) {
    Workbench& workbench = with_.workbench;
    needProject_.append(add(menu, "addModel", "model", tr("Add a &model to the scene…"),
                            QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_L),
                            [this] { with_.models.chooseAndAdd(); }));
    needProject_.append(
        add(menu, "renameModel", {}, tr("Re&name the chosen model"), {}, [this, &workbench] {
            with_.tree.show();
            with_.tree.raise();
            with_.tree.rename(static_cast<int>(workbench.chosenModel()));
        }));
    makeTarget_ = add(menu, "makeTarget", {}, tr("Make the chosen model the &target"), {},
                      [this, &workbench] { with_.models.makeTarget(workbench.chosenModel()); });
    makeTarget_->setToolTip(tr("The camera then turns about it; nothing moves"));
    removeModel_ = add(menu, "removeModel", {}, tr("Remo&ve the chosen model from the scene"), {},
                       [this, &workbench] { with_.models.remove(workbench.chosenModel()); });
}

void MainMenus::makeViewMenu(QMenu* menu) {
    if (with_.view != nullptr) {
        with_.view->page()->fillMenu(menu);
        auto* whole = menu->addAction(icon("home"), tr("Show the whole &model"), this, [this] {
            with_.tabs.setCurrentIndex(0);
            with_.view->view()->showWholeModel();
        });
        whole->setObjectName("showWholeModel");
        whole->setToolTip(tr("Moves the sensor to where the whole target is seen"));
        needProject_.append(whole);
        wholeScene_ = menu->addAction(tr("Show the whole scen&e"), this, [this] {
            with_.tabs.setCurrentIndex(0);
            with_.view->view()->showWholeScene();
        });
        wholeScene_->setObjectName("showWholeScene");
        wholeScene_->setToolTip(
            tr("Moves the sensor, which looks at the target, to where all models are seen"));
        needProject_.append(with_.view->page()->modelActions());
        menu->addSeparator();
    }
    beside_ = add(menu, "moveAcross", "columns", tr("Show the page &beside the others"),
                  QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_B),
                  [this] { with_.tabs.moveAcross(with_.tabs.shownPage()); });
    beside_->setToolTip(tr("Two pages side by side; a second time it goes back"));
    auto* link = add(menu, "linkImages", {}, tr("Lin&k image pages"), {}, [] {});
    link->setCheckable(true);
    link->setChecked(LinkedViews::instance().isOn());
    link->setToolTip(tr("Images of equal size show the same part and read the same pixel"));
    connect(link, &QAction::toggled, &LinkedViews::instance(), &LinkedViews::setOn);
    if (with_.view != nullptr) {
        auto* keep = add(menu, "keepState", "keep-state", tr("Keep this st&ate beside"),
                         QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_K), [this] { keepState(); });
        keep->setToolTip(tr("A second view of the project as it is now; both turn together while "
                            "one is edited"));
        needProject_.append(keep);
    }
    menu->addSeparator();
    for (auto* dock :
         with_.window.findChildren<QDockWidget*>(QString(), Qt::FindDirectChildrenOnly))
        menu->addAction(dock->toggleViewAction());
    add(menu, "collapseDocks", {}, tr("&Hide or show panels"), QKeySequence(Qt::Key_F6),
        [this] { with_.layout.toggleDocks(); });
}

void MainMenus::keepState() {
    const QString step = with_.workbench.undoStack().undoText();
    const QString title = tr("State %1").arg(++states_);
    auto* page = new StatePage(with_.workbench, *with_.view->view(),
                               step.isEmpty() ? tr("%1: as opened").arg(title)
                                              : tr("%1: after “%2”").arg(title, step));
    with_.tabs.addPage(page, icon("eye"), title);
    with_.tabs.moveAcross(page);
    with_.tabs.setCurrentIndex(0);
    connect(&with_.workbench, &Workbench::projectOpened, page,
            [this, page] { with_.tabs.close(page); });
}

/// A word with its first letter that no other has, marked.
static QString withLetter(QString word, QString& taken) {
    for (qsizetype i = 0; i < word.size(); ++i)
        if (!taken.contains(word[i])) {
            taken += word[i];
            return word.insert(i, '&');
        }
    return word;
}

void MainMenus::makeAnalysisMenu(QMenu* menu) {
    menu->setToolTipsVisible(true);
    int number = 0;
    QString letters;
    for (const AnalysisKind kind : allAnalysisKinds()) {
        const QString word = QString::fromStdString(name(kind));
        auto* action = menu->addAction(
            icon(kind->icon), tr("New %1 analysis…").arg(withLetter(word, letters)), this,
            [this, kind] { with_.ask.newAnalysis(kind, with_.workbench.settings()); });
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
        add(menu, "keepAnalysis", {}, tr("&Keep the shown analysis in the project"),
            QKeySequence(Qt::CTRL | Qt::Key_K), [this] { with_.ask.keepShownAnalysis(); });
    menu->addSeparator();
    needProject_.append(
        add(menu, "analysisSettings", "sun", tr("Analysis s&ettings…"), QKeySequence(Qt::Key_F8),
            [this] { with_.ask.showSettings(SettingsDialog::tr("Band and mode")); }));
}

void MainMenus::makeToolsMenu(QMenu* menu) {
    add(menu, "compareImages", "compare", tr("&Compare images…"),
        QKeySequence(Qt::CTRL | Qt::Key_D), [this] { with_.images.compare(); });
    add(menu, "newAir", "air", tr("New &atmosphere"), {}, [this] {
        with_.air.makeNew();
    })->setToolTip(tr("Parameters of an AtmosphereSmart with what they do to the scene"));
    needProject_.append(add(menu, "projectAir", "air", tr("&Project atmospheres"), {},
                            [this] { with_.air.showProjectAtmosphere(); }));
    add(menu, "importAir", "import", tr("&Import MODTRAN results…"), {},
        [this] { with_.air.importTables(); });
    addToolPages(*menu, with_.workbench, with_.dialogs,
                 [this](QWidget* page, const QIcon& picture, const QString& title) {
                     with_.tabs.addPage(page, picture, title);
                 });
    menu->addSeparator();
    needProject_.append(
        add(menu, "options", "options", tr("&Options…"), QKeySequence(Qt::Key_F9),
            [this] { with_.ask.showSettings(SettingsDialog::tr("Antialiasing")); }));
}

void MainMenus::makeHelpMenu(QMenu* menu) {
    add(menu, "openGuide", "question", tr("User &guide"), QKeySequence(Qt::SHIFT | Qt::Key_F1),
        [this] { with_.ask.showGuide(); });
    auto* keys = add(menu, "showShortcuts", "keyboard", tr("&Keys and mouse"), {}, [this] {
        ShortcutsDialog dialog(*with_.window.menuBar(), with_.results.commands(), &with_.window);
        with_.dialogs.run(dialog);
    });
    keys->setShortcuts({QKeySequence(Qt::Key_F1), QKeySequence(Qt::Key_Question)});
    add(menu, "findCommand", "find", tr("&Find a command…"),
        QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_P), [this] {
            CommandPalette palette(*with_.window.menuBar(), &with_.window);
            QPointer<QAction> chosen;
            if (with_.dialogs.run(palette))
                chosen = palette.chosen();
            if (chosen != nullptr)
                chosen->trigger();
        });
    add(menu, "selfTest", "check-physics", tr("&Self-test…"), {}, [this] {
        SelfTestDialog dialog(&with_.window);
        with_.dialogs.run(dialog);
    });
    add(menu, "showAbout", "info", tr("&About SMAT"), {}, [this] {
        with_.ask.showAbout(with_.view != nullptr ? with_.view->view()->renderer()
                                                  : tr("no OpenGL on this desktop"));
    });
}

void MainMenus::fillRecent(QMenu* menu) {
    menu->clear();
    int number = 1;
    for (const auto& file : with_.workbench.recentFiles()) {
        const bool exists = QFileInfo::exists(file);
        auto* action = menu->addAction(
            QStringLiteral("&%1  %2").arg(number++).arg(QString(file).replace('&', "&&")), this,
            [this, file] { with_.opening.open({file}); });
        action->setEnabled(exists);
        if (!exists)
            action->setText(action->text() + tr("  (not there)"));
    }
    if (menu->isEmpty())
        menu->addAction(tr("No files yet"))->setEnabled(false);
}

void MainMenus::followProject() {
    ofProject_->clear();
    for (const auto& analysis : with_.workbench.project().analyses) {
        const QString title = QString::fromStdString(analysis.name);
        auto* action = ofProject_->addAction(
            icon(analysis.kind->icon), title + "…", this, [this, analysis, title] {
                with_.ask.newAnalysis(analysis.kind,
                                      with_.workbench.settings().with(analysis.settings), title);
            });
        action->setToolTip(QString::fromStdString(analysis.notes));
    }
}

void MainMenus::refresh() {
    export_->setEnabled(with_.tabs.mayExportShown());
    close_->setEnabled(with_.tabs.mayCloseShown());
    beside_->setEnabled(with_.tabs.mayMoveShown());
    beside_->setText(with_.tabs.isBeside(with_.tabs.shownPage())
                         ? tr("Put the page &back to the others")
                         : tr("Show the page &beside the others"));
    const ResultPage* page = with_.tabs.currentResult();
    keepAnalysis_->setEnabled(with_.workbench.hasProject() && page != nullptr &&
                              page->resultIds().size() == 1);
    for (auto* action : needProject_)
        action->setEnabled(with_.workbench.hasProject());
    const bool areSeveral =
        with_.workbench.hasProject() && with_.workbench.project().models.size() > 1;
    removeModel_->setEnabled(areSeveral);
    makeTarget_->setEnabled(areSeveral && with_.workbench.chosenModel() > 0);
    if (with_.view != nullptr) {
        wholeScene_->setEnabled(areSeveral);
        with_.view->page()->fitChosenAction()->setEnabled(areSeveral);
    }
    const DocumentPage* shown = with_.tabs.shownDocument();
    for (auto* action : saves_)
        action->setEnabled(shown != nullptr || with_.workbench.hasProject());
    const QString noun = shown != nullptr ? shown->noun() : tr("project");
    saves_.front()->setText(tr("&Save %1").arg(noun));
    saves_.front()->setIconText(tr("Save"));
    saves_.front()->setToolTip(shown != nullptr ? tr("Save the %1 that is shown (Ctrl+S)").arg(noun)
                                                : tr("Save the project (Ctrl+S)"));
    saves_.back()->setText(tr("Save %1 &as…").arg(noun));
    const DatabaseSession& database = with_.workbench.database();
    saveDatabase_->setEnabled(database.isOpen() && database.isDirty() &&
                              database.access() == DatabaseSession::Access::edit);
    saveDatabaseAs_->setEnabled(database.isOpen());
    const bool ready = with_.workbench.hasProject();
    const QString missing = missingPreconditions(with_.workbench);
    for (const auto& [kind, action] : analyses_) {
        action->setEnabled(missing.isEmpty());
        const QString tip = action->data().toString();
        action->setToolTip(missing.isEmpty() ? tip : tip + "\n" + missing);
        action->setStatusTip(missing);
    }
    ofProject_->menuAction()->setVisible(with_.workbench.hasProject() && !ofProject_->isEmpty());
    ofProject_->setEnabled(ready);
}

} // namespace smat::gui

#include "moc_MainMenus.cpp"
