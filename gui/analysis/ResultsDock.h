#pragma once

#include <filesystem>
#include <map>

#include <QDockWidget>

#include "gui/widgets/Dialogs.h"

class QAction;
class QLabel;
class QListWidget;
class QListWidgetItem;

namespace smat::gui {

class Workbench;
struct ResultEntry;

/// The results that are open with when, how long and what was asked:
/// shown, overlaid, subtracted, run again, edited and run again, renamed, saved and opened again.
/// Its commands are on buttons, in the menu of the right button and on keys.
class ResultsDock : public QDockWidget {
    Q_OBJECT

  public:
    ResultsDock(Workbench& workbench, Dialogs dialogs, QWidget* parent = nullptr);

    QList<int> selectedResults() const;
    /// What can be done with them, with their keys.
    QList<QAction*> commands() const;
    /// Opens a result file (.csv, .json, .exr; .txt and .dat for matrices) as a result again; what
    /// is wrong is told.
    bool openResult(const std::filesystem::path& file);

  signals:
    /// The user wants to see these; several belong on one plot.
    void showRequested(const QList<int>& ids);
    /// The user wants to see two images and their difference.
    void comparisonRequested(int a, int b);

  private:
    QAction* add(const QString& name, const QString& iconName, const QString& text,
                 const QString& tip, const QKeySequence& key, void (ResultsDock::*work)());
    void makeActions();
    QWidget* makeButtons();
    void addResult(int id);
    void refreshItem(int id);
    void removeItem(int id);
    void refreshActions();
    QListWidgetItem* itemOf(int id) const;
    const ResultEntry* onlySelected() const;

    void showSelected();
    void overlay();
    void subtract();
    void runAgain();
    void editAndRun();
    void rename();
    void annotate();
    void showDetails();
    void save();
    void openFile();
    void removeSelected();

    Workbench& workbench_;
    Dialogs dialogs_;
    QListWidget* list_ = nullptr;
    QLabel* empty_ = nullptr;
    std::map<QString, QAction*> actions_;
};

} // namespace smat::gui
