#include "irsg/scene/StageClock.h"

#include <algorithm>

namespace irsg {

void StageClock::add(const std::string& stage, double seconds) {
    auto found = std::ranges::find(stages_, stage, &StageTimes::Stage::name);
    if (found == stages_.end())
        found = stages_.insert(stages_.end(), {stage, 0.0, 0});
    found->seconds += seconds;
    ++found->calls;
}

} // namespace irsg
