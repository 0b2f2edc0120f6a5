#pragma once

#include <vector>

#include <QDialog>

#include "gui/scenario/SimulationFrames.h"
#include "gui/widgets/Dialogs.h"

class QCheckBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace smat::gui {

struct EditedScenario;

/// What is written of a scenario, and where to: sensors, forms of the frames and a folder; and the
/// command that does the same.
class RunScenarioDialog : public QDialog {
    Q_OBJECT

  public:
    /// `isSaved` is false where the files are not what is run, so that no command does the same.
    RunScenarioDialog(const EditedScenario& scenario, bool isSaved, Dialogs& dialogs,
                      QWidget* parent = nullptr);
    SimulationJob order() const;

  private:
    void refresh();
    std::string commandLine() const;

    const EditedScenario& scenario_;
    bool isSaved_;
    QLineEdit* folder_ = nullptr;
    std::vector<QCheckBox*> sensors_, forms_;
    QLineEdit* command_ = nullptr;
    QLabel* problem_ = nullptr;
    QPushButton* run_ = nullptr;
};

} // namespace smat::gui
