#pragma once

#include <functional>
#include <memory>
#include <utility>

#include <QMetaObject>
#include <QUndoCommand>
#include <QUndoStack>

namespace smat::gui {

/// A step of the undo stack that is all of a document before and after. What is typed in one
/// gesture, steps of the same number of 0 or more, is one step.
template <typename State>
class DocumentStep : public QUndoCommand {
  public:
    /// Makes the document be this state; a function without a target once the document is closed.
    using Apply = std::function<void(const State&)>;

    DocumentStep(std::shared_ptr<Apply> apply, QUndoStack& stack,
                 std::shared_ptr<const State> before, std::shared_ptr<const State> after,
                 int gesture)
        : apply_(std::move(apply)),
          stack_(stack),
          before_(std::move(before)),
          after_(std::move(after)),
          gesture_(gesture) {}
    int id() const override { return gesture_; }
    bool mergeWith(const QUndoCommand* next) override {
        const auto* step = dynamic_cast<const DocumentStep*>(next);
        if (step == nullptr || step->apply_ != apply_)
            return false;
        after_ = step->after_;
        setText(step->text());
        setObsolete(*after_ == *before_);
        return true;
    }
    void undo() override {
        if (*apply_)
            (*apply_)(*before_);
        else
            passOn(&QUndoStack::undo);
    }
    void redo() override {
        if (*apply_)
            (*apply_)(*after_);
        else
            passOn(&QUndoStack::redo);
    }

  private:
    /// What was closed is neither undone nor done again: the step before it is.
    void passOn(void (QUndoStack::*next)()) {
        setObsolete(true);
        QMetaObject::invokeMethod(
            &stack_, [stack = &stack_, next] { (stack->*next)(); }, Qt::QueuedConnection);
    }

    std::shared_ptr<Apply> apply_;
    QUndoStack& stack_;
    std::shared_ptr<const State> before_, after_;
    int gesture_;
};

/// The number of another gesture: steps of the project have other numbers.
inline int newGesture() {
    static int last = 0x5ce0000;
    return ++last;
}

} // namespace smat::gui
