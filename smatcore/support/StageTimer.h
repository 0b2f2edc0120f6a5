#pragma once

#include <chrono>
#include <string>
#include <vector>

namespace smat {

/// Wall time by stage, for `--timing` (F58). Stages may nest: time counts for the innermost one, so
/// that the stages add up to the wall time since the timer was made; what no stage claims is
/// `other`.
class StageTimer {
  public:
    struct Stage {
        std::string name;
        double seconds = 0.0;
        long calls = 0;
    };

    StageTimer();

    /// Counts the time of its own life for a stage.
    class Scope {
      public:
        Scope(StageTimer* timer, const std::string& stage);
        ~Scope();
        Scope(const Scope&) = delete;
        Scope& operator=(const Scope&) = delete;

      private:
        StageTimer* timer_;
        std::size_t outer_ = 0;
    };

    /// Adds a stage that was over before the timer was made, which its wall time then holds, too.
    void addBefore(const std::string& stage, double seconds);
    /// Splits a part of a stage off into stages of its own, measured elsewhere (by the renderer).
    void split(const std::string& stage, const std::vector<Stage>& parts);
    /// In order of first use, `other` last.
    std::vector<Stage> stages() const;
    double wall_s() const;
    /// A table for people: stage, calls, seconds, share; the sum last.
    std::string toText() const;

  private:
    using Clock = std::chrono::steady_clock;
    std::size_t indexOf(const std::string& stage);
    std::size_t enter(const std::string& stage);
    void leave(std::size_t outer);
    void charge();

    double before_s_ = 0.0;
    std::vector<Stage> stages_;
    std::size_t current_ = 0;
    Clock::time_point start_;
    Clock::time_point last_;
};

} // namespace smat
