#pragma once

#include <span>
#include <vector>

#include "tools/atmosphere-tables/lines/Line.h"
#include "tools/atmosphere-tables/lines/PartitionSums.h"

namespace irsg::lbl {

/// An even grid of wavenumbers.
struct WavenumberGrid {
    double first_per_cm = 0.0;
    double step_per_cm = 0.001;
    std::size_t count = 0;

    double at(std::size_t i) const { return first_per_cm + step_per_cm * static_cast<double>(i); }
    double last_per_cm() const { return at(count - 1); }
};

/// Shape of a gas's lines far from their centres.
struct LineShape {
    double cut_per_cm = 25.0; ///< nothing beyond; rays of light farther out are the continuum
    bool removePedestal =
        false; ///< subtract the value at the cut (water, as its continuum expects)
    /// Sub-Lorentzian wings of CO2 (Perrin and Hartmann 1989), which reach out to `cut_per_cm`.
    bool carbonDioxideWings = false;
};
/// Water: 25 cm-1, pedestal removed. CO2: chi factor, 300 cm-1. Others: 25 cm-1.
LineShape defaultLineShape(Gas gas);

/// Absorption cross section of one gas in air, cm2 per molecule of the gas, on every point of the
/// grid: Voigt lines at temperature (K), total pressure (hPa) and the gas's own mole fraction (for
/// self-broadening). Wings are evaluated on coarse grids and interpolated, to 1e-4 of the value;
/// the edge at the cut is blurred by some tenth of the cut. Lines whose peak is below `weakest_cm2`
/// are left out.
std::vector<double> crossSection_cm2(const LineList& lines, const PartitionSums& partition,
                                     const WavenumberGrid& grid, double temperature_K,
                                     double pressure_hPa, double moleFraction,
                                     const LineShape& shape, double weakest_cm2 = 0.0);

/// A line whose peak is below this, cm2 per molecule, changes no optical depth by more than 1e-5
/// over 200 km of the air that holds most of the gas.
double negligible_cm2(Gas gas);

/// chi(|distance|, T): how much weaker the wing of a CO2 line in air is than a Lorentzian. Perrin
/// and Hartmann 1989 (J. Quant. Spectrosc. Radiat. Transfer 42, 311) with their parameters of CO2
/// in N2, fitted beyond the head of the 4.3 um band; those of pure CO2 leave six times as much wing
/// at 10 cm-1.
double carbonDioxideChi(double distance_per_cm, double temperature_K);

} // namespace irsg::lbl
