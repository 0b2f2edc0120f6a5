#pragma once

#include <QWidget>

class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;

namespace smat::gui {

/// What stands below the form of a page that runs something long: what is wrong with the form, Run
/// and Cancel, progress, the same as a command line, and where the result is kept.
class RunFoot : public QWidget {
    Q_OBJECT

  public:
    RunFoot(const QString& whatCancelDoes, QWidget* parent);

    QLabel* problem;
    QPushButton* run;
    QPushButton* cancel;
    QProgressBar* progress; ///< of 1000
    QLineEdit* command;
    QLabel* unsaved;

    /// The form, which scrolls where there is little room, above the foot.
    static QWidget* below(QWidget* form, RunFoot* foot, QWidget* parent);
};

} // namespace smat::gui
