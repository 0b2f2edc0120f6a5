#pragma once

#include <vector>

#include "irsg/render/sampling/DownsamplingPass.h"

namespace irsg {

/// A chain of averaging passes from one size of texture to a smaller one, 4x as often as it fits:
/// 512 to 2 is 4x, 4x, 4x, 4x (report section 6, phase 2).
class MultipassComposer {
  public:
    /// Both sides are powers of two, `to` not above `from`; LogicError otherwise.
    MultipassComposer(int from, int to);

    const std::vector<DownsamplingPass>& passes() const { return passes_; }
    ObjectTexture apply(ObjectTexture texture) const;

  private:
    std::vector<DownsamplingPass> passes_;
};

} // namespace irsg
