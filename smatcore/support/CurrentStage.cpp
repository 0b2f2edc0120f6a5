#include "smatcore/support/CurrentStage.h"

#include <cmath>

#include <fmt/format.h>

namespace smat {

CurrentStage::Listening::Listening(CurrentStage& stage)
    : stage_(stage), listener_([&stage](std::string_view name, std::optional<double> share) {
          stage.set(name, share);
      }) {}

CurrentStage::Listening::~Listening() {
    stage_.set({}, std::nullopt);
}

void CurrentStage::set(std::string_view name, std::optional<double> share) {
    const std::scoped_lock lock(mutex_);
    name_ = name;
    share_ = share;
}

std::string CurrentStage::text() const {
    const std::scoped_lock lock(mutex_);
    if (name_.empty() || !share_)
        return name_;
    return fmt::format("{}, {} %", name_, static_cast<int>(std::floor(100.0 * *share_)));
}

} // namespace smat
