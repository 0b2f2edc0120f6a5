#include "gui/MainWindow.h"

#include <algorithm>

#include <QApplication>
#include <QCloseEvent>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QLabel>
#include <QMenu>
#include <QMimeData>
#include <QScrollArea>
#include <QStatusBar>
#include <QTabWidget>

#include "gui/Exportable.h"
#include "gui/ManipulatorsDock.h"
#include "gui/Sentences.h"
#include "gui/Theme.h"
#include "gui/UnsavedNote.h"
#include "gui/Widgets.h"
#include "gui/WindowLayout.h"
#include "gui/analysis/AnalysisGeneratorDialog.h"
#include "gui/analysis/JobBar.h"
#include "gui/analysis/MissingForAnalyses.h"
#include "gui/analysis/ResultPage.h"
#include "gui/analysis/ResultPages.h"
#include "gui/analysis/ResultsDock.h"
#include "gui/database/DatabaseDock.h"
#include "gui/database/DatabasePreview.h"
#include "gui/project/NamedAnalyses.h"
#include "gui/project/ProjectFiles.h"
#include "gui/project/SceneTreeDock.h"
#include "gui/settings/SettingsDialog.h"
#include "gui/start/GuidePage.h"
#include "gui/start/StartPage.h"
#include "gui/view/BandBox.h"
#include "gui/view/LoadingBar.h"
#include "gui/view/ModelPage.h"
#include "gui/view/SceneLoader.h"
#include "gui/view/SceneView.h"
#include "irsg/radiometry/Errors.h"
#include "smatcore/analysis/kinds/AnalysisDefinition.h"
#include "smatcore/project/SceneBuilder.h"

namespace smat::gui {
MainWindow::MainWindow(Workbench& workbench, Dialogs dialogs, QWidget* parent)
    : QMainWindow(parent), workbench_(workbench), dialogs_(std::move(dialogs)) {
    setObjectName("mainWindow");
    setWindowTitle("SMAT");
    setWindowIcon(icon("smat"));
    setAcceptDrops(true);
    QStringList problems;
    preferences_ = Preferences::load(&problems);
    files_ = new ProjectFiles(workbench_, dialogs_, preferences_, this);
    loading_ = new LoadingBar(this);
    loading_->follow(files_->opening());
    statusBar()->addPermanentWidget(loading_);
    makeCentre();
    makeDocks();
    makeMenus();
    statusBar()->showMessage(problems.isEmpty() ? tr("Open a project (Ctrl+O), or drop one here")
                                                : problems.join("   "));
    connectWorkbench();
    makeStartPage();
    layout_ = new WindowLayout(*this);
    layout_->restore();
    refreshActions();
    for (auto* dock : findChildren<QDockWidget*>(QString(), Qt::FindDirectChildrenOnly))
        tabAsOneReads(*dock);
    const auto readPage = [this] {
        if (tabs_->currentWidget() != nullptr)
            tabAsOneReads(*tabs_->currentWidget());
    };
    readPage();
    connect(tabs_, &QTabWidget::currentChanged, this, readPage);
}

MainWindow::~MainWindow() = default;

void MainWindow::makeDocks() {
    tree_ = new SceneTreeDock(workbench_, this);
    addDockWidget(Qt::LeftDockWidgetArea, tree_);
    auto* manipulators = new ManipulatorsDock(workbench_, this);
    addDockWidget(Qt::LeftDockWidgetArea, manipulators);
    results_ = new ResultsDock(workbench_, dialogs_, this);
    addDockWidget(Qt::RightDockWidgetArea, results_);
    databaseDock_ = new DatabaseDock(workbench_, dialogs_, this);
    addDockWidget(Qt::RightDockWidgetArea, databaseDock_);
    tabifyDockWidget(results_, databaseDock_);
    results_->raise();
    for (QDockWidget* dock :
         {static_cast<QDockWidget*>(results_), static_cast<QDockWidget*>(databaseDock_)})
        keepKeysFromHiddenTab(*dock);
    files_->addSettler([this] { return databaseDock_->mayClose(); });
    resizeDocks({tree_, manipulators}, {310, 410}, Qt::Vertical);

    connect(tree_, &SceneTreeDock::modelFileWanted, this,
            [this](int model) { files_->chooseModelFile(static_cast<std::size_t>(model)); });
    connect(tree_, &SceneTreeDock::databaseFileWanted, this, [this](int model) {
        // The target's is being edited here.
        if (model == 0)
            databaseDock_->openDatabase();
        else
            files_->chooseDatabaseFile(static_cast<std::size_t>(model));
    });
    // The target's entries are edited here; those of other models are only marked.
    const auto edit = [this](IndexKind kind, int index, int model) {
        if (model == 0)
            databaseDock_->select(
                {kind == IndexKind::temperature ? EntryKind::temperature : EntryKind::material,
                 index});
    };
    connect(tree_, &SceneTreeDock::indexSelected, databaseDock_, edit);
    connect(tree_, &SceneTreeDock::indexActivated, databaseDock_,
            [this, edit](IndexKind kind, int index, int model) {
                edit(kind, index, model);
                databaseDock_->show();
                databaseDock_->raise();
            });
    if (view_ != nullptr) {
        makeLoader();
        joinTreeAndView();
        new DatabasePreview(workbench_, *databaseDock_, *view_, this);
    }
    connect(tree_, &SceneTreeDock::sensorActivated, this,
            [this] { showSettings(SettingsDialog::tr("Sensor")); });
    connect(tree_, &SceneTreeDock::sunActivated, this,
            [this] { showSettings(SettingsDialog::tr("Sun and fluxes")); });
    connect(tree_, &SceneTreeDock::atmosphereActivated, this,
            [this] { showSettings(SettingsDialog::tr("Atmosphere")); });
    connect(tree_, &SceneTreeDock::removeAnalysisWanted, this, [this](const QString& name) {
        workbench_.edit(withoutAnalysis(workbench_.project(), name.toStdString()),
                        tr("Remove analysis %1").arg(name));
    });
    connect(tree_, &SceneTreeDock::propertiesWanted, this, &MainWindow::showProjectProperties);
    connect(tree_, &SceneTreeDock::analysisActivated, this, [this](const QString& name) {
        if (const auto* analysis = workbench_.project().find(name.toStdString()))
            newAnalysis(analysis->kind, workbench_.settings().with(analysis->settings), name);
    });
}

void MainWindow::connectWorkbench() {
    connect(&files_->opening(), &ModelWait::cancelled, this, [this](const QString& name) {
        statusBar()->showMessage(tr("%1 was not opened").arg(name));
    });
    connect(&workbench_, &Workbench::projectOpened, this, &MainWindow::onProjectOpened);
    connect(&workbench_, &Workbench::projectChanged, this, &MainWindow::onProjectChanged);
    connect(&workbench_, &Workbench::modifiedChanged, this, &MainWindow::refreshTitle);
    connect(&workbench_, &Workbench::settingsChanged, this, &MainWindow::onSettingsChanged);
    connect(&workbench_.resultStore(), &ResultStore::problems, this,
            [this](const QStringList& sentences) {
                dialogs_.tell(this, tr("Results of the project"), sentences);
            });
    statusBar()->addPermanentWidget(new JobBar(workbench_, this));
    connect(&workbench_.database(), &DatabaseSession::stateChanged, this,
            &MainWindow::refreshActions);
    connect(&workbench_.database(), &DatabaseSession::opened, this, &MainWindow::refreshActions);
    connect(&workbench_, &Workbench::resultAdded, this, [this](int id) {
        sceneRenderer_ = QString::fromStdString(workbench_.result(id)->data->renderer);
    });
    connect(&workbench_, &Workbench::jobFailed, this,
            [this](const QStringList& sentences, bool ourFault) {
                dialogs_.tell(this,
                              ourFault ? tr("Internal error") : tr("The analysis cannot be run"),
                              sentences);
            });
    auto* pages = new ResultPages(workbench_, dialogs_, tabs_);
    connect(results_, &ResultsDock::showRequested, pages, &ResultPages::show);
    connect(results_, &ResultsDock::comparisonRequested, this, &MainWindow::compareResults);
    connect(pages, &ResultPages::said, this,
            [this](const QString& sentence) { statusBar()->showMessage(sentence); });
    openWith({"csv", "json", "exr", "txt", "dat"},
             [this](const std::filesystem::path& file) { return results_->openResult(file); });
    connect(files_, &ProjectFiles::said, this,
            [this](const QString& sentence) { statusBar()->showMessage(sentence, 10000); });
}

void MainWindow::makeCentre() {
    tabs_ = new QTabWidget(this);
    tabs_->setObjectName("tabs");
    tabs_->setTabsClosable(true);
    tabs_->setMovable(false);
    tabs_->setDocumentMode(true);
    if (const QString problem = SceneView::problem(); problem.isEmpty()) {
        page_ = new ModelPage(tabs_);
        view_ = page_->view();
        tabs_->addTab(page_, icon("axes"), tr("Model"));
        view_->installEventFilter(this);
        auto* band = new BandBox(workbench_, page_);
        page_->addField(band);
        connect(band, &BandBox::refused, this, [this](const QStringList& sentences) {
            dialogs_.tell(this, tr("This is no band"), sentences);
        });
        connect(view_, &SceneView::cameraMoved, this, [this](const OrbitCamera& camera) {
            if (workbench_.hasProject())
                workbench_.setCamera(camera);
        });
    } else {
        auto* notice = new QLabel(problem, tabs_);
        notice->setObjectName("noGlNotice");
        notice->setAlignment(Qt::AlignCenter);
        notice->setForegroundRole(QPalette::PlaceholderText);
        tabs_->addTab(notice, icon("axes"), tr("Model"));
    }
    for (const auto side : {QTabBar::LeftSide, QTabBar::RightSide})
        tabs_->tabBar()->setTabButton(0, side, nullptr);
    // A page that needs more room than there is scrolls; the window keeps its size.
    auto* centre = new QScrollArea(this);
    centre->setObjectName("centre");
    centre->setFrameShape(QFrame::NoFrame);
    centre->setWidgetResizable(true);
    centre->setFocusPolicy(Qt::NoFocus);
    centre->setMinimumSize(380, 300);
    centre->setWidget(tabs_);
    setCentralWidget(centre);
    connect(tabs_, &QTabWidget::tabCloseRequested, this, [this](int index) {
        if (index > 0)
            delete tabs_->widget(index);
    });
    letShownPageAloneAskForRoom(*tabs_);
    connect(tabs_, &QTabWidget::currentChanged, this, &MainWindow::refreshActions);
}

void MainWindow::joinTreeAndView() {
    connect(tree_, &SceneTreeDock::indexSelected, view_,
            [this](IndexKind kind, int index, int model) {
                FaceSelection faces{.temperature = {}, .material = {}, .model = model};
                (kind == IndexKind::temperature ? faces.temperature : faces.material) = index;
                view_->setHighlighted(faces);
            });
    connect(tree_, &SceneTreeDock::nothingSelected, view_, [this] { view_->setHighlighted({}); });
    connect(view_, &SceneView::facePicked, tree_, [this](int temperature, int, int model) {
        tree_->showIndex(IndexKind::temperature, temperature, model);
    });
}

void MainWindow::addPage(QWidget* page, const QIcon& icon, const QString& title) {
    tabs_->setCurrentIndex(tabs_->addTab(page, icon, title));
}

FileChooser MainWindow::fileChooser() {
    return [this](const QString& title, const QString& filter) {
        return dialogs_.openFile(this, title, {filter});
    };
}

bool MainWindow::open(const std::filesystem::path& file) {
    return files_->open(file);
}

void MainWindow::openWith(const QStringList& suffixes,
                          std::function<bool(const std::filesystem::path&)> opener) {
    openers_.emplace_back(suffixes, std::move(opener));
}

void MainWindow::fillRecent(QMenu* menu) {
    menu->clear();
    int number = 1;
    for (const auto& file : workbench_.recentFiles()) {
        const bool exists = QFileInfo::exists(file);
        auto* action = menu->addAction(
            QStringLiteral("&%1  %2").arg(number++).arg(QString(file).replace('&', "&&")), this,
            [this, file] { open(file.toStdString()); });
        action->setEnabled(exists);
        if (!exists)
            action->setText(action->text() + tr("  (not there)"));
    }
    if (menu->isEmpty())
        menu->addAction(tr("No files yet"))->setEnabled(false);
}

void MainWindow::onProjectOpened() {
    refreshTitle();
    statusBar()->showMessage(QString::fromStdString(workbench_.project().file.string()), 8000);
    fillProjectAnalyses();
    if (view_ != nullptr)
        showModel();
    tabs_->setCurrentIndex(0);
    refreshActions();
}

void MainWindow::onProjectChanged() {
    refreshTitle();
    fillProjectAnalyses();
    refreshActions();
    if (view_ != nullptr && workbench_.project().models != shownModels_) {
        showModel();
        onSettingsChanged();
    }
}

void MainWindow::fillProjectAnalyses() {
    ofProject_->clear();
    for (const auto& analysis : workbench_.project().analyses) {
        const QString title = QString::fromStdString(analysis.name);
        auto* action = ofProject_->addAction(
            icon(analysis.kind->icon), title + "…", this, [this, analysis, title] {
                newAnalysis(analysis.kind, workbench_.settings().with(analysis.settings), title);
            });
        action->setToolTip(QString::fromStdString(analysis.notes));
    }
}

void MainWindow::refreshTitle() {
    if (workbench_.hasProject())
        setWindowTitle(QString::fromStdString(workbench_.project().displayName()) + "[*] – SMAT");
    if (workbench_.hasProject() && page_ != nullptr)
        page_->setTitle(QString::fromStdString(workbench_.project().title.empty()
                                                   ? workbench_.project().displayName()
                                                   : workbench_.project().title));
    setWindowModified(workbench_.hasProject() &&
                      (workbench_.isModified() || workbench_.resultStore().unsavedCount() > 0));
}

void MainWindow::showModel() {
    view_->setScene({});
    shownModels_ = workbench_.project().models;
    loader_->load(workbench_.project(), workbench_.settings());
}

bool MainWindow::isLoadingModel() const {
    return files_->opening().isBusy() || databaseDock_->isReadingModel() ||
           (loader_ != nullptr && loader_->isBusy());
}

void MainWindow::makeLoader() {
    loader_ = new SceneLoader(workbench_.models(), this);
    loading_->follow(*loader_);
    connect(loader_, &SceneLoader::cancelled, this, [this](const QString& names) {
        statusBar()->showMessage(
            tr("%1 was not read; open the project again to see it").arg(names));
    });
    connect(loader_, &SceneLoader::loaded, this,
            [this](const std::shared_ptr<DisplayScene>& scene) {
                for (const auto& remark : scene->remarks)
                    statusBar()->showMessage(remark, 8000);
                view_->setScene(std::move(*scene));
                // Settings may have changed in the meantime.
                view_->setTargetPose(targetPoseOf(workbench_.settings()));
            });
    connect(loader_, &SceneLoader::failed, this, [this](const QStringList& sentences) {
        dialogs_.tell(this, tr("The model cannot be shown"), sentences);
    });
}

void MainWindow::onSettingsChanged() {
    if (view_ == nullptr)
        return;
    view_->setProject(workbench_.project(), workbench_.settings());
}

void MainWindow::newAnalysis(AnalysisKind kind, const Settings& settings, const QString& name) {
    if (!workbench_.hasProject())
        return;
    AnalysisGeneratorDialog dialog(workbench_.project(), settings, kind, fileChooser(), this);
    dialog.setName(name);
    dialog.setUnsavedNote(unsavedNote(workbench_));
    if (dialogs_.run(dialog))
        workbench_.start(dialog.data());
}

ResultPage* MainWindow::currentPage() const {
    return qobject_cast<ResultPage*>(tabs_->currentWidget());
}

void MainWindow::exportShown() {
    const auto* page = dynamic_cast<Exportable*>(tabs_->currentWidget());
    if (page == nullptr || page->exportFilters().isEmpty()) {
        statusBar()->showMessage(tr("This page has nothing to export yet"), 8000);
        return;
    }
    const QString file = dialogs_.saveFile(this, tr("Export"), page->exportFilters(), {});
    if (file.isEmpty())
        return;
    try {
        page->exportTo(file.toStdString());
        statusBar()->showMessage(tr("Wrote %1").arg(file), 8000);
    } catch (const irsg::InputError& error) {
        dialogs_.tell(this, tr("This cannot be written"), sentencesOf(error));
    }
}

void MainWindow::refreshActions() {
    export_->setEnabled(dynamic_cast<Exportable*>(tabs_->currentWidget()) != nullptr);
    findChild<QAction*>("closeResult")->setEnabled(tabs_->currentIndex() > 0);
    keepAnalysis_->setEnabled(workbench_.hasProject() && currentPage() != nullptr &&
                              currentPage()->resultIds().size() == 1);
    for (auto* action : ofProjectFile_)
        action->setEnabled(workbench_.hasProject());
    const DatabaseSession& database = workbench_.database();
    findChild<QAction*>("saveDatabase")
        ->setEnabled(database.isOpen() && database.isDirty() &&
                     database.access() == DatabaseSession::Access::edit);
    findChild<QAction*>("saveDatabaseAs")->setEnabled(database.isOpen());
    const bool ready = workbench_.hasProject();
    const QString missing = missingForAnalyses(workbench_);
    for (const auto& [kind, action] : analyses_) {
        action->setEnabled(missing.isEmpty());
        const QString tip = action->data().toString();
        action->setToolTip(missing.isEmpty() ? tip : tip + "\n" + missing);
        action->setStatusTip(missing);
    }
    ofProject_->menuAction()->setVisible(workbench_.hasProject() && !ofProject_->isEmpty());
    ofProject_->setEnabled(ready);
}

void MainWindow::makeStartPage() {
    start_ = new StartPage(tabs_->widget(0));
    start_->setRecentFiles(workbench_.recentFiles());
    connect(start_, &StartPage::fileChosen, this,
            [this](const QString& file) { open(file.toStdString()); });
    connect(start_, &StartPage::modelWanted, files_, &ProjectFiles::chooseModel);
    connect(start_, &StartPage::projectWanted, files_, &ProjectFiles::newProject);
    connect(start_, &StartPage::openWanted, this, &MainWindow::chooseFile);
    connect(start_, &StartPage::guideWanted, this, &MainWindow::openGuide);
    connect(&workbench_, &Workbench::projectOpened, start_, &QWidget::hide);
}

void MainWindow::openGuide() {
    if (!GuidePage::isThere()) {
        dialogs_.tell(this, tr("The guide"),
                      {tr("It is not beside this program; SMAT_DATA names the folder that has "
                          "docs/user-guide.")});
        return;
    }
    addPage(new GuidePage("first-signature.md"), icon("info"), tr("Guide"));
}

void MainWindow::closeEvent(QCloseEvent* event) {
    if (!files_->settle()) {
        event->ignore();
        return;
    }
    layout_->save();
    // The job stops by itself when the workbench goes; nothing of it needs an answer.
    workbench_.jobs().cancelAll();
    event->accept();
}

bool MainWindow::eventFilter(QObject* watched, QEvent* event) {
    // Turning the model by the mouse is one step to undo.
    if (watched == view_ && event->type() == QEvent::MouseButtonPress)
        workbench_.holdStep();
    if (watched == view_ && event->type() == QEvent::MouseButtonRelease)
        workbench_.closeStep();
    return QMainWindow::eventFilter(watched, event);
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    if (event->mimeData()->hasUrls() && event->mimeData()->urls().front().isLocalFile())
        event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
    QStringList files;
    for (const QUrl& url : event->mimeData()->urls())
        files << url.toLocalFile();
    openFiles(files);
}

} // namespace smat::gui
