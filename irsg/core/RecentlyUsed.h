#pragma once

#include <algorithm>
#include <cstddef>
#include <list>
#include <utility>

namespace irsg {

/// Values that were asked for lately, at most so many: one more pushes out the one that was not
/// asked for longest. Values stay where they are until they go. Not safe between threads.
template <typename Value>
class RecentlyUsed {
  public:
    explicit RecentlyUsed(std::size_t most) : most_(most) {}

    /// The first value of which `is(value)` holds, which is the latest from now on; null where
    /// there is none.
    template <typename Is>
    Value* find(Is is) {
        const auto found = std::ranges::find_if(values_, is);
        if (found == values_.end())
            return nullptr;
        values_.splice(values_.begin(), values_, found);
        return &values_.front();
    }
    /// Adds a value as the latest.
    Value& add(Value value) {
        values_.push_front(std::move(value));
        if (values_.size() > most_)
            values_.pop_back();
        return values_.front();
    }
    /// What `is` finds, or else what `make()` gives.
    template <typename Is, typename Make>
    Value& of(Is is, Make make) {
        Value* const known = find(is);
        return known != nullptr ? *known : add(make());
    }

    std::size_t size() const { return values_.size(); }
    void clear() { values_.clear(); }
    /// Visits values from the latest to the oldest and lets go those for which `goes(value)` holds.
    template <typename Goes>
    void letGo(Goes goes) {
        std::erase_if(values_, goes);
    }

  private:
    std::size_t most_;
    std::list<Value> values_;
};

} // namespace irsg
