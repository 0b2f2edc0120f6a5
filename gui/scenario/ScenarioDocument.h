#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>

#include <QObject>
#include <QUndoStack>

#include "gui/workbench/DocumentStep.h"
#include "irsg/core/FileStamp.h"
#include "smatcore/simulate/LoadedScenario.h"

namespace smat::gui {

/// What is edited of a scenario: its file and the trajectories that it names.
struct EditedScenario {
    Scenario scenario;
    EditedTrajectories trajectories; ///< all of them, by their resolved file

    /// Null where the file is none of them.
    const TrajectoryTable* table(const std::filesystem::path& file) const;
    bool operator==(const EditedScenario&) const = default;
};

/// A scenario that is open, as it is edited: what it was, what it is, and the steps between them on
/// the undo stack of the window. Knows no widget.
class ScenarioDocument : public QObject {
    Q_OBJECT

  public:
    /// Reads the scenario and its trajectories. Throws irsg::InputError with what is wrong with any
    /// of them.
    ScenarioDocument(const std::filesystem::path& file, QUndoStack& undoStack,
                     QObject* parent = nullptr);
    ~ScenarioDocument() override;

    const Scenario& scenario() const { return now_->scenario; }
    /// Never changes; another state is another value.
    std::shared_ptr<const EditedScenario> now() const { return now_; }
    const std::filesystem::path& file() const { return now_->scenario.file; }
    bool isModified() const { return *now_ != saved_; }

    /// A step of this name; nothing where nothing differs. Steps of one gesture, as letters that
    /// are typed into a field, are one.
    void edit(EditedScenario after, const QString& step, int gesture = noGesture);
    /// The same by a function that changes the state. What a file could not hold is refused: says
    /// then what was expected, and nothing changes.
    QString change(const QString& step, const std::function<void(EditedScenario&)>& edit,
                   int gesture = noGesture);
    static constexpr int noGesture = -1;

    /// Whether another program has written one of the files since it was read or saved.
    bool isChangedOnDisk() const;
    /// Writes the scenario and the trajectories that were edited. Throws irsg::InputError.
    void save();
    /// Writes everything to another file, whose scenario this becomes; into another folder it takes
    /// its trajectories along, under other names where theirs are taken. Throws irsg::InputError.
    void saveAs(const std::filesystem::path& file);

  signals:
    void changed();
    /// isModified() or the file may be another.
    void stateChanged();

  private:
    void apply(const EditedScenario& state);
    void take(EditedScenario state);
    /// The same scenario told from the folder of `file`, with trajectories that moved at their new
    /// places.
    EditedScenario movedTo(const EditedScenario& state, const std::filesystem::path& file) const;
    void noteStamps();

    QUndoStack& undoStack_;
    std::shared_ptr<const EditedScenario> now_;
    EditedScenario saved_;
    std::map<std::filesystem::path, std::filesystem::path> moved_; ///< trajectories, since opened
    std::map<std::filesystem::path, irsg::FileStamp> stamps_;
    std::shared_ptr<DocumentStep<EditedScenario>::Apply> apply_; ///< of its steps
};

} // namespace smat::gui
