#pragma once

#include <QWidget>

#include "gui/widgets/Dialogs.h"
#include "gui/widgets/LatestTask.h"
#include "smatcore/tools/QuantityProviders.h"

class QBoxLayout;
class QLabel;
class QListWidget;
class QPushButton;
class QTableWidget;

namespace smat::gui {

class AtmospherePages;
class Workbench;

/// The atmospheres of the project in the order in which they are asked, and which of them answers
/// for which quantity in which band. They are moved by drag or with Alt+Up and Alt+Down; every
/// change is a step of the project.
class ProjectAtmospherePage : public QWidget {
    Q_OBJECT

  public:
    ProjectAtmospherePage(Workbench& workbench, Dialogs dialogs, AtmospherePages& pages,
                          QWidget* parent = nullptr);

    bool isBusy() const { return task_.isBusy(); }

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

  private:
    struct Answer;
    QWidget* makeList();
    QWidget* makeAnswers();
    QPushButton* addButton(QBoxLayout& row, const char* name, const QString& text,
                           const QString& tip, void (ProjectAtmospherePage::*does)());
    /// As the list stands, as a step of the project.
    void take(const QString& step);
    void follow();
    void ask();
    void showAnswer(const Answer& answer);
    void refreshButtons();
    void move(int by);
    void add();
    void edit();
    void remove();
    void up() { move(-1); }
    void down() { move(1); }

    Workbench& workbench_;
    Dialogs dialogs_;
    AtmospherePages& pages_;
    QBoxLayout* halves_ = nullptr;
    QListWidget* list_ = nullptr;
    QTableWidget* table_ = nullptr;
    QLabel *problems_ = nullptr, *empty_ = nullptr;
    QPushButton *edit_ = nullptr, *remove_ = nullptr, *up_ = nullptr, *down_ = nullptr;
    LatestTask task_; ///< last: nothing of it is heard once the rest goes
};

} // namespace smat::gui
