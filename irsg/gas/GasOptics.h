#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "irsg/gas/GasLayer.h"
#include "irsg/gas/NarrowBandTable.h"

namespace irsg {

/// Whose numbers say how a gas absorbs.
enum class GasSource {
    automatic, ///< lines where their tables reach, RADCAL beyond
    lines,     ///< narrow-band tables fitted to line by line: Malkmus' law
    radcal     ///< narrow-band tables of RADCAL (NIST TN 1402): Goody's law
};
inline constexpr std::array<const char*, 3> gasSourceNames = {"auto", "lines", "radcal"};

/// A table with the word of its source.
struct GasTableOfSource {
    GasSource source = GasSource::radcal; ///< never automatic
    std::shared_ptr<const NarrowBandTable> table;
};

/// Which sources answer for a gas.
struct GasAnswer {
    GasTableOfSource first;
    GasTableOfSource beyond; ///< at wavenumbers that the first does not reach; may have no table

    /// The one that answers at a wavenumber.
    const GasTableOfSource& at(double wavenumber_per_cm) const;
};

/// The answers of all gases out of the shipped tables, which are read once a process. RADCAL has no
/// table of methane: lines answer for it. Throws InputError where a table is missing or damaged.
using GasAnswers = std::array<GasAnswer, hotGasCount>;
GasAnswers gasAnswers(GasSource source);

/// "lines: ..." with the origin of each table.
std::string describe(const GasAnswer& answer);

/// Stated error of what a gas adds to a radiance, relative, by source, wavenumber and temperature:
/// what comparisons with better data have shown (docs/gas.md), at most 1.
double statedGasError(const GasTableOfSource& answer, HotGas gas, double wavenumber_per_cm,
                      double temperature_K);
/// The same of soot, whose index differs between fuels.
inline constexpr double statedSootError = 0.2;

} // namespace irsg
