#pragma once

#include <map>
#include <mutex>
#include <vector>

#include "irsg/radiance/SharedValues.h"

namespace irsg {

/// Planck radiance at the nodes of a scene, W m-2 sr-1 um-1, by temperature: series in the scale of
/// a temperature are fitted at the same temperatures in every view of a sweep. May be used by
/// several threads at a time.
class PlanckTable {
  public:
    /// They must live as long.
    explicit PlanckTable(const std::vector<double>& wavelengths_um)
        : wavelengths_um_(wavelengths_um) {}

    const std::vector<double>& wavelengths_um() const { return wavelengths_um_; }
    SharedValues at(double temperature_K);

  private:
    /// Numbers that are kept (64 MiB); before there are more, all are forgotten.
    static constexpr std::size_t mostCached = std::size_t{1} << 23;

    const std::vector<double>& wavelengths_um_;
    std::mutex mutex_;
    std::map<double, SharedValues> cache_;
};

} // namespace irsg
