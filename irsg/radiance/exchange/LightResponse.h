#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace irsg {

class ReceiverSums;
class SceneLight;
class SceneRadiometry;

/// Puts nodes together whose wavelengths lie within a part of each other.
struct WavelengthBins {
    WavelengthBins(std::span<const double> wavelengths_um, double part);
    std::vector<std::size_t> of; ///< by node
    std::size_t count = 0;
};

/// What receivers get more of each other where some surfaces reflect more, to the first order. With
/// G what falls on them, K = F (1 - rho F)^-1 what arrives of what is sent, and d the change of the
/// reflectivity of rows that change together, dG = K d G. It knows no view. In sub-bands a part of
/// 0.13 wide dG has the spectrum that G has on those rows on the whole; the change is small where
/// surfaces see little of each other, and exact where all of a row gets the same light.
class LightResponse {
  public:
    /// `reflectors`: sets of drawn rows; of nodes `first` to before `last`. `light` and
    /// `radiometry` must live as long.
    LightResponse(const SceneLight& light, const SceneRadiometry& radiometry,
                  std::vector<std::vector<int>> reflectors,
                  std::pair<std::size_t, std::size_t> nodes);

    /// Of what falls on a row, summed over its receivers as SceneLight::contracted: at a
    /// reflectivity of 1 more, by reflector and node, W m-2 um-1 times the unit of the sums.
    std::vector<std::vector<double>> of(int row, const ReceiverSums& sums, bool withCosine) const;

  private:
    const SceneLight& light_;
    const SceneRadiometry& radiometry_;
    std::vector<std::vector<int>> reflectors_;
    WavelengthBins subBands_;
    std::vector<std::vector<double>> shapes_um_; ///< by reflector and node: 1 over its sub-band
    std::vector<std::vector<float>> more_W_m2_;  ///< by sub-band: by receiver and reflector
};

} // namespace irsg
