#include "apps/screenshots/Photographer.h"

#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QRegularExpression>
#include <QTabWidget>
#include <QTimer>

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
    static const QStringList names = {"quit",        "recentFiles", "exportShown", "closeResult",
                                      "openProject", "undo",        "redo",        "saveProject"};
    return action.isSeparator() || !action.isEnabled() || names.contains(action.objectName());
}

} // namespace

Photographer::Photographer(std::filesystem::path folder, std::filesystem::path project,
                           QStringList images)
    : folder_(std::move(folder)),
      project_(std::move(project)),
      images_(std::move(images)),
      window_(workbench_, dialogs()) {}

Dialogs Photographer::dialogs() {
    Dialogs answers = Dialogs::ofDesktop();
    answers.openFile = [this](QWidget*, const QString&, const QStringList& filters) {
        const bool wantsImage = filters.join(' ').contains("exr");
        return wantsImage && !images_.isEmpty() ? images_[nextImage_++ % images_.size()]
                                                : QString();
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

QStringList Photographer::photograph() {
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
    window_.close(); // what the looking around has changed is discarded
    return told_;
}

void Photographer::goThrough(QMenu& menu) {
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

void Photographer::trigger(QAction& action) {
    // The docks' own actions only hide them.
    if (action.objectName().isEmpty())
        return;
    current_ = action.objectName();
    accept_ = current_.startsWith("new-");
    if (action.isCheckable())
        return showAs(action);

    auto* tabs = window_.findChild<QTabWidget*>("tabs");
    const int before = tabs->count();
    const QWidget* shown = tabs->currentWidget();
    action.trigger();
    settle();
    fill(tabs->currentWidget());
    if (tabs->count() != before || tabs->currentWidget() != shown)
        keep(window_, current_ + "-page");
    for (QWidget* other : QApplication::topLevelWidgets())
        if (other != &window_ && other->isWindow() && other->isVisible() &&
            qobject_cast<QMenu*>(other) == nullptr) {
            keep(*other, current_ + "-window");
            other->close();
        }
}

void Photographer::fill(QWidget* page) {
    // A comparison gets its images; a tool is told to do its work.
    if (current_ == "compareImages" && images_.size() == 2) {
        window_.compareImages(images_);
        settle();
    }
    for (const char* name : {"compute"})
        if (auto* button = page->findChild<QPushButton*>(name);
            button != nullptr && button->isEnabled()) {
            button->click();
            constexpr int longest_ms = 30000, step_ms = 200;
            wait_ms(step_ms);
            for (int waited_ms = 0; !button->isEnabled() && waited_ms < longest_ms;
                 waited_ms += step_ms)
                wait_ms(step_ms);
            settle();
        }
}

void Photographer::keepDatabase() {
    auto* dock = window_.findChild<QDockWidget*>("databaseDock");
    if (dock == nullptr)
        return;
    dock->show();
    dock->raise();
    settle();
    for (auto* tabs : dock->findChildren<QTabWidget*>())
        for (int i = 0; i < tabs->count(); ++i) {
            if (!tabs->isVisible() || !tabs->isTabVisible(i))
                continue;
            tabs->setCurrentIndex(i);
            settle();
            const QString title = QString(tabs->tabText(i)).remove('&').section(' ', 0, 0);
            keep(window_, "database-" + title.toLower());
        }
    if (auto* results = window_.findChild<QDockWidget*>("resultsDock"))
        results->raise();
}

void Photographer::showAs(QAction& action) {
    const bool was = action.isChecked();
    action.trigger();
    settle();
    keep(window_, current_ + (action.isChecked() ? "-on" : "-off"));
    if (action.isChecked() != was)
        action.trigger();
    settle();
}

void Photographer::keepDialog(QDialog& dialog) {
    dialog.show();
    wait_ms(150);
    keep(dialog, current_);
    for (auto* tabs : dialog.findChildren<QTabWidget*>())
        for (int i = 1; i < tabs->count(); ++i) {
            tabs->setCurrentIndex(i);
            wait_ms(50);
            keep(dialog, QString("%1-%2").arg(current_).arg(i + 1));
        }
}

void Photographer::keep(QWidget& widget, const QString& name) {
    QString unique = name;
    for (int i = 2; !taken_.insert(unique).second; ++i)
        unique = QString("%1-%2").arg(name).arg(i);
    const auto file = folder_ / (unique.toStdString() + ".png");
    if (!widget.grab().save(QString::fromStdString(file.string())))
        told_ << QString("%1 cannot be written").arg(QString::fromStdString(file.string()));
}

void Photographer::settle() {
    constexpr int longest_ms = 60000;
    QElapsedTimer clock;
    clock.start();
    do
        wait_ms(200);
    while (workbench_.isRunning() && clock.elapsed() < longest_ms);
    wait_ms(300);
}

} // namespace smat::gui
