#pragma once

#include <memory>

#include "irsg/scene/RenderSettings.h"
#include "irsg/scene/sampling/AbstractZoomAntialiasingStrategy.h"

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
