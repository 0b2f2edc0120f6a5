#pragma once

#include <cstddef>
#include <vector>

namespace irsg {

/// A square picture of objects alone: premultiplied radiance, W m-2 sr-1, and opacity of each
/// texel, top row first.
struct ObjectTexture {
    int side = 0;
    std::vector<double> radiance, opacity;

    explicit ObjectTexture(int side_texels)
        : side(side_texels),
          radiance(static_cast<std::size_t>(side_texels) * static_cast<std::size_t>(side_texels)),
          opacity(radiance.size()) {}
    std::size_t offset(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(side) +
               static_cast<std::size_t>(column);
    }
};

/// Averages squares of texels: 2x takes 4 of them, 4x takes 16 (report section 6, phase 2).
class DownsamplingPass {
  public:
    /// LogicError for a factor other than 2 and 4.
    explicit DownsamplingPass(int factor);

    int factor() const { return factor_; }
    /// LogicError for a side that the factor does not divide.
    ObjectTexture apply(const ObjectTexture& texture) const;

  private:
    int factor_;
};

} // namespace irsg
