#pragma once

#include <functional>

#include <QWidget>

#include "gui/scenario/ScenarioParts.h"
#include "gui/widgets/Dialogs.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QToolButton;
class QVBoxLayout;

namespace smat::gui {

class MountFields;
class PlaceFields;
class ScenarioFields;
class TrajectoryModel;
class TrajectoryView;

/// The fields of a scenario: its title, times, notes and settings, and of the entity or the sensor
/// that is chosen its name and where it is, a table of its trajectory or a place; of a sensor what
/// carries it, what it looks at and its settings. What cannot be is told below.
class EditPanel : public QWidget {
    Q_OBJECT

  public:
    EditPanel(ScenarioDocument& document, Dialogs dialogs, QWidget* parent = nullptr);
    TrajectoryView* table() const { return table_; }

  private:
    void makeWhole(QVBoxLayout* column);
    void makePart(QVBoxLayout* column);
    QToolButton* tableButton(const char* drawing, const char* name, const QString& tip);
    void follow();
    void followPart();
    void showPlace(const std::filesystem::path& trajectory, bool hold, const irsg::Pose& pose);
    ScenarioPart part() const;
    void choosePart(const ScenarioPart& part);
    QString partName() const;

    /// An edit in the fields; says below why it cannot be.
    void change(const QString& step, const std::function<void(EditedScenario&)>& edit);
    void say(const QString& sentence);
    /// The typing is over: the next one is another step, and what was there before a text that is
    /// refused comes back.
    void finish();
    void rename(const QString& name);
    void addEntity();
    void addSensor();
    void removeChosen();
    /// A new one, or one from a file, for the chosen part.
    void takeTrajectory(bool fromFile);
    void letEntityStand();

    ScenarioDocument& document_;
    Dialogs dialogs_;
    int gesture_ = ScenarioDocument::noGesture;
    std::shared_ptr<const EditedScenario> before_; ///< the typing that goes on
    QComboBox* part_ = nullptr;
    QToolButton *add_ = nullptr, *addSensor_ = nullptr, *remove_ = nullptr;
    QToolButton *newTrajectory_ = nullptr, *trajectoryFile_ = nullptr, *standStill_ = nullptr;
    QToolButton* settings_ = nullptr;
    QWidget *ofPart_ = nullptr, *ofTable_ = nullptr;
    ScenarioFields* whole_ = nullptr;
    QLineEdit* name_ = nullptr;
    MountFields* mount_ = nullptr;
    QLabel *where_ = nullptr, *follows_ = nullptr, *message_ = nullptr;
    PlaceFields* place_ = nullptr;
    QCheckBox* hold_ = nullptr;
    TrajectoryModel* rows_ = nullptr;
    TrajectoryView* table_ = nullptr;
};

} // namespace smat::gui
