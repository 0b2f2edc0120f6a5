#pragma once

#include <vector>

#include "irsg/atmosphere/engine/Profile.h"
#include "irsg/atmosphere/engine/RayPath.h"
#include "tools/atmosphere-tables/lines/LineAbsorption.h"
#include "tools/atmosphere-tables/lines/PartitionSums.h"

namespace irsg::lbl {

/// The truth that the spectral mode is held to: a column of molecular air whose extinction is known
/// line by line at every level of a grid of altitudes, without tables between, and linear in
/// altitude in between. Nothing scatters.
class LineByLineColumn {
  public:
    /// Absorption of all gases and continua from `lower_per_cm` to `upper_per_cm` in steps of
    /// `step_per_cm` (which divides 1 cm-1) at every altitude of `levels_m` (ascending from 0).
    /// Takes seconds to minutes and (levels x points) floats.
    LineByLineColumn(const std::vector<LineList>& gases, const PartitionSums& partition,
                     const Profile& profile, std::vector<double> levels_m, double lower_per_cm,
                     double upper_per_cm, double step_per_cm);

    const std::vector<double>& levels_m() const { return levels_m_; }

    struct Means {
        std::vector<double> transmittance;
        std::vector<double>
            radiance_W_m2_sr_per_cm; ///< emitted by the path towards the sensor, per cm-1
    };
    /// Means over bins of `width_per_cm` from the lower end, along a ray that was cut at the same
    /// levels.
    Means along(const RayPath& ray, double width_per_cm) const;

  private:
    Profile profile_;
    std::vector<double> levels_m_;
    WavenumberGrid grid_;
    std::vector<std::vector<float>> extinction_per_m_; ///< [level][point]
};

} // namespace irsg::lbl
