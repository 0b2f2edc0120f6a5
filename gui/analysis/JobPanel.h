#pragma once

#include <QWidget>

class QLabel;
class QProgressBar;
class QTimer;
class QToolButton;

namespace smat {
struct Progress;
}

namespace smat::gui {

class Workbench;

/// The analysis that runs: how far it is, for how long it has run and about how long it will, and a
/// cancel that is answered at once. Hidden while nothing runs.
class JobPanel : public QWidget {
    Q_OBJECT

  public:
    explicit JobPanel(Workbench& workbench, QWidget* parent = nullptr);

  private:
    void onStarted(const QString& title);
    void onProgressed(const smat::Progress& now);
    void refresh();

    Workbench& workbench_;
    QLabel* title_ = nullptr;
    QLabel* what_ = nullptr;
    QLabel* times_ = nullptr;
    QProgressBar* bar_ = nullptr;
    QToolButton* cancel_ = nullptr;
    QTimer* timer_ = nullptr;
    QString case_;
    double remaining_s_ = -1.0, remainingSaidAt_s_ = 0.0;
};

} // namespace smat::gui
