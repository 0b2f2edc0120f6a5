#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "irsg/gas/GasLayer.h"
#include "irsg/gas/GasOptics.h"

namespace irsg {

/// A part of a line of sight in one of several uniform gases.
struct GasStretch {
    std::size_t gas = 0;
    double length_m = 0.0;
};

/// What several uniform gases do to any line of sight through them, on a list of wavenumbers: what
/// of it does not depend on lengths is computed once. The numbers are those of gasSpectrum() at the
/// middles of cells of 5 cm-1.
class GasColumns {
  public:
    /// Lengths in `gases` do not count. `wavenumbers_per_cm`: any. Throws InputError for gases out
    /// of their limits, and for tables that are missing.
    GasColumns(const std::vector<GasLayer>& gases, std::vector<double> wavenumbers_per_cm);

    const std::vector<double>& wavenumbers_per_cm() const { return wavenumbers_per_cm_; }
    std::size_t gases() const { return gases_.size(); }

    /// What of the light at the sensor each gas takes away in stretches from `first` on, those
    /// nearest the sensor first in the list: sum of tau_(i-1) - tau_i over its stretches, by gas
    /// and wavenumber. With all stretches they add up to 1 less the transmittance.
    std::vector<std::vector<double>> shares(std::span<const GasStretch> column,
                                            std::size_t first = 0) const;

    /// The sum of the shares of all stretches, each times `weights[place * gases() + gas]`: what
    /// they send, where that is the radiance of the gas as a black body over a cell about the
    /// place.
    double weighted(std::span<const GasStretch> column, std::span<const double> weights) const;

  private:
    /// Calls take(gas, place, share) for each stretch from `first` on.
    template <typename Take>
    void walk(std::span<const GasStretch> column, std::size_t first, const Take& take) const;
    /// One gas of one of the mixtures at one wavenumber, per metre.
    struct PerMetre {
        double depth = 0.0, byCollision = 0.0, byDoppler = 0.0;
    };
    const PerMetre& perMetre(std::size_t gas, std::size_t emitter, std::size_t place) const {
        return perMetre_[(place * gases_.size() + gas) * hotGasCount + emitter];
    }

    std::vector<GasLayer> gases_;
    std::vector<double> wavenumbers_per_cm_;
    std::vector<PerMetre> perMetre_;                         ///< by place, gas and emitter
    std::vector<std::array<StrengthLaw, hotGasCount>> laws_; ///< by place
    std::vector<double> soot_per_m_;                         ///< by place and gas
};

} // namespace irsg
