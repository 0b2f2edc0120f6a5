#pragma once

#include <atomic>
#include <mutex>

namespace irsg {

/// std::call_once whose calls after the first cost one load: for values that are computed when they
/// are first asked for and read often.
class CallOnceFast {
  public:
    template <typename Function>
    void call(Function&& function) {
        if (done_.load(std::memory_order_acquire))
            return;
        std::call_once(flag_, [&] {
            function();
            done_.store(true, std::memory_order_release);
        });
    }

  private:
    std::once_flag flag_;
    std::atomic<bool> done_{false};
};

} // namespace irsg
