#pragma once

#include <memory>

#include "irsg/render/sampling/AbstractZoomAntialiasingStrategy.h"
#include "irsg/render/values/RenderSettings.h"

namespace irsg {

/// Keeps the strategy that the settings ask for; it may change from frame to frame.
class ZoomAntialiasingManager {
  public:
    AbstractZoomAntialiasingStrategy& strategyFor(const RenderSettings& settings);

  private:
    RenderSettings settings_;
    std::unique_ptr<AbstractZoomAntialiasingStrategy> strategy_;
};

} // namespace irsg
