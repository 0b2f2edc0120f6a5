#include "irsg/core/StageReport.h"

#include <algorithm>
#include <utility>

namespace irsg {

namespace {

thread_local StageListener* listening = nullptr;

} // namespace

StageListener::StageListener(Call call) : call_(std::move(call)), outer_(listening) {
    listening = this;
}

StageListener::~StageListener() {
    listening = outer_;
}

bool StageListener::isThere() {
    return listening != nullptr;
}

StageScope::StageScope(std::string_view stage) : listener_(listening) {
    if (listener_ == nullptr)
        return;
    before_ = std::exchange(listener_->stage_, std::string(stage));
    listener_->call_(listener_->stage_, std::nullopt);
}

StageScope::~StageScope() {
    if (listener_ == nullptr)
        return;
    listener_->stage_ = std::move(before_);
    listener_->call_(listener_->stage_, std::nullopt);
}

StageCount::StageCount(std::string_view part, std::size_t total)
    : listener_(listening), total_(std::max<std::size_t>(total, 1)) {
    if (listener_ == nullptr)
        return;
    before_ = listener_->stage_;
    listener_->stage_ += (before_.empty() ? "" : ": ") + std::string(part);
    listener_->call_(listener_->stage_, 0.0);
}

StageCount::~StageCount() {
    if (listener_ == nullptr)
        return;
    listener_->stage_ = std::move(before_);
    listener_->call_(listener_->stage_, std::nullopt);
}

void StageCount::add(std::size_t pieces) {
    if (listener_ == nullptr)
        return;
    const auto percentOf = [&](std::size_t done) { return 100 * std::min(done, total_) / total_; };
    if (percentOf(done_ += pieces) <= told_percent_)
        return;
    // Who comes while another tells leaves it to the next, but for the last piece.
    std::unique_lock lock(telling_, std::defer_lock);
    if (done_ >= total_)
        lock.lock();
    else if (!lock.try_lock())
        return;
    const std::size_t done = std::min(done_.load(), total_);
    if (percentOf(done) <= told_percent_)
        return;
    told_percent_ = percentOf(done);
    listener_->call_(listener_->stage_, static_cast<double>(done) / static_cast<double>(total_));
}

} // namespace irsg
