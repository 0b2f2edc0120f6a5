#pragma once

#include <optional>
#include <vector>

namespace smat::gui {

/// The views that were left, the last one first to come back; at most a hundred.
template <typename View>
class ViewHistory {
  public:
    void remember(const View& view) {
        constexpr std::size_t kept = 100;
        if (!past_.empty() && past_.back() == view)
            return;
        past_.push_back(view);
        if (past_.size() > kept)
            past_.erase(past_.begin());
    }
    bool empty() const { return past_.empty(); }
    void clear() { past_.clear(); }
    std::optional<View> takeBack() {
        if (past_.empty())
            return std::nullopt;
        const View last = past_.back();
        past_.pop_back();
        return last;
    }

  private:
    std::vector<View> past_;
};

} // namespace smat::gui
