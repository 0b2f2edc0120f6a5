#include "smatcore/support/StageTimer.h"

#include <algorithm>

#include <fmt/format.h>

namespace smat {

namespace {

double secondsBetween(std::chrono::steady_clock::time_point from,
                      std::chrono::steady_clock::time_point to) {
    return std::chrono::duration<double>(to - from).count();
}

} // namespace

// The first stage is `other`: time is charged to it whenever no scope is open.
StageTimer::StageTimer() : stages_{{"other", 0.0, 0}}, start_(Clock::now()), last_(start_) {}

StageTimer::Scope::Scope(StageTimer* timer, const std::string& stage) : timer_(timer) {
    if (timer_ != nullptr)
        outer_ = timer_->enter(stage);
}

StageTimer::Scope::~Scope() {
    if (timer_ != nullptr)
        timer_->leave(outer_);
}

void StageTimer::addBefore(const std::string& stage, double seconds) {
    Stage& own = stages_[indexOf(stage)];
    own.seconds += seconds;
    ++own.calls;
    before_s_ += seconds;
}

void StageTimer::split(const std::string& stage, const std::vector<Stage>& parts) {
    charge();
    const std::size_t whole = indexOf(stage);
    for (const Stage& part : parts) {
        const double seconds = std::min(part.seconds, stages_[whole].seconds);
        const std::size_t index = indexOf(stage + ": " + part.name);
        stages_[index].seconds += seconds;
        stages_[index].calls += part.calls;
        stages_[whole].seconds -= seconds;
    }
}

std::vector<StageTimer::Stage> StageTimer::stages() const {
    std::vector<Stage> ordered(stages_.begin() + 1, stages_.end());
    ordered.push_back(stages_.front());
    // What has passed since the last change of stage belongs to the stage that is open.
    const std::size_t open = current_ == 0 ? ordered.size() - 1 : current_ - 1;
    ordered[open].seconds += secondsBetween(last_, Clock::now());
    return ordered;
}

double StageTimer::wall_s() const {
    return before_s_ + secondsBetween(start_, Clock::now());
}

std::string StageTimer::toText() const {
    const std::vector<Stage> all = stages();
    double sum = 0.0;
    std::size_t widest = 5;
    for (const Stage& stage : all) {
        sum += stage.seconds;
        widest = std::max(widest, stage.name.size());
    }
    std::string text =
        fmt::format("{:<{}} {:>8} {:>10} {:>7}\n", "stage", widest, "calls", "s", "%");
    for (const Stage& stage : all) {
        text += fmt::format("{:<{}} {:>8} {:>10.4f} {:>7.2f}\n", stage.name, widest, stage.calls,
                            stage.seconds, sum > 0.0 ? 100.0 * stage.seconds / sum : 0.0);
    }
    text += fmt::format("{:<{}} {:>8} {:>10.4f} {:>7.2f}\n", "sum", widest, "", sum, 100.0);
    return text;
}

std::size_t StageTimer::indexOf(const std::string& stage) {
    const auto found = std::find_if(stages_.begin(), stages_.end(),
                                    [&](const Stage& one) { return one.name == stage; });
    if (found != stages_.end())
        return static_cast<std::size_t>(found - stages_.begin());
    stages_.push_back({stage, 0.0, 0});
    return stages_.size() - 1;
}

std::size_t StageTimer::enter(const std::string& stage) {
    charge();
    const std::size_t outer = current_;
    current_ = indexOf(stage);
    ++stages_[current_].calls;
    return outer;
}

void StageTimer::leave(std::size_t outer) {
    charge();
    current_ = outer;
}

void StageTimer::charge() {
    const Clock::time_point now = Clock::now();
    stages_[current_].seconds += secondsBetween(last_, now);
    last_ = now;
}

} // namespace smat
