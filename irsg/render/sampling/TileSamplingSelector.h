#pragma once

#include <memory>

#include "irsg/render/sampling/TileSamplingStrategy.h"
#include "irsg/render/values/RenderSettings.h"

namespace irsg {

/// Keeps the strategy that the settings ask for; it may change from frame to frame.
class TileSamplingSelector {
  public:
    TileSamplingStrategy& strategyFor(const RenderSettings& settings);

  private:
    RenderSettings settings_;
    std::unique_ptr<TileSamplingStrategy> strategy_;
};

} // namespace irsg
