#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "irsg/atmosphere/engine/EvenTable.h"
#include "irsg/gas/GasLayer.h"
#include "irsg/gas/NarrowBand.h"

namespace irsg {

/// Mean absorption coefficient and line spacing of one gas over wavenumber and temperature: one of
/// resources/atmosphere/hotgas-*.csv.
class NarrowBandTable {
  public:
    /// Columns `k_T [cm-1 atm-1]` and `inverse_spacing_T [cm]` of each temperature T, behind
    /// `wavenumber [cm-1]`; the comment lines `# gas`, `# law` (goody or malkmus),
    /// `# between temperatures` (straight, or boltzmann: logarithms are linear in 1/T) and
    /// `# temperatures` (K, ascending, apart by blanks). Throws InputError naming what is missing
    /// or wrong.
    static NarrowBandTable read(const std::filesystem::path& file);

    HotGas gas() const { return gas_; }
    StrengthLaw law() const { return law_; }
    const std::string& source() const { return source_; } ///< its comment `# source`
    double lower_per_cm() const { return table_.lower_per_cm(); }
    double upper_per_cm() const { return table_.upper_per_cm(); }
    double coldest_K() const { return temperatures_K_.front(); }
    double hottest_K() const { return temperatures_K_.back(); }

    struct Values {
        double k_per_cm_atm = 0.0; ///< at 273 K and 1 atm of the gas
        double inverseSpacing_cm = 0.0;
    };
    /// Linear in wavenumber; the temperature is clamped to the table's, nothing
    /// absorbs outside its wavenumbers.
    Values at(double wavenumber_per_cm, double temperature_K) const;

  private:
    NarrowBandTable(HotGas gas, StrengthLaw law, bool isByBoltzmann, std::string source,
                    std::vector<double> temperatures_K, EvenTable table)
        : gas_(gas),
          law_(law),
          isByBoltzmann_(isByBoltzmann),
          source_(std::move(source)),
          temperatures_K_(std::move(temperatures_K)),
          table_(std::move(table)) {}

    HotGas gas_;
    StrengthLaw law_;
    bool isByBoltzmann_; ///< between temperatures
    std::string source_;
    std::vector<double> temperatures_K_;
    EvenTable table_; ///< k of each temperature, then the inverse spacings
};

/// Half width at half maximum, cm-1, of a gas's lines in a layer: sum of gamma_j p_j
/// sqrt(273 K/T) over all that is in it, and the resonant part of the gas itself with 273 K/T (NIST
/// TN 1402, from NASA SP-3080; methane as in the mean of its lines).
double collisionHalfWidth_per_cm(HotGas gas, const GasLayer& layer);
/// 1/e half width, cm-1, of Doppler broadening as NIST TN 1402 has it:
/// 5.94e-6 nu sqrt(T / (273 K M)).
double dopplerHalfWidth_per_cm(HotGas gas, double wavenumber_per_cm, double temperature_K);

/// What one gas of a layer contributes to a NarrowBandSum at a wavenumber.
NarrowBandLayer narrowBandLayer(const NarrowBandTable& table, const GasLayer& layer,
                                double collisionHalfWidth_per_cm, double wavenumber_per_cm);

} // namespace irsg
