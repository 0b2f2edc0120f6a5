#include "tools/screenshots/ScreenshotTaker.h"

#include <algorithm>

#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QListWidget>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QRegularExpression>
#include <QTabWidget>
#include <QTimer>

#include "gui/view/SceneView.h"

namespace smat::gui {
namespace {

void wait_ms(int duration) {
    QEventLoop loop;
    QTimer::singleShot(duration, &loop, &QEventLoop::quit);
    loop.exec();
}

/// Actions that end the program, need a file of the person's own, or only do again what another
/// picture shows.
bool isLeftOut(const QAction& action) {
    static const QStringList names = {"quit",        "recentFiles", "exportShown",
                                      "closeResult", "openProject", "undo",
                                      "redo",        "saveProject", "renameModel"};
    return action.isSeparator() || !action.isEnabled() || names.contains(action.objectName());
}

} // namespace

ScreenshotTaker::ScreenshotTaker(std::filesystem::path folder, std::filesystem::path project,
                                 QStringList images, QStringList wanted)
    : folder_(std::move(folder)),
      project_(std::move(project)),
      images_(std::move(images)),
      wanted_(std::move(wanted)),
      window_(workbench_, dialogs()) {}

Dialogs ScreenshotTaker::dialogs() {
    Dialogs answers = Dialogs::ofDesktop();
    answers.openFile = [this](QWidget*, const QString&, const QStringList& filters) {
        const QString wanted = filters.join(' ');
        const auto beside = [this](const char* name) {
            return QString::fromStdString((project_.parent_path() / name).string());
        };
        if (wanted.contains("exr") && !images_.isEmpty())
            return images_[nextImage_++ % images_.size()];
        if (wanted.contains("sigdb"))
            return QString::fromStdString(
                std::filesystem::path(project_).replace_extension("sigdb").string());
        return wanted.contains("*.csv *.txt") ? beside("plume core.csv") : QString();
    };
    answers.saveFile = [](QWidget*, const QString&, const QStringList&, const QString&) {
        return QString();
    };
    answers.tell = [this](QWidget*, const QString& title, const QStringList& sentences) {
        told_ << title + ": " + sentences.join("; ");
    };
    answers.ask = [](QWidget*, const QString&, const QString&, const QStringList& choices) {
        return static_cast<int>(choices.indexOf(QRegularExpression(".*Discard.*")));
    };
    answers.run = [this](QDialog& dialog) {
        keepDialog(dialog);
        return accept_;
    };
    return answers;
}

QStringList ScreenshotTaker::takeAll() {
    std::filesystem::create_directories(folder_);
    window_.resize(1360, 840);
    window_.show();
    settle();
    keep(window_, "window-empty");
    if (!window_.open(project_))
        return told_;
    settle();
    keep(window_, "window");
    keepDatabase();

    for (QAction* action : window_.menuBar()->actions())
        if (action->menu() != nullptr)
            goThrough(*action->menu());
    keepProjectAnalyses();
    keepResults();
    if (isWanted("plot-crosshair"))
        keepCrosshair();
    if (isWanted("comparison"))
        keepComparison();
    if (isWanted("window-"))
        keepRunning();
    if (isWanted("infraredDisplay-refused"))
        keepRefusals();
    if (isWanted("dialog"))
        keepDatabaseDialogs();
    if (isWanted("message"))
        keepMessages();
    window_.close(); // what the looking around has changed is discarded
    return told_;
}

bool ScreenshotTaker::isWanted(const QString& beginning) const {
    return wanted_.isEmpty() || std::ranges::any_of(wanted_, [&beginning](const QString& name) {
               return name.startsWith(beginning);
           });
}

void ScreenshotTaker::goThrough(QMenu& menu) {
    emit menu.aboutToShow();
    const QString before = current_;
    if (menu.isEmpty())
        return;
    menu.popup(window_.mapToGlobal(QPoint(40, 40)));
    settle();
    keep(menu,
         "menu-" +
             QString(menu.title()).remove('&').remove(QChar(0x2026)).toLower().replace(' ', '-'));
    menu.hide();
    const QList<QAction*> actions = menu.actions();
    for (QAction* action : actions) {
        if (isLeftOut(*action))
            continue;
        if (action->menu() != nullptr)
            goThrough(*action->menu());
        else
            trigger(*action);
    }
    current_ = before;
}

void ScreenshotTaker::trigger(QAction& action) {
    // The docks' own actions only hide them.
    if (action.objectName().isEmpty())
        return;
    current_ = action.objectName();
    if (!isWanted(current_))
        return;
    accept_ = current_.startsWith("new-");
    if (action.isCheckable())
        return showAs(action);

    auto* tabs = window_.findChild<QTabWidget*>("tabs");
    const int before = tabs->count(), step = workbench_.undoStack().index();
    const QWidget* shown = tabs->currentWidget();
    action.trigger();
    settle();
    if (current_ == "collapseDocks") {
        keep(window_, current_);
        action.trigger();
        settle();
    }
    // What came to the front, or is being typed into, is not what the next pictures are about.
    raiseResults();
    window_.setFocus();
    settle();
    if (tabs->count() != before || tabs->currentWidget() != shown) {
        fill(tabs->currentWidget());
        keepPage(current_ + "-page");
        // Its tab is gone before the next one opens, so that those of a picture can be read.
        if (tabs->count() > before)
            emit tabs->tabCloseRequested(tabs->currentIndex());
    }
    for (QWidget* other : QApplication::topLevelWidgets())
        if (other != &window_ && other->isWindow() && other->isVisible() &&
            qobject_cast<QMenu*>(other) == nullptr) {
            keep(*other, current_ + "-window");
            other->close();
        }
    // What the sensor was moved to is not what the next pictures are of.
    while (workbench_.undoStack().index() > step)
        workbench_.undoStack().undo();
}

void ScreenshotTaker::raiseResults() {
    if (auto* results = window_.findChild<QDockWidget*>("resultsDock")) {
        results->raise();
        settle();
        window_.resizeDocks({results}, {results->minimumSizeHint().width()}, Qt::Horizontal);
    }
}

void ScreenshotTaker::keepPage(const QString& name) {
    // As one would look at what has fields, plots and tables beside each other.
    static const QStringList wide = {"compareImages",      "comparison", "monteCarlo", "radiative",
                                     "temperatureProfile", "newAir",     "projectAir", "frontier",
                                     "new-table",          "detection",  "sensorChain"};
    const bool isWide = std::ranges::any_of(
        wide, [&name](const QString& beginning) { return name.startsWith(beginning); });
    auto* collapse = window_.findChild<QAction*>("collapseDocks");
    if (isWide) {
        collapse->trigger();
        settle();
    }
    keep(window_, name);
    if (isWide) {
        collapse->trigger();
        settle();
        raiseResults();
    }
}

QTabWidget* ScreenshotTaker::raiseDatabase() {
    auto* dock = window_.findChild<QDockWidget*>("databaseDock");
    if (dock == nullptr)
        return nullptr;
    dock->show();
    dock->raise();
    settle();
    return dock->findChild<QTabWidget*>("databaseTabs");
}

void ScreenshotTaker::keepTab(QTabWidget& pages, int number) {
    pages.setCurrentIndex(number);
    settle();
    const QString name =
        "database-" + pages.tabText(number).remove('&').section(' ', 0, 0).toLower();
    keep(window_, name);
    for (auto* tabs : pages.currentWidget()->findChildren<QTabWidget*>()) {
        for (int k = 1; k < tabs->count(); ++k) {
            if (!tabs->isTabVisible(k))
                continue;
            tabs->setCurrentIndex(k);
            settle();
            keep(window_, name + "-" + QString::number(k + 1));
        }
        tabs->setCurrentIndex(0);
    }
}

void ScreenshotTaker::keepDatabase() {
    auto* pages = raiseDatabase();
    if (pages == nullptr)
        return;
    for (int i = 0; i < pages->count(); ++i)
        keepTab(*pages, i);
    auto* dock = window_.findChild<QDockWidget*>("databaseDock");
    // As a window of its own it has its entries beside their list.
    pages->setCurrentIndex(0);
    dock->setFloating(true);
    dock->resize(1000, 640);
    settle();
    keep(*dock, "database-floating");
    dock->setFloating(false);
    dock->raise();
    raiseResults();
}

void ScreenshotTaker::showAs(QAction& action) {
    const bool was = action.isChecked();
    // What the infrared display alone shows is seen in it.
    auto* infrared = window_.findChild<QAction*>("infraredDisplay");
    const bool ofInfrared = current_ == "apparentTemperature" || current_.startsWith("colorMap");
    if (ofInfrared && infrared != nullptr && !infrared->isChecked())
        infrared->trigger();
    action.trigger();
    settle();
    keep(window_, current_ + (action.isChecked() ? "-on" : "-off"));
    if (action.isChecked() != was)
        action.trigger();
    if (ofInfrared && infrared != nullptr && infrared->isChecked())
        infrared->trigger();
    settle();
}

void ScreenshotTaker::keepDialog(QDialog& dialog) {
    dialog.show();
    wait_ms(150);
    keep(dialog, current_);
    for (auto* pages : dialog.findChildren<QListWidget*>("pageList"))
        for (int i = 1; i < pages->count(); ++i) {
            pages->setCurrentRow(i);
            wait_ms(50);
            keep(dialog, QString("%1-%2").arg(current_).arg(i + 1));
        }
    for (auto* tabs : dialog.findChildren<QTabWidget*>())
        for (int i = 1; i < tabs->count(); ++i) {
            tabs->setCurrentIndex(i);
            wait_ms(50);
            keep(dialog, QString("%1-%2").arg(current_).arg(i + 1));
        }
}

void ScreenshotTaker::keep(QWidget& widget, const QString& name) {
    QString unique = name;
    for (int i = 2; !taken_.insert(unique).second; ++i)
        unique = QString("%1-%2").arg(name).arg(i);
    const auto file = folder_ / (unique.toStdString() + ".png");
    constexpr int smallest = 0; // of the file, not of what is seen
    const QImage picture = widget.grab().toImage().convertToFormat(QImage::Format_RGB888);
    if (!picture.save(QString::fromStdString(file.string()), "PNG", smallest))
        told_ << QString("%1 cannot be written").arg(QString::fromStdString(file.string()));
}

void ScreenshotTaker::settle() {
    waitWhile([this] {
        return workbench_.isRunning() || window_.isLoadingModel() ||
               (window_.sceneView() != nullptr && window_.sceneView()->isVisible() &&
                window_.sceneView()->display() == ViewDisplay::infrared &&
                !window_.sceneView()->isUpToDate());
    });
    wait_ms(200);
}

void ScreenshotTaker::waitWhile(const std::function<bool()>& busy) {
    constexpr int longest_ms = 600000, step_ms = 50;
    QElapsedTimer clock;
    clock.start();
    do
        wait_ms(step_ms);
    while (busy() && clock.elapsed() < longest_ms);
    if (busy())
        told_ << QString("%1: still busy after %2 s").arg(current_).arg(longest_ms / 1000);
}

} // namespace smat::gui
