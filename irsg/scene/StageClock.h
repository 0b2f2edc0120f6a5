#pragma once

#include <string>
#include <type_traits>
#include <vector>

#include "irsg/core/StageReport.h"
#include "irsg/core/Stopwatch.h"
#include "irsg/render/values/RenderReport.h"

namespace irsg {

/// Times of the stages of a renderer's calls, by name, in the order in which they first took any.
class StageClock {
  public:
    /// Does work, adds its time to a stage and returns what it returns. A StageListener of this
    /// thread hears of it.
    template <typename Work>
    auto timed(const char* stage, Work work) {
        const StageScope scope(stage);
        double seconds = 0.0;
        if constexpr (std::is_void_v<decltype(work())>) {
            {
                Stopwatch watch(seconds);
                work();
            }
            add(stage, seconds);
        } else {
            auto result = [&] {
                Stopwatch watch(seconds);
                return work();
            }();
            add(stage, seconds);
            return result;
        }
    }
    void add(const std::string& stage, double seconds);

    const std::vector<StageTimes::Stage>& stages() const { return stages_; }

  private:
    std::vector<StageTimes::Stage> stages_;
};

} // namespace irsg
