#pragma once

#include <filesystem>
#include <functional>
#include <set>

#include <QStringList>

#include "gui/MainWindow.h"
#include "gui/widgets/Dialogs.h"

class QTabWidget;

namespace smat::gui {

/// Goes through a workbench as a person would, menu by menu, and keeps a picture of each window and
/// dialog that appears: NAME.png in a folder, named after the action that showed it.
class ScreenshotTaker {
  public:
    /// `images`: two files that a comparison opens. `wanted`: names of the pictures that are
    /// wanted, which leaves out what leads to others alone; none is all.
    ScreenshotTaker(std::filesystem::path folder, std::filesystem::path project, QStringList images,
                    QStringList wanted);

    /// Takes all pictures. Returns what went wrong on the way, one sentence each.
    QStringList takeAll();
    /// Those of the guide's first chapter: the window, the infrared display, the database, a polar
    /// plot. Returns the same.
    QStringList takeFirstSteps();
    /// The editor's tab of spectra, of a project whose database has some. Returns the same.
    QStringList takeSpectra();
    /// The main window alone, where the display has no OpenGL. Returns the same.
    QStringList takeWithoutGl();

  private:
    Dialogs dialogs();
    void keep(QWidget& widget, const QString& name);
    /// Whether a picture is wanted whose name begins so.
    bool isWanted(const QString& beginning) const;
    /// The window with a page in front, which has all of the window where it is a wide one.
    void keepPage(const QString& name);
    /// The dock of results in front, no wider than it needs to be.
    void raiseResults();
    /// A dialog, and once more for each of its tabs.
    void keepDialog(QDialog& dialog);
    /// Triggers every action of the menus that shows something.
    void goThrough(QMenu& menu);
    void trigger(QAction& action);
    void showAs(QAction& action);
    /// Gives a page that was just opened something to show.
    void fill(QWidget* page);
    /// The editor of signature databases in front, its tabs.
    QTabWidget* raiseDatabase();
    /// Every tab of it.
    void keepDatabase();
    void keepTab(QTabWidget& pages, int number);
    // ScreenshotPages.cpp
    /// All but the view's.
    void closeTabs();
    void keepDatabaseDialogs();
    void keepProjectAnalyses();
    /// Plots and images in all their ways, and what is known of a result.
    void keepResults();
    void keepFloating();
    void keepComparison();
    void keepMessages();
    // ScreenshotStates.cpp
    void keepCrosshair();
    /// A job under way, and what is left of it when it is cancelled.
    void keepRunning();
    /// What cannot be shown, and why.
    void keepRefusals();
    /// Longer than ten minutes is told of as a fault.
    void waitWhile(const std::function<bool()>& busy);
    /// Lets a job end and the window be painted.
    void settle();

    std::filesystem::path folder_, project_;
    QStringList images_, wanted_, told_;
    qsizetype nextImage_ = 0;
    QString current_; ///< name of the action that is being triggered
    bool accept_ = false;
    std::set<QString> taken_;
    Workbench workbench_;
    MainWindow window_;
};

} // namespace smat::gui
