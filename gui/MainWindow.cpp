#include "gui/MainWindow.h"

#include <QApplication>
#include <QCloseEvent>
#include <QDragEnterEvent>
#include <QLabel>
#include <QMimeData>
#include <QScrollArea>
#include <QSplitter>
#include <QStatusBar>
#include <QToolButton>
#include <QUndoView>

#include "gui/FileOpening.h"
#include "gui/MainDialogs.h"
#include "gui/MainMenus.h"
#include "gui/ManipulatorsDock.h"
#include "gui/MessagesDock.h"
#include "gui/WindowLayout.h"
#include "gui/WindowMessages.h"
#include "gui/analysis/JobBar.h"
#include "gui/analysis/ResultPages.h"
#include "gui/analysis/ResultsDock.h"
#include "gui/atmosphere/AtmospherePage.h"
#include "gui/atmosphere/AtmospherePages.h"
#include "gui/atmosphere/AtmosphereRecovery.h"
#include "gui/database/DatabaseDock.h"
#include "gui/database/DatabasePreview.h"
#include "gui/image/ImagePages.h"
#include "gui/paint/FacePainter.h"
#include "gui/project/ProjectFiles.h"
#include "gui/project/SceneModelActs.h"
#include "gui/project/SceneTreeDock.h"
#include "gui/scenario/ScenarioPages.h"
#include "gui/settings/SettingsDialog.h"
#include "gui/start/DataFolder.h"
#include "gui/start/StartPage.h"
#include "gui/view/LoadingBar.h"
#include "gui/view/ModelPage.h"
#include "gui/view/ProjectView.h"
#include "gui/widgets/Theme.h"
#include "gui/widgets/Widgets.h"
#include "irsg/core/WriteGuard.h"

namespace smat::gui {
namespace {

constexpr int leastPage_px = 320;

} // namespace

MainWindow::MainWindow(Workbench& workbench, Dialogs dialogs, QWidget* parent)
    : QMainWindow(parent), workbench_(workbench), dialogs_(std::move(dialogs)) {
    setObjectName("mainWindow");
    setWindowTitle("SMAT");
    setWindowIcon(icon("smat"));
    setAcceptDrops(true);
    irsg::setWriteGuard(requireOwnPlace);
    messages_ = new WindowMessages(workbench_, this);
    messages_->follow(dialogs_);
    QStringList problems;
    preferences_ = Preferences::load(&problems);
    DisplayUnitsWatch::instance().set(preferences_.units);
    files_ = new ProjectFiles(workbench_, dialogs_, preferences_, this);
    loading_ = new LoadingBar(this);
    loading_->follow(files_->opening());
    models_ = new SceneModelActs(workbench_, dialogs_, this);
    loading_->follow(*models_);
    statusBar()->addPermanentWidget(loading_);
    makeCentre();
    ask_ = new MainDialogs(*this, workbench_, dialogs_, preferences_, *files_, *tabs_);
    makeDocks();
    auto* scenarios = new ScenarioPages(workbench_, dialogs_, *tabs_);
    opening_ =
        new FileOpening(this, workbench_, dialogs_, *files_, *images_, *results_, *scenarios);
    auto* air = new AtmospherePages(workbench_, dialogs_, *tabs_);
    makeMessages(*air);
    openWith({"xml"}, [air](const std::filesystem::path& file) { return air->open(file); });
    layout_ = new WindowLayout(*this);
    menus_ = new MainMenus({*this, workbench_, dialogs_, *ask_, *files_, *opening_, *tabs_,
                            *images_, view_, *results_, *databaseDock_, *air, *layout_, *models_,
                            *tree_, *scenarios});
    connect(tabs_, &PageTabs::shownChanged, menus_, &MainMenus::refresh);
    say(problems.isEmpty() ? tr("Open a project (Ctrl+O), or drop one here")
                           : problems.join("   "));
    connectWorkbench();
    connectResults();
    makeStartPage();
    layout_->restore();
    menus_->refresh();
    keepTabOrder();
    for (const QString& problem : problems)
        messages_->remark(problem);
}

MainWindow::~MainWindow() {
    delete menus_; // parts that go change nothing that can be done
}

void MainWindow::say(const QString& sentence, int time_ms) {
    statusBar()->showMessage(sentence, time_ms);
}

void MainWindow::makeCentre() {
    tabs_ = new PageTabs(this);
    images_ = new ImagePages(workbench_, dialogs_, *tabs_);
    connect(tabs_, &PageTabs::said, this, [this](const QString& sentence) { say(sentence, 8000); });
    if (const QString problem = SceneView::problem(); problem.isEmpty()) {
        view_ = new ProjectView(workbench_, dialogs_, *loading_, tabs_);
        connect(view_, &ProjectView::said, this, &MainWindow::say);
        connect(view_, &ProjectView::remarked, messages_, &WindowMessages::remark);
        tabs_->setFirst(view_->page(), tr("Model"));
    } else {
        auto* notice = new QLabel(problem, tabs_);
        notice->setObjectName("noGlNotice");
        notice->setAlignment(Qt::AlignCenter);
        notice->setForegroundRole(QPalette::PlaceholderText);
        tabs_->setFirst(notice, tr("Model"));
    }
    // A page that needs more room than there is scrolls; the window keeps its size.
    auto* rows = new QSplitter(Qt::Horizontal, this);
    rows->setObjectName("rowsOfPages");
    rows->setChildrenCollapsible(false);
    const auto scrolling = [rows](const char* name, QWidget* row) {
        auto* area = new QScrollArea(rows);
        area->setObjectName(name);
        area->setFrameShape(QFrame::NoFrame);
        area->setWidgetResizable(true);
        area->setFocusPolicy(Qt::NoFocus);
        area->setMinimumSize(leastPage_px, 300);
        area->setWidget(row);
        rows->addWidget(area);
        return area;
    };
    auto* first = scrolling("centre", tabs_);
    auto* other = scrolling("centreBeside", tabs_->beside());
    other->hide();
    const auto follow = [this, rows, first, other] {
        const bool isThere = tabs_->beside()->count() > 0;
        if (isThere == other->isVisibleTo(rows))
            return;
        // Two share the room of a small screen.
        for (QScrollArea* area : {first, other})
            area->setMinimumWidth(isThere ? leastPage_px / 2 : leastPage_px);
        other->setVisible(isThere);
        rows->setSizes({rows->width() / 2, rows->width() / 2});
    };
    // When a page has come or gone.
    connect(tabs_, &PageTabs::shownChanged, other, follow, Qt::QueuedConnection);
    setCentralWidget(rows);
}

void MainWindow::makeDocks() {
    keepKeysFromEmptyTabBars(*this);
    tree_ = new SceneTreeDock(workbench_, this);
    addDockWidget(Qt::LeftDockWidgetArea, tree_);
    auto* manipulators = new ManipulatorsDock(workbench_, this);
    addDockWidget(Qt::LeftDockWidgetArea, manipulators);
    results_ = new ResultsDock(workbench_, dialogs_, this);
    addDockWidget(Qt::RightDockWidgetArea, results_);
    databaseDock_ = new DatabaseDock(workbench_, dialogs_, this);
    addDockWidget(Qt::RightDockWidgetArea, databaseDock_);
    tabifyDockWidget(results_, databaseDock_);
    makeHistory();
    results_->raise();
    for (QDockWidget* dock :
         {static_cast<QDockWidget*>(results_), static_cast<QDockWidget*>(databaseDock_)})
        keepKeysFromHiddenTab(*dock);
    files_->addSettler([this] { return databaseDock_->files().mayCloseAll(); });
    resizeDocks({tree_, manipulators}, {310, 410}, Qt::Vertical);

    joinTreeAndEditor();
    if (view_ != nullptr) {
        joinTreeAndView();
        new DatabasePreview(workbench_, *databaseDock_, *sceneView(), this);
        makePainter();
    }
    connectTree();
}

void MainWindow::makePainter() {
    paint_ = new PaintDock(this);
    addDockWidget(Qt::LeftDockWidgetArea, paint_);
    tabifyDockWidget(tree_, paint_);
    for (QDockWidget* dock : {static_cast<QDockWidget*>(tree_), static_cast<QDockWidget*>(paint_)})
        keepKeysFromHiddenTab(*dock);
    paint_->hide();
    QAction* toggle = paint_->toggleViewAction();
    toggle->setObjectName("paintCodes");
    toggle->setIcon(icon("paint"));
    toggle->setShortcut(Qt::Key_F4);
    connect(toggle, &QAction::triggered, paint_, [this](bool on) {
        if (!on)
            return;
        tabs_->setCurrentIndex(0);
        paint_->raise();
        // Down to the legend, where the screen is high enough.
        if (auto* below = findChild<QDockWidget*>("manipulatorsDock"))
            resizeDocks({paint_, below}, {560, 180}, Qt::Vertical);
    });
    auto* painter = new FacePainter(
        workbench_, dialogs_, *sceneView(), *paint_,
        [this](const EntryKey& key) {
            databaseDock_->select(key);
            databaseDock_->show();
            databaseDock_->raise();
        },
        this);
    connect(view_, &ProjectView::shown, painter, &FacePainter::followScene);
}

void MainWindow::connectTree() {
    connect(tree_, &SceneTreeDock::modelFileWanted, this,
            [this](int model) { files_->chooseModelFile(static_cast<std::size_t>(model)); });
    connect(tree_, &SceneTreeDock::databaseFileWanted, this, [this](int model) {
        workbench_.chooseModel(static_cast<std::size_t>(model));
        databaseDock_->files().open();
    });
    connect(tree_, &SceneTreeDock::addModelWanted, models_, &SceneModelActs::chooseAndAdd);
    connect(tree_, &SceneTreeDock::removeModelWanted, models_,
            [this](int model) { models_->remove(static_cast<std::size_t>(model)); });
    connect(tree_, &SceneTreeDock::targetWanted, models_,
            [this](int model) { models_->makeTarget(static_cast<std::size_t>(model)); });
    connect(models_, &SceneModelActs::added, this, [this](const QString& name) {
        say(tr("Added %1; place it by its handles or in Camera and model").arg(name), 10000);
    });
    connect(tree_, &SceneTreeDock::sensorActivated, this,
            [this] { ask_->showSettings(SettingsDialog::tr("Sensor")); });
    connect(tree_, &SceneTreeDock::sunActivated, this,
            [this] { ask_->showSettings(SettingsDialog::tr("Sun and fluxes")); });
    connect(tree_, &SceneTreeDock::atmosphereActivated, this,
            [this] { ask_->showSettings(SettingsDialog::tr("Atmosphere")); });
    connect(databaseDock_, &DatabaseDock::firstSignatureWanted, ask_,
            &MainDialogs::makeFirstSignature);
    connect(tree_, &SceneTreeDock::propertiesWanted, ask_, &MainDialogs::showProjectProperties);
    connect(tree_, &SceneTreeDock::analysisActivated, ask_, &MainDialogs::startAgain);
    connect(tree_, &SceneTreeDock::removeAnalysisWanted, ask_, &MainDialogs::removeAnalysis);
}

void MainWindow::joinTreeAndEditor() {
    const auto edit = [this](IndexKind kind, int index, int model) {
        workbench_.chooseModel(static_cast<std::size_t>(model));
        databaseDock_->select(
            {kind == IndexKind::temperature ? EntryKind::temperature : EntryKind::material, index});
    };
    connect(tree_, &SceneTreeDock::indexSelected, databaseDock_, edit);
    connect(tree_, &SceneTreeDock::indexActivated, databaseDock_,
            [this, edit](IndexKind kind, int index, int model) {
                edit(kind, index, model);
                databaseDock_->show();
                databaseDock_->raise();
            });
}

void MainWindow::joinTreeAndView() {
    SceneView* view = sceneView();
    connect(tree_, &SceneTreeDock::indexSelected, view,
            [view](IndexKind kind, int index, int model) {
                FaceSelection faces{.temperature = {}, .material = {}, .model = model};
                (kind == IndexKind::temperature ? faces.temperature : faces.material) = index;
                view->setHighlighted(faces);
            });
    connect(tree_, &SceneTreeDock::nothingSelected, view, [view] { view->setHighlighted({}); });
    connect(view, &SceneView::facePicked, tree_, [this](int temperature, int, int model) {
        tree_->showIndex(IndexKind::temperature, temperature, model);
    });
}

void MainWindow::connectWorkbench() {
    connect(&files_->opening(), &ModelWait::cancelled, this,
            [this](const QString& name) { say(tr("%1 was not opened").arg(name)); });
    connect(files_, &ProjectFiles::said, this,
            [this](const QString& sentence) { say(sentence, 10000); });
    connect(files_, &ProjectFiles::remarked, messages_, &WindowMessages::remark);
    connect(&workbench_, &Workbench::projectOpened, this, &MainWindow::onProjectOpened);
    connect(&workbench_, &Workbench::projectChanged, this, &MainWindow::onProjectChanged);
    connect(&workbench_, &Workbench::modifiedChanged, this, &MainWindow::refreshTitle);
    if (view_ != nullptr)
        connect(&workbench_, &Workbench::settingsChanged, view_, &ProjectView::followSettings);
    connect(&workbench_, &Workbench::modelChosen, menus_, &MainMenus::refresh);
    connect(&workbench_.database(), &DatabaseSession::stateChanged, menus_, &MainMenus::refresh);
    connect(&workbench_.database(), &DatabaseSession::opened, menus_, &MainMenus::refresh);
    connect(&workbench_, &Workbench::jobFailed, this,
            [this](const QStringList& sentences, bool ourFault) {
                messages_->tellRefusal(
                    dialogs_, this,
                    ourFault ? tr("Internal error") : tr("The analysis cannot be run"), sentences);
            });
}

void MainWindow::connectResults() {
    connect(&workbench_.resultStore(), &ResultStore::problems, this,
            [this](const QStringList& sentences) {
                dialogs_.tell(this, tr("Results of the project"), sentences);
            });
    statusBar()->addPermanentWidget(new JobBar(workbench_, this));
    resultPages_ = new ResultPages(workbench_, dialogs_, tabs_);
    connect(results_, &ResultsDock::showRequested, resultPages_, &ResultPages::show);
    connect(results_, &ResultsDock::comparisonRequested, images_, &ImagePages::compareResults);
    connect(resultPages_, &ResultPages::said, this,
            [this](const QString& sentence) { say(sentence); });
    connect(resultPages_, &ResultPages::passed, this, [this](const QString& sentence) {
        if (statusBar()->currentMessage() == sentence)
            statusBar()->clearMessage();
    });
}

void MainWindow::makeMessages(AtmospherePages& air) {
    auto* dock = new MessagesDock(messages_->log(), this);
    addDockWidget(Qt::BottomDockWidgetArea, dock);
    setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    dock->hide();
    statusBar()->addPermanentWidget(dock->counter());
    messages_->setPlaces(
        {.result =
             [this](int id) {
                 if (workbench_.result(id) == nullptr)
                     say(tr("That result is no longer open"), 8000);
                 resultPages_->show({id});
             },
         .model =
             [this](std::size_t model) {
                 workbench_.chooseModel(model);
                 tabs_->setCurrentIndex(0);
             },
         .database =
             [this](std::size_t model) {
                 workbench_.chooseModel(model);
                 databaseDock_->show();
                 databaseDock_->raise();
             },
         .atmosphere = [&air] { air.showProjectAtmosphere(); },
         .settings = [this] { ask_->showSettings(SettingsDialog::tr("Band and mode")); }});
    const auto sayNewest = [this] {
        const Message& newest = messages_->log().messages().back();
        say(newest.source.isEmpty() ? newest.sentence
                                    : tr("%1: %2").arg(newest.source, newest.sentence),
            20000);
    };
    connect(&messages_->log(), &MessageLog::added, this, sayNewest);
    connect(&messages_->log(), &MessageLog::repeated, this, sayNewest);
}

void MainWindow::makeHistory() {
    auto* dock = new QDockWidget(tr("History"), this);
    dock->setObjectName("historyDock");
    auto* list = new QUndoView(&workbench_.undoStack(), dock);
    list->setObjectName("undoHistory");
    list->setEmptyLabel(tr("As it was opened"));
    list->setToolTip(tr("Steps that can be undone: choose one to go to where it was done"));
    dock->setWidget(list);
    addDockWidget(Qt::RightDockWidgetArea, dock);
    tabifyDockWidget(databaseDock_, dock);
    keepKeysFromHiddenTab(*dock);
    dock->hide();
    connect(dock->toggleViewAction(), &QAction::triggered, dock, [dock](bool on) {
        if (on)
            dock->raise();
    });
}

void MainWindow::makeStartPage() {
    start_ = new StartPage(tabs_->widget(0));
    start_->setRecentFiles(workbench_.recentFiles());
    connect(start_, &StartPage::fileChosen, this,
            [this](const QString& file) { opening_->open({file}); });
    connect(start_, &StartPage::modelWanted, files_, &ProjectFiles::chooseModel);
    connect(start_, &StartPage::projectWanted, files_, &ProjectFiles::newProject);
    connect(start_, &StartPage::openWanted, opening_, &FileOpening::choose);
    connect(start_, &StartPage::guideWanted, ask_, &MainDialogs::showGuide);
    connect(&workbench_, &Workbench::projectOpened, start_, &QWidget::hide);
}

void MainWindow::keepTabOrder() {
    for (auto* dock : findChildren<QDockWidget*>(QString(), Qt::FindDirectChildrenOnly))
        tabAsOneReads(*dock);
    const auto readPage = [this] {
        if (tabs_->currentWidget() != nullptr)
            tabAsOneReads(*tabs_->currentWidget());
    };
    readPage();
    connect(tabs_, &QTabWidget::currentChanged, this, readPage);
}

void MainWindow::onProjectOpened() {
    refreshTitle();
    say(QString::fromStdString(workbench_.project().file.string()), 8000);
    menus_->followProject();
    if (view_ != nullptr)
        view_->showModels();
    tabs_->setCurrentIndex(0);
    menus_->refresh();
}

void MainWindow::onProjectChanged() {
    refreshTitle();
    menus_->followProject();
    menus_->refresh();
    if (view_ != nullptr)
        view_->followModels();
}

void MainWindow::refreshTitle() {
    if (workbench_.hasProject()) {
        setWindowTitle(QString::fromStdString(workbench_.project().displayName()) + "[*] – SMAT");
        if (view_ != nullptr)
            view_->followTitle();
    }
    setWindowModified(workbench_.hasProject() &&
                      (workbench_.isModified() || workbench_.resultStore().unsavedCount() > 0));
}

bool MainWindow::open(const std::filesystem::path& file) {
    return files_->open(file);
}

void MainWindow::openFiles(const QStringList& files) {
    opening_->open(files);
}

bool MainWindow::begin(const std::filesystem::path& file) {
    return opening_->begin(file);
}

void MainWindow::openWith(const QStringList& suffixes,
                          std::function<bool(const std::filesystem::path&)> opener) {
    opening_->openWith(suffixes, std::move(opener));
}

void MainWindow::tellInternalError(const QString& what) {
    files_->recovery().writeNow();
    for (AtmospherePage* page : findChildren<AtmospherePage*>())
        page->recovery().writeNow();
    dialogs_.tell(this, tr("Internal error"),
                  {what, tr("Your unsaved changes were kept in a recovery copy.")});
}

SceneView* MainWindow::sceneView() const {
    return view_ != nullptr ? view_->view() : nullptr;
}

bool MainWindow::isLoadingModel() const {
    return files_->opening().isBusy() || models_->isBusy() || databaseDock_->isReadingModel() ||
           (view_ != nullptr && view_->isLoading());
}

void MainWindow::addPage(QWidget* page, const QIcon& icon, const QString& title) {
    tabs_->addPage(page, icon, title);
}

ComparisonWindow* MainWindow::compareImages(const QStringList& files) {
    return images_->compare(files);
}

ComparisonWindow* MainWindow::compareResults(int a, int b) {
    return images_->compareResults(a, b);
}

bool MainWindow::mayEndRuns() {
    const AnalysisJob* job = workbench_.job();
    if (job == nullptr)
        return true;
    const QString running = job->title();
    const std::size_t waiting = workbench_.jobs().waiting().size();
    const QString sentence =
        waiting == 0
            ? tr("%1 is still running. Quitting loses what it has computed so far.").arg(running)
            : tr("%1 is still running, %2 more are waiting. Quitting loses them and what is "
                 "computed so far.")
                  .arg(running)
                  .arg(waiting);
    return dialogs_.ask(this, tr("Quit during a run"), sentence, {tr("&Quit and lose it")}) == 0;
}

void MainWindow::closeEvent(QCloseEvent* event) {
    if (!mayEndRuns() || !tabs_->mayCloseAll() || !files_->settle()) {
        event->ignore();
        return;
    }
    layout_->save();
    // The job stops by itself when the workbench goes; nothing of it needs an answer.
    workbench_.jobs().cancelAll();
    event->accept();
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

#include "moc_MainWindow.cpp"
