#pragma once

#include <QDockWidget>

class QLabel;
class QListWidget;
class QProgressBar;
class QTimer;
class QToolButton;

namespace smat::gui {

class Workbench;

/// What runs, with progress, elapsed time and a cancel that answers at once; below it what came out
/// in this session.
class ResultsDock : public QDockWidget {
    Q_OBJECT

  public:
    explicit ResultsDock(Workbench& workbench, QWidget* parent = nullptr);

    QList<int> selectedResults() const;

  signals:
    /// The user wants to see these; several belong on one plot.
    void showRequested(const QList<int>& ids);

  private:
    void onJobStarted(const QString& title);
    void refreshElapsed();
    void addResult(int id);
    void refreshButtons();

    Workbench& workbench_;
    QWidget* jobPanel_ = nullptr;
    QLabel* jobTitle_ = nullptr;
    QLabel* jobDetail_ = nullptr;
    QProgressBar* progress_ = nullptr;
    QToolButton* cancel_ = nullptr;
    QTimer* timer_ = nullptr;
    QListWidget* list_ = nullptr;
    QToolButton* overlay_ = nullptr;
    QToolButton* remove_ = nullptr;
    QLabel* empty_ = nullptr;
    QString what_;
};

} // namespace smat::gui
