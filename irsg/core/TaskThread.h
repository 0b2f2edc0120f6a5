#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <future>
#include <mutex>
#include <thread>

namespace irsg {

/// A thread that does what it is given, in that order.
class TaskThread {
  public:
    TaskThread();
    /// Does what it was given first.
    ~TaskThread();
    TaskThread(const TaskThread&) = delete;
    TaskThread& operator=(const TaskThread&) = delete;

    /// The future is ready when the task is done, and throws what it threw.
    std::future<void> post(std::function<void()> task);

  private:
    void loop();

    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<std::packaged_task<void()>> tasks_;
    bool ends_ = false;
    std::thread thread_; // last: it uses all others
};

} // namespace irsg
