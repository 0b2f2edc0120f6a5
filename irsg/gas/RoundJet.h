#pragma once

#include "irsg/gas/PlumeTable.h"

namespace irsg {

/// The exhaust of a fuel CnHm, burnt completely with more air than it needs, as a round turbulent
/// jet in air that is at rest or goes along with it.
struct RoundJet {
    double diameter_m = 0.3;      ///< of the nozzle
    double temperature_K = 800.0; ///< at the nozzle, static
    double velocity_m_s = 200.0;  ///< at the nozzle
    double air_K = 288.0;         ///< of the air about it, static
    double coflow_m_s = 0.0;      ///< of the air, along the jet; below the jet's velocity
    double pressure_atm = 1.0;
    double fuelAirRatio = 0.02;            ///< by mass
    double carbon = 12.0, hydrogen = 23.0; ///< atoms of the fuel: kerosene
    double airWater = 0.01;                ///< mole fraction of water in the air
    double airCO2 = 420e-6;
    double soot_ppmv = 0.0; ///< at the nozzle
    double endsAt = 0.06;   ///< the table ends where the axis has this part of the nozzle's gas

    /// Exhaust at the nozzle, of no length. InputError with every value that cannot be, such as
    /// more fuel than the air can burn, or that is outside GasLayerLimits.
    GasLayer nozzleGas() const;
    GasLayer air() const;
    /// A core of the nozzle's gas that ends after 5 D (T_air / T)^1/2, beyond which the part of it
    /// falls with the distance (C. J. Chen and W. Rodi 1980, Vertical Turbulent Buoyant Jets:
    /// mass fraction 5 and velocity 6.2 such diameters over the distance, squares of half widths as
    /// 0.11 to 0.086). Across it is a bell, as wide as keeps the flow of exhaust. Air that goes
    /// along with the part s of the velocity stretches all lengths by (1 + s) / (1 - s) (G. N.
    /// Abramovich 1963, The Theory of Turbulent Jets). Gas is that of ExhaustInAir.
    /// InputError for a table of more than 500 diameters.
    PlumeTable table() const;
};

/// Exhaust thinned by air: temperature and fractions follow the part of exhaust; of CO2 and water
/// it has what the exhaust holds more than the air, whose own gases the air of a scene has already.
class ExhaustInAir {
  public:
    /// Throws what RoundJet::nozzleGas() throws.
    explicit ExhaustInAir(const RoundJet& jet) : hot_(jet.nozzleGas()), cold_(jet.air()) {}
    /// `part`: 0 to 1.
    GasLayer at(double part) const;

  private:
    GasLayer hot_, cold_;
};

} // namespace irsg
