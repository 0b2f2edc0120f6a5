#pragma once

#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace smat::python {

/// Things that one thread uses at a time and that are dear to make: each thread leases one, a new
/// one where all are in use. As many stay as were ever in use at once.
template <typename Thing>
class Pool {
  public:
    /// One of them, until the end of its scope.
    class Lease {
      public:
        explicit Lease(Pool& pool) : pool_(pool), thing_(pool.take()) {}
        ~Lease() { pool_.giveBack(std::move(thing_)); }
        Lease(const Lease&) = delete;
        Lease& operator=(const Lease&) = delete;

        Thing& operator*() const { return *thing_; }
        Thing* operator->() const { return thing_.get(); }

      private:
        Pool& pool_;
        std::unique_ptr<Thing> thing_;
    };

  private:
    std::unique_ptr<Thing> take() {
        const std::lock_guard lock(mutex_);
        if (idle_.empty())
            return std::make_unique<Thing>();
        std::unique_ptr<Thing> thing = std::move(idle_.back());
        idle_.pop_back();
        return thing;
    }
    void giveBack(std::unique_ptr<Thing> thing) {
        const std::lock_guard lock(mutex_);
        idle_.push_back(std::move(thing));
    }

    std::mutex mutex_;
    std::vector<std::unique_ptr<Thing>> idle_;
};

} // namespace smat::python
