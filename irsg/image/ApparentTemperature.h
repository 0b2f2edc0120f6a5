#pragma once

#include <string>
#include <vector>

#include "irsg/image/RadianceImage.h"
#include "irsg/radiometry/Band.h"

namespace irsg {

/// The temperature of the black body with a given band radiance, by interpolation: 1/T over ln L in
/// cubic Hermite pieces, halved until every piece is right. At most 1e-4 K (2e-8 T above 5000 K)
/// from `irsg::apparentTemperature_K`, which it replaces where many values of one band are wanted.
class ApparentTemperatureTable {
  public:
    /// Covers the radiances from `min` to `max`, W m-2 sr-1; LogicError unless 0 < min <= max,
    /// both finite.
    ApparentTemperatureTable(const Band& band, double min_W_m2_sr, double max_W_m2_sr);

    /// K; NaN where there is no value: a radiance <= 0, not finite, or that no black body between
    /// 1 K and 1e6 K has. A radiance outside the table is solved for directly.
    double at(double radiance_W_m2_sr) const;

    std::size_t size() const { return nodes_.size(); }

  private:
    struct Node {
        double logRadiance; ///< ln L
        double inverse_1_K; ///< 1/T
        double slope;       ///< d(1/T) / d(ln L)
    };
    Node nodeAt(double inverse_1_K) const;
    double interpolate(const Node& low, const Node& high, double logRadiance) const;
    void refine(const Node& low, const Node& high, int depth);

    Band band_;
    std::vector<Node> nodes_; ///< ln L ascending
};

/// Name and attributes of the plane that addApparentTemperature makes.
inline const std::string apparentTemperatureChannel = "T_apparent";
inline const std::string apparentTemperatureBand = "apparentTemperature.band";
inline const std::string apparentTemperatureMissing = "apparentTemperature.pixelsWithoutValue";

/// Adds, or renews, the plane `T_apparent` in K: for each pixel of the shown plane (band radiance
/// in W m-2 sr-1) the temperature of the black body that is as bright in `band`, within 1e-4 K of
/// the exact solution before it is rounded to float; NaN where there is none. The attributes
/// `apparentTemperature.band` and `apparentTemperature.pixelsWithoutValue` say the band and count
/// the NaN. Returns that count. LogicError for an empty image.
std::size_t addApparentTemperature(RadianceImage& image, const Band& band);

} // namespace irsg
