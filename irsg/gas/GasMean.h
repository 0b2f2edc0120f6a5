#pragma once

#include "irsg/gas/GasLayer.h"

namespace irsg {

/// The weighted mean of states of gas.
class GasMean {
  public:
    GasMean() { sum_.temperature_K = sum_.pressure_atm = 0.0; }

    void add(const GasLayer& gas, double weight) {
        weight_ += weight;
        sum_.temperature_K += weight * gas.temperature_K;
        sum_.pressure_atm += weight * gas.pressure_atm;
        for (std::size_t g = 0; g < hotGasCount; ++g)
            sum_.moleFraction[g] += weight * gas.moleFraction[g];
        sum_.oxygenFraction += weight * gas.oxygenFraction;
        sum_.soot_ppmv += weight * gas.soot_ppmv;
    }
    double weight() const { return weight_; }
    /// Of no length. The weight must not be 0.
    GasLayer mean() const {
        GasLayer mean = sum_;
        for (double* value :
             {&mean.temperature_K, &mean.pressure_atm, &mean.oxygenFraction, &mean.soot_ppmv})
            *value /= weight_;
        for (double& fraction : mean.moleFraction)
            fraction /= weight_;
        return mean;
    }

  private:
    GasLayer sum_;
    double weight_ = 0.0;
};

} // namespace irsg
