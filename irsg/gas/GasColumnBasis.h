#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "irsg/core/LeastSquares.h"
#include "irsg/gas/GasColumn.h"

namespace irsg {

/// A line of sight through uniform gases: its stretches in order from the sensor.
using GasLine = std::vector<GasStretch>;

/// Few lines of sight through some gases, the columns, whose weighted sums stand for all others:
/// what a line emits and lets through is nearly the same weighted sum of what the columns do, at
/// all wavenumbers. The weights follow from the emission and transmittance of the line in gases
/// that are monochromatic and of many strengths, of which narrow bands are mixtures: their linear
/// map to weights is fitted to typical lines. They are smooth in all lengths, and 0 for no gas.
/// Columns are the pivots of an interpolative decomposition (H. Cheng et al. 2005, SIAM J. Sci.
/// Comput. 26, 1389).
class GasColumnBasis {
  public:
    /// Lengths in `gases` do not count. `wavenumbers_per_cm`: where lines are compared, each alike.
    /// `lines`: typical ones, of which every sixth is kept out of the fit. Throws as GasColumns.
    GasColumnBasis(const std::vector<GasLayer>& gases,
                   const std::vector<double>& wavenumbers_per_cm,
                   const std::vector<GasLine>& lines);

    const std::vector<GasLine>& columns() const { return columns_; }
    /// Columns whose weighted sums stand for what all columns let through.
    struct Fronts {
        std::vector<std::size_t> columns; ///< by number
        /// By value of a line and front.
        std::vector<double> map;

        /// By front, of the values of a line; no gas has the rest.
        void weightsOf(std::span<const double> values, std::span<double> weights) const;
    };
    /// Of surfaces behind the gas: within 0.02 % of 1, rms over wavenumbers, or 14 of them.
    const Fronts& fronts() const { return fronts_; }
    /// The first 10 of them at most, for what those surfaces reflect of others, which costs most.
    /// Fewer would show: surfaces of the gas's temperature would not be black any more.
    const Fronts& reflectionFronts() const { return reflectionFronts_; }

    /// What the lines that were kept out emit as weighted sums, compared with themselves: over all
    /// wavenumbers, relative to the mean of their radiances. Of no lines 0.
    struct Error {
        double mean = 0.0, rms = 0.0;
    };
    const Error& error() const { return error_; }

    /// A line of sight as far as it was followed.
    class Line {
      public:
        explicit Line(const GasColumnBasis& basis)
            : basis_(&basis), passes_(basis.strengths(), 1.0), emits_(basis.strengths(), 0.0) {}
        void clear();
        void add(std::size_t gas, double length_m);
        /// What it emits and what it stops, by strength: as many as valuesOfLine(). Weights are
        /// linear in them, so that they may be summed over lines.
        void fillValues(std::span<double> values) const;

      private:
        friend class GasColumnBasis;
        const GasColumnBasis* basis_;
        std::vector<double> passes_, emits_; ///< by strength
    };
    std::size_t valuesOfLine() const { return 2 * strengths(); }
    /// By column, of the values of a line; what their sum lacks to 1 is the weight of no gas.
    void weightsOf(std::span<const double> values, std::span<double> weights) const;
    void weightsOf(const Line& line, std::span<double> weights) const;

  private:
    class Fit;
    std::size_t strengths() const { return perGas_ == 0 ? 0 : absorption_per_m_.size() / perGas_; }
    Line follow(const GasLine& line) const;
    void take(const Fit& fit);
    /// Of columns, by what each stops at each wavenumber, the strongest first. After map_.
    Fronts frontsOf(const std::vector<std::vector<double>>& stopped, std::size_t most,
                    double closest) const;

    std::vector<GasLine> columns_;
    Fronts fronts_, reflectionFronts_;
    std::size_t perGas_ = 0; ///< number of gases
    /// By gas and strength; emission as a part of that of the hottest gas.
    std::vector<double> absorption_per_m_, emission_;
    std::vector<double> map_; ///< by strength, first of emission, then of what is stopped; column
    Error error_;
};

} // namespace irsg
