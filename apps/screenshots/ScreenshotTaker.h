#pragma once

#include <filesystem>
#include <functional>
#include <set>

#include <QStringList>

#include "gui/MainWindow.h"
#include "gui/widgets/Dialogs.h"

namespace smat::gui {

/// Goes through a workbench as a person would, menu by menu, and keeps a picture of each window and
/// dialog that appears: NAME.png in a folder, named after the action that showed it.
class ScreenshotTaker {
  public:
    /// `images`: two files that a comparison opens.
    ScreenshotTaker(std::filesystem::path folder, std::filesystem::path project,
                    QStringList images);

    /// Takes all pictures. Returns what went wrong on the way, one sentence each.
    QStringList takeAll();
    /// The main window alone, where the display has no OpenGL. Returns the same.
    QStringList takeWithoutGl();

  private:
    Dialogs dialogs();
    void keep(QWidget& widget, const QString& name);
    /// A dialog, and once more for each of its tabs.
    void keepDialog(QDialog& dialog);
    /// Triggers every action of the menus that shows something.
    void goThrough(QMenu& menu);
    void trigger(QAction& action);
    void showAs(QAction& action);
    /// Gives a page that was just opened something to show.
    void fill(QWidget* page);
    /// Every tab of the editor of signature databases.
    void keepDatabase();
    // ScreenshotPages.cpp
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
    QStringList images_, told_;
    qsizetype nextImage_ = 0;
    QString current_; ///< name of the action that is being triggered
    bool accept_ = false;
    std::set<QString> taken_;
    Workbench workbench_;
    MainWindow window_;
};

} // namespace smat::gui
