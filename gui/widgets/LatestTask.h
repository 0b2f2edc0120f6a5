#pragma once

#include <atomic>
#include <exception>
#include <functional>
#include <memory>
#include <optional>

#include <QObject>
#include <QThread>

#include "gui/widgets/BackgroundPool.h"

namespace smat::gui {

/// Work off the window's thread of which only the last one asked for counts: an older one that has
/// not begun is skipped, and what it gives is dropped. Never waits: destroying it, or asking anew,
/// returns at once, and what still runs is not heard of again.
class LatestTask {
  public:
    LatestTask() : state_(new State, release) {}
    ~LatestTask() { cancel(); }
    LatestTask(const LatestTask&) = delete;
    LatestTask& operator=(const LatestTask&) = delete;

    /// `work` runs in a thread of the pool and must own what it uses; `use` gets its result, or
    /// `fail` what it threw, in the thread that called this.
    template <typename Result>
    void run(std::function<Result()> work, std::function<void(Result)> use,
             std::function<void(std::exception_ptr)> fail = {}) {
        const unsigned mine = ++state_->wanted;
        backgroundPool().start([state = state_, mine, work = std::move(work), use = std::move(use),
                                fail = std::move(fail)] {
            if (state->wanted != mine)
                return;
            auto result = std::make_shared<std::optional<Result>>();
            std::exception_ptr thrown;
            try {
                result->emplace(work());
            } catch (...) {
                thrown = std::current_exception();
            }
            // The answer is sent to the state and must not own it: an answer that nobody fetches is
            // thrown away with the queue it waits in, where nothing can be posted any more.
            QMetaObject::invokeMethod(
                state.get(),
                [state = state.get(), mine, result, thrown, use, fail] {
                    if (state->wanted != mine)
                        return;
                    state->finished = mine;
                    const Answering answering(*state);
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
        unsigned finished = 0;  ///< of the thread of the window alone
        bool answering = false; ///< so is this
    };
    struct Answering {
        explicit Answering(State& of) : state(of) { state.answering = true; }
        ~Answering() { state.answering = false; }
        Answering(const Answering&) = delete;
        Answering& operator=(const Answering&) = delete;
        State& state;
    };
    /// At once where it is safe: after the last turn of the event loop there is no later.
    static void release(State* state) {
        if (state->thread() == QThread::currentThread() && !state->answering)
            delete state;
        else
            state->deleteLater();
    }
    std::shared_ptr<State> state_;
};

} // namespace smat::gui
