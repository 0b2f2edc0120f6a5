#pragma once

#include <functional>
#include <string>
#include <vector>

#include <QTimer>
#include <QUndoStack>

#include "smatcore/project/Project.h"

namespace smat::gui {

/// Keys of settings that differ.
std::vector<std::string> keysThatDiffer(const Settings& one, const Settings& other);
/// Whether nothing but the camera moves by them.
bool areOfCamera(const std::vector<std::string>& keys);
/// The name of a step between two states of the settings: "Set range to 1200 m".
QString stepBetween(const Settings& before, const Settings& after);

/// Edits of a project as steps of an undo stack. Those of the same kind in quick succession, or
/// while a step is held, are one.
class EditSteps : public QObject {
    Q_OBJECT

  public:
    /// `apply` is given what a step makes of the project, each time it is done and undone.
    EditSteps(QUndoStack& stack, std::function<void(const Project&)> apply,
              QObject* parent = nullptr);

    /// Does it. Edits of the same kind have the same `mergeKey`.
    void push(const Project& before, const Project& after, const QString& name,
              const std::string& mergeKey);
    /// The same as a step that nothing else becomes one with.
    void pushAlone(const Project& before, const Project& after, const QString& name,
                   const std::string& mergeKey);
    /// What comes is another step than what was.
    void separate() { ++step_; }
    /// Between the two, all edits of a kind are one, as long as a drag takes.
    void hold();
    void close();
    bool isHeld() const { return isHeld_; }

  private:
    class Command;

    QUndoStack& stack_;
    std::function<void(const Project&)> apply_;
    QTimer pause_;
    bool isHeld_ = false;
    int step_ = 0;
};

} // namespace smat::gui
