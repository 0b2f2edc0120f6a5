#pragma once

#include <cstddef>
#include <vector>

#include "irsg/gas/GasLayer.h"

namespace irsg {

/// What gas absorbs about 4.4 um where it is thin, per volume: only ratios count.
double thinAbsorption(const GasLayer& gas);

/// A small part of a plume.
struct PlumePart {
    GasLayer gas;
    double absorbs = 0.0; ///< thinAbsorption() times its volume
};

/// The gas of a plume from a temperature on, up to the next hotter one.
struct PlumeRun {
    GasLayer gas; ///< mean of its parts, weighted with what they emit and absorb
    double from_K = 0.0;
};

/// The gas of a plume in order of its temperature.
class GasByTemperature {
  public:
    /// Gas that has less than 1e-3 of emission and absorption, colder than all, is left out.
    /// InputError where nothing emits.
    explicit GasByTemperature(std::vector<PlumePart> parts);
    /// Runs, hottest first, at most `count` of them, in which temperatures differ least (W. D.
    /// Fisher 1958, J. Am. Stat. Assoc. 53, 789): as their roots above the coldest, for which zones
    /// of jets leave the least errors from all sides, parts counting half by emission and half by
    /// absorption. Parts of one temperature stay together. The last is from 0 K where nothing is
    /// left out.
    std::vector<PlumeRun> parted(std::size_t count) const;

    double coldest_K() const { return parts_.back().gas.temperature_K; }
    double hottest_K() const { return parts_.front().gas.temperature_K; }

  private:
    struct Part {
        GasLayer gas;
        double counts = 0.0; ///< of all parts 1: half by emission, half by absorption
    };
    GasLayer meanOf(std::size_t first, std::size_t end) const;
    std::vector<std::size_t> endsOf(std::size_t count) const;

    std::vector<Part> parts_; ///< hottest first
    bool isAll_ = true;       ///< nothing is left out
};

} // namespace irsg
