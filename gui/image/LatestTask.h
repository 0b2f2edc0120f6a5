#pragma once

#include <atomic>
#include <exception>
#include <functional>
#include <memory>
#include <optional>

#include <QObject>
#include <QThreadPool>

namespace smat::gui {

/// Work off the window's thread of which only the last one asked for counts: an older one that has
/// not begun is skipped, and what it gives is dropped. Never waits: destroying it, or asking anew,
/// returns at once, and what still runs is not heard of again.
class LatestTask {
  public:
    LatestTask() : state_(new State, [](State* state) { state->deleteLater(); }) {}
    ~LatestTask() { cancel(); }
    LatestTask(const LatestTask&) = delete;
    LatestTask& operator=(const LatestTask&) = delete;

    /// `work` runs in a thread of the pool and must own what it uses; `use` gets its result, or
    /// `fail` what it threw, in the thread that called this.
    template <typename Result>
    void run(std::function<Result()> work, std::function<void(Result)> use,
             std::function<void(std::exception_ptr)> fail = {}) {
        const unsigned mine = ++state_->wanted;
        QThreadPool::globalInstance()->start([state = state_, mine, work = std::move(work),
                                              use = std::move(use), fail = std::move(fail)] {
            if (state->wanted != mine)
                return;
            auto result = std::make_shared<std::optional<Result>>();
            std::exception_ptr thrown;
            try {
                result->emplace(work());
            } catch (...) {
                thrown = std::current_exception();
            }
            QMetaObject::invokeMethod(
                state.get(),
                [state, mine, result, thrown, use, fail] {
                    if (state->wanted != mine)
                        return;
                    state->finished = mine;
                    if (!thrown)
                        use(std::move(**result));
                    else if (fail)
                        fail(thrown);
                    else
                        std::rethrow_exception(thrown);
                },
                Qt::QueuedConnection);
        });
    }
    /// Nothing that was asked for is heard of any more.
    void cancel() { state_->finished = ++state_->wanted; }
    bool isBusy() const { return state_->finished != state_->wanted; }

  private:
    struct State : QObject {
        std::atomic<unsigned> wanted = 0;
        unsigned finished = 0; ///< of the thread of the window alone
    };
    std::shared_ptr<State> state_;
};

} // namespace smat::gui
