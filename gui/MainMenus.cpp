
#include <QMenu>
#include <QMenuBar>
#include <QTabWidget>
#include <QToolBar>

#include "gui/HelpDialogs.h"
#include "gui/MainWindow.h"
#include "gui/Theme.h"
#include "gui/view/SceneView.h"

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

void MainWindow::makeFileMenu(QMenu* menu) {
    auto* open = menu->addAction(icon("open"), tr("&Open…"), this, &MainWindow::chooseProject);
    open->setObjectName("openProject");
    open->setShortcut(QKeySequence::Open);
    open->setToolTip(tr("Open a project or a model (Ctrl+O)"));
    auto* recent = menu->addMenu(icon("recent"), tr("Open &recent"));
    recent->setObjectName("recentFiles");
    connect(recent, &QMenu::aboutToShow, this, [this, recent] { fillRecent(recent); });
    menu->addSeparator();
    export_ = menu->addAction(icon("export"), tr("&Export…"), this, &MainWindow::exportShown);
    export_->setObjectName("exportShown");
    export_->setIconText(tr("Export"));
    export_->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_E));
    export_->setToolTip(tr("Write the page that is shown to a file (Ctrl+E)"));
    auto* close = menu->addAction(tr("&Close page"), this, [this] {
        if (tabs_->currentIndex() > 0)
            delete tabs_->currentWidget();
    });
    close->setObjectName("closeResult");
    close->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_W));
    menu->addSeparator();
    auto* quit = menu->addAction(icon("quit"), tr("&Quit"), this, &QWidget::close);
    quit->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_Q));
    bar_->addAction(open);
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
    menu->addActions({undo, redo});
}

void MainWindow::makeViewMenu(QMenu* menu) {
    if (view_ != nullptr) {
        auto* wire = menu->addAction(icon("wireframe"), tr("&Wireframe"));
        wire->setObjectName("wireframe");
        wire->setCheckable(true);
        wire->setShortcut(QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_W));
        connect(wire, &QAction::toggled, view_, &SceneView::setWireframe);
        auto* axes = menu->addAction(icon("axes"), tr("&Axes"));
        axes->setObjectName("axes");
        axes->setCheckable(true);
        axes->setChecked(true);
        axes->setShortcut(QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_A));
        connect(axes, &QAction::toggled, view_, &SceneView::setAxesVisible);
        auto* whole = menu->addAction(icon("home"), tr("Show the whole &model"), this, [this] {
            if (workbench_.hasProject())
                view_->showWholeModel();
        });
        whole->setObjectName("showWholeModel");
        menu->addSeparator();
    }
    for (auto* dock : findChildren<QDockWidget*>(QString(), Qt::FindDirectChildrenOnly))
        menu->addAction(dock->toggleViewAction());
}

void MainWindow::makeAnalysisMenu(QMenu* menu) {
    int number = 0;
    for (const AnalysisKind kind : allAnalysisKinds) {
        const QString word = QString::fromStdString(name(kind));
        auto* action = menu->addAction(icon(word), tr("New &%1 analysis…").arg(word), this,
                                       [this, kind] { newAnalysis(kind, workbench_.settings()); });
        action->setObjectName("new-" + word);
        action->setIconText(QString(word).replace(0, 1, word.left(1).toUpper()));
        action->setShortcut(QKeySequence(Qt::CTRL | static_cast<Qt::Key>(Qt::Key_1 + number++)));
        action->setToolTip(tr("New %1 analysis (Ctrl+%2)").arg(word).arg(number));
        analyses_[kind] = action;
        bar_->addAction(action);
    }
    // Those the project names, as the starting point of a new one.
    ofProject_ = menu->addMenu(tr("Of this &project"));
    ofProject_->setObjectName("projectAnalyses");
    ofProject_->setToolTipsVisible(true);
}

void MainWindow::makeToolsMenu(QMenu*) {}

void MainWindow::makeHelpMenu(QMenu* menu) {
    auto* keys = menu->addAction(icon("keyboard"), tr("&Keys and mouse"), this, [this] {
        ShortcutsDialog dialog(this);
        dialogs_.run(dialog);
    });
    keys->setObjectName("showShortcuts");
    keys->setShortcut(QKeySequence(Qt::Key_F1));
    menu->addAction(icon("info"), tr("&About SMAT"), this, &MainWindow::showAbout)
        ->setObjectName("showAbout");
}

} // namespace smat::gui
