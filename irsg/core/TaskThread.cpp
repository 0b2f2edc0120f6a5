#include "irsg/core/TaskThread.h"

#include <utility>

namespace irsg {

TaskThread::TaskThread() : thread_([this] { loop(); }) {}

TaskThread::~TaskThread() {
    {
        const std::lock_guard lock(mutex_);
        ends_ = true;
    }
    changed_.notify_all();
    thread_.join();
}

std::future<void> TaskThread::post(std::function<void()> task) {
    std::packaged_task<void()> packaged(std::move(task));
    std::future<void> done = packaged.get_future();
    const std::lock_guard lock(mutex_);
    tasks_.push_back(std::move(packaged));
    changed_.notify_all(); // with the lock: when the task is done, this may go
    return done;
}

void TaskThread::loop() {
    std::unique_lock lock(mutex_);
    for (;;) {
        changed_.wait(lock, [&] { return ends_ || !tasks_.empty(); });
        if (tasks_.empty())
            return;
        {
            std::packaged_task<void()> task = std::move(tasks_.front());
            tasks_.pop_front();
            lock.unlock();
            task();
        } // what it holds goes before the next task begins
        lock.lock();
    }
}

} // namespace irsg
