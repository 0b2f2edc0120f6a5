#pragma once

#include "irsg/render/sampling/TileSamplingStrategy.h"

namespace irsg {

/// Modes 0 to 2 of the report: the same samples in every pixel that can see an object.
class SupersamplingStrategy : public TileSamplingStrategy {
  public:
    /// Samples of each pixel, 1 to 16 each way.
    SupersamplingStrategy(int samplesAcross, int samplesDown)
        : samplesAcross_(samplesAcross), samplesDown_(samplesDown) {}

    std::vector<SampleTile> tiles(const std::vector<ObjectExtent>& objects) const override;

  private:
    int samplesAcross_, samplesDown_;
};

} // namespace irsg
