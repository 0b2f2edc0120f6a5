#pragma once

#include <QWidget>

class QLabel;
class QMenu;
class QProgressBar;
class QTimer;
class QToolButton;

namespace smat {
struct Progress;
}

namespace smat::gui {

class Workbench;

/// The job that runs, in the status bar: how far it is and what the renderer is at, for how long it
/// has run and about how long it will, and a cancel that is answered at once; beside it how many
/// wait in line, whose menu takes them out of it. Hidden while nothing runs.
class JobBar : public QWidget {
    Q_OBJECT

  public:
    explicit JobBar(Workbench& workbench, QWidget* parent = nullptr);

  private:
    void onStarted(const QString& title);
    void onProgressed(const smat::Progress& now);
    void refresh();
    void refreshLine();
    void fillLine();

    Workbench& workbench_;
    QLabel* title_ = nullptr;
    QLabel* what_ = nullptr;
    QLabel* stage_ = nullptr; ///< of the renderer in a case
    QLabel* times_ = nullptr;
    QProgressBar* bar_ = nullptr;
    QToolButton* cancel_ = nullptr;
    QToolButton* line_ = nullptr;
    QMenu* waiting_ = nullptr;
    QTimer* timer_ = nullptr;
    QString case_;
    double remaining_s_ = -1.0, remainingSaidAt_s_ = 0.0;
};

} // namespace smat::gui
