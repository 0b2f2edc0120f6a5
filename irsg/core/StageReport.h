#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

namespace irsg {

/// While it lives, is told what the calls of its thread are doing: the stage ("inter-reflection:
/// view factors"; empty between stages) and, where it is known, how much of it is done, 0 to 1. The
/// latest of a thread is told, shares also by threads that work for the call, one at a time.
/// Nothing else depends on whether there is one.
class StageListener {
  public:
    using Call = std::function<void(std::string_view stage, std::optional<double> share)>;

    explicit StageListener(Call call);
    ~StageListener();
    StageListener(const StageListener&) = delete;
    StageListener& operator=(const StageListener&) = delete;

    /// Whether this thread has one.
    static bool isThere();

  private:
    friend class StageScope;
    friend class StageCount;

    Call call_;
    StageListener* outer_;
    std::string stage_;
};

/// A stage that begins here and ends with this object; then goes on what was before.
class StageScope {
  public:
    explicit StageScope(std::string_view stage);
    ~StageScope();
    StageScope(const StageScope&) = delete;
    StageScope& operator=(const StageScope&) = delete;

  private:
    StageListener* listener_;
    std::string before_;
};

/// A part of the current stage that consists of so many pieces of about equal work. Pieces may be
/// counted in any thread; the listener is told once for each percent at most.
class StageCount {
  public:
    /// `part`: a word or two behind the name of the stage.
    StageCount(std::string_view part, std::size_t total);
    ~StageCount();
    StageCount(const StageCount&) = delete;
    StageCount& operator=(const StageCount&) = delete;

    void add(std::size_t pieces = 1);

  private:
    StageListener* listener_;
    std::string before_;
    std::size_t total_;
    std::atomic<std::size_t> done_ = 0, told_percent_ = 0;
    std::mutex telling_;
};

} // namespace irsg
