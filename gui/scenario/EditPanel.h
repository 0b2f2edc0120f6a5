#pragma once

#include <functional>
#include <optional>

#include <QWidget>

#include "gui/scenario/ScenarioDocument.h"
#include "gui/widgets/Dialogs.h"

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QToolButton;
class QVBoxLayout;

namespace smat::gui {

class NumberField;
class PlaceFields;
class TrajectoryModel;
class TrajectoryView;

/// The fields of a scenario: its title and times, and of the entity or the sensor that is chosen
/// its name and where it is, a table of its trajectory or a place. What cannot be is told below.
class EditPanel : public QWidget {
    Q_OBJECT

  public:
    EditPanel(ScenarioDocument& document, Dialogs dialogs, QWidget* parent = nullptr);
    TrajectoryView* table() const { return table_; }

  private:
    /// What the fields are about: an entity, a sensor or, with neither, the scenario.
    struct Part {
        std::optional<std::size_t> entity, sensor;
    };

    void makeTimes(QVBoxLayout* column);
    void makePart(QVBoxLayout* column);
    QToolButton* tableButton(const char* drawing, const char* name, const QString& tip);
    NumberField* timeField(QFormLayout* form, const char* name, const QString& label,
                           const QString& step, double Scenario::*time);
    void follow();
    void followPart();
    void showPlace(const std::filesystem::path& trajectory, bool hold, const irsg::Pose& pose);
    Part part() const;
    /// The trajectory of the chosen part; empty where it has none.
    std::filesystem::path trajectoryOf(const EditedScenario& state) const;
    QString partName() const;

    /// An edit in the fields; says below why it cannot be.
    void change(const QString& step, const std::function<void(EditedScenario&)>& edit);
    void say(const QString& sentence);
    /// The typing is over: the next one is another step, and what was there before a text that is
    /// refused comes back.
    void finish();
    void rename(const QString& name);
    void addEntity();
    void removeEntity();

    ScenarioDocument& document_;
    Dialogs dialogs_;
    int gesture_ = ScenarioDocument::noGesture;
    std::shared_ptr<const EditedScenario> before_; ///< the typing that goes on
    QComboBox* part_ = nullptr;
    QToolButton *add_ = nullptr, *remove_ = nullptr;
    QWidget *times_ = nullptr, *ofPart_ = nullptr, *ofTable_ = nullptr;
    QLineEdit *title_ = nullptr, *name_ = nullptr;
    NumberField *start_ = nullptr, *end_ = nullptr, *step_ = nullptr;
    QLabel *where_ = nullptr, *follows_ = nullptr, *message_ = nullptr;
    PlaceFields* place_ = nullptr;
    QCheckBox* hold_ = nullptr;
    TrajectoryModel* rows_ = nullptr;
    TrajectoryView* table_ = nullptr;
};

} // namespace smat::gui
