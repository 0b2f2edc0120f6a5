#pragma once

#include <functional>
#include <memory>
#include <utility>

#include <QString>
#include <QUndoStack>

#include "gui/workbench/DocumentStep.h"

namespace smat::gui {

/// A value that a page without a file edits, such as its table: each edit is a step on the undo
/// stack of the window. Steps of a page that was closed are passed over.
template <typename State>
class EditedState {
  public:
    static constexpr int noGesture = -1;

    /// `changed` is called after every edit, undo and redo while this lives.
    EditedState(QUndoStack& stack, State first, std::function<void()> changed)
        : stack_(stack),
          now_(std::make_shared<const State>(std::move(first))),
          apply_(std::make_shared<typename DocumentStep<State>::Apply>(
              [this, changed = std::move(changed)](const State& state) {
                  now_ = std::make_shared<const State>(state);
                  changed();
              })) {}
    ~EditedState() { *apply_ = nullptr; }
    EditedState(const EditedState&) = delete;
    EditedState& operator=(const EditedState&) = delete;

    const State& operator*() const { return *now_; }
    const State* operator->() const { return now_.get(); }
    /// A step of this name; nothing where nothing differs. Edits of one gesture (newGesture) are
    /// one step.
    void set(State after, const QString& step, int gesture = noGesture) {
        if (after == *now_)
            return;
        auto* command = new DocumentStep<State>(
            apply_, stack_, now_, std::make_shared<const State>(std::move(after)), gesture);
        command->setText(step);
        stack_.push(command);
    }
    /// What is no step: the place in a table that is looked at.
    void amend(State after) { now_ = std::make_shared<const State>(std::move(after)); }

  private:
    QUndoStack& stack_;
    std::shared_ptr<const State> now_;
    std::shared_ptr<typename DocumentStep<State>::Apply> apply_;
};

} // namespace smat::gui
