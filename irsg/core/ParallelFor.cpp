#include "irsg/core/ParallelFor.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace irsg {

namespace {

/// Threads that wait for work. Made at the first use, ended with the program.
class Pool {
  public:
    explicit Pool(unsigned helpers) {
        for (unsigned i = 0; i < helpers; ++i)
            threads_.emplace_back([this] { help(); });
    }
    ~Pool() {
        {
            const std::lock_guard lock(mutex_);
            ends_ = true;
        }
        wake_.notify_all();
        for (std::thread& thread : threads_)
            thread.join();
    }
    Pool(const Pool&) = delete;
    Pool& operator=(const Pool&) = delete;

    void run(std::size_t count, const std::function<void(std::size_t)>& work) {
        {
            const std::lock_guard lock(mutex_);
            work_ = &work;
            count_ = count;
            next_ = 0;
            failed_ = count;
            failure_ = nullptr;
            ++round_;
            isOpen_ = true;
        }
        wake_.notify_all();
        takeAll();
        // Who has not woken up by now is not waited for.
        std::unique_lock lock(mutex_);
        isOpen_ = false;
        done_.wait(lock, [&] { return busy_ == 0; });
        work_ = nullptr;
        if (failure_)
            std::rethrow_exception(std::exchange(failure_, nullptr));
    }

  private:
    void takeAll() {
        for (std::size_t i = next_++; i < count_; i = next_++) {
            try {
                (*work_)(i);
            } catch (...) {
                const std::lock_guard lock(mutex_);
                if (i < failed_) {
                    failed_ = i;
                    failure_ = std::current_exception();
                }
            }
        }
    }

    void help() {
        std::size_t seen = 0;
        for (;;) {
            {
                std::unique_lock lock(mutex_);
                wake_.wait(lock, [&] { return ends_ || (isOpen_ && round_ != seen); });
                if (ends_)
                    return;
                seen = round_;
                ++busy_;
            }
            takeAll();
            const std::lock_guard lock(mutex_);
            if (--busy_ == 0)
                done_.notify_one();
        }
    }

    std::vector<std::thread> threads_;
    std::mutex mutex_;
    std::condition_variable wake_, done_;
    bool ends_ = false, isOpen_ = false;
    std::size_t round_ = 0, busy_ = 0; // helpers at work
    const std::function<void(std::size_t)>* work_ = nullptr;
    std::size_t count_ = 0, failed_ = 0;
    std::atomic<std::size_t> next_ = 0;
    std::exception_ptr failure_;
};

struct Shared {
    std::mutex mutex; // held while a call is under way
    std::unique_ptr<Pool> pool;
    unsigned threads = 0, wanted = 0;
};

Shared& shared() {
    static Shared one;
    return one;
}

thread_local int onThisThread = 0; // how many OnThisThread live

} // namespace

OnThisThread::OnThisThread() {
    ++onThisThread;
}
OnThisThread::~OnThisThread() {
    --onThisThread;
}

void parallelFor(std::size_t count, const std::function<void(std::size_t)>& work) {
    Shared& all = shared();
    std::unique_lock<std::mutex> lock;
    if (count > 1 && onThisThread == 0)
        lock = std::unique_lock(all.mutex, std::try_to_lock);
    if (lock.owns_lock()) {
        const unsigned threads =
            all.wanted ? all.wanted : std::max(1U, std::thread::hardware_concurrency());
        if (!all.pool || all.threads != threads) {
            all.pool = std::make_unique<Pool>(threads - 1);
            all.threads = threads;
        }
        if (threads > 1)
            return all.pool->run(count, work);
    }
    for (std::size_t i = 0; i < count; ++i)
        work(i);
}

void parallelForSmall(std::size_t count, const std::function<void(std::uint32_t)>& work) {
    constexpr std::size_t atOnce = 16;
    parallelFor((count + atOnce - 1) / atOnce, [&](std::size_t piece) {
        for (std::size_t i = piece * atOnce; i < std::min(count, (piece + 1) * atOnce); ++i)
            work(static_cast<std::uint32_t>(i));
    });
}

unsigned mostThreads() {
    const std::lock_guard lock(shared().mutex);
    return shared().wanted ? shared().wanted : std::max(1U, std::thread::hardware_concurrency());
}

void setMostThreads(unsigned threads) {
    const std::lock_guard lock(shared().mutex);
    shared().wanted = threads;
}

} // namespace irsg
