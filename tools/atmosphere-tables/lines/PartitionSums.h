#pragma once

#include <array>
#include <filesystem>
#include <vector>

#include "irsg/atmosphere/engine/AtmosphericState.h"

namespace irsg::lbl {

/// Total internal partition sums Q(T) of the isotopologues (TIPS-2017, Gamache et al. 2017, J.
/// Quant. Spectrosc. Radiat. Transfer 203, 70), linear between the table's temperatures.
class PartitionSums {
  public:
    /// Reads `tips_12_molecules.csv` from a folder: `temperature_K` and columns such as `H2O_1`.
    /// Throws InputError naming what is missing or wrong.
    static PartitionSums read(const std::filesystem::path& folder);
    /// Q ~ T^1.5 for every isotopologue, as of a rigid rotor: for tests.
    static PartitionSums rigidRotor();

    /// Q(296) / Q(T). Beyond the table's 1020 K the sums of H2O, CO2, CO and CH4 go on as those of
    /// a rigid rotor with harmonic vibrations, others straight: of CO2 1 percent low at 1500 K, 2
    /// at 2000 and 4 at 3000 against the sum over its levels. An isotopologue that the table does
    /// not have is taken as the first.
    double ratioTo296(Gas gas, int isotopologue, double temperature_K) const;

  private:
    std::vector<double> temperatures_K_;
    std::array<std::vector<std::vector<double>>, lineGasCount>
        sums_; ///< [gas][isotopologue - 1][T]
};

/// Molar mass, g/mol. An isotopologue beyond those known has the mass of the first.
double molarMass_g(Gas gas, int isotopologue);

} // namespace irsg::lbl
