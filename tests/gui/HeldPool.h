#pragma once

#include <memory>
#include <semaphore>

#include <QThreadPool>

#include "gui/widgets/BackgroundPool.h"

namespace smat::gui::test {

/// While it lives nothing of the background pool's work begins: what a window does meanwhile can be
/// looked at, however quick or busy the machine is.
class HeldPool {
  public:
    HeldPool() {
        for (int i = 0; i < threads_; ++i) {
            backgroundPool().start([gate = gate_] {
                gate->held.release();
                gate->mayEnd.acquire();
            });
        }
        for (int i = 0; i < threads_; ++i) {
            gate_->held.acquire();
        }
    }
    ~HeldPool() { gate_->mayEnd.release(threads_); }
    HeldPool(const HeldPool&) = delete;
    HeldPool& operator=(const HeldPool&) = delete;

  private:
    struct Gate {
        std::counting_semaphore<> held{0};
        std::counting_semaphore<> mayEnd{0};
    };
    const int threads_ = backgroundPool().maxThreadCount();
    std::shared_ptr<Gate> gate_ = std::make_shared<Gate>();
};

} // namespace smat::gui::test
