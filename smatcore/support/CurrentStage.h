#pragma once

#include <mutex>
#include <optional>
#include <string>
#include <string_view>

#include "irsg/core/StageReport.h"

namespace smat {

/// What the renderer of a job is doing, from the thread that works to any that shows it.
class CurrentStage {
  public:
    /// While it lives the calls of this thread tell their stages.
    class Listening {
      public:
        explicit Listening(CurrentStage& stage);
        ~Listening();
        Listening(const Listening&) = delete;
        Listening& operator=(const Listening&) = delete;

      private:
        CurrentStage& stage_;
        irsg::StageListener listener_;
    };

    /// "inter-reflection: pairs, 43 %"; without a share where none is known, empty between stages.
    std::string text() const;

  private:
    void set(std::string_view name, std::optional<double> share);

    mutable std::mutex mutex_;
    std::string name_;
    std::optional<double> share_;
};

} // namespace smat
