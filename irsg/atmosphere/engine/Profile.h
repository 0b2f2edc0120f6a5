#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "irsg/atmosphere/engine/AtmosphericState.h"

namespace irsg {

/// The six model atmospheres (Anderson et al. 1986, AFGL-TR-86-0110), with MODTRAN's numbers.
enum class ModelAtmosphere {
    tropical = 1,
    midlatitudeSummer = 2,
    midlatitudeWinter = 3,
    subarcticSummer = 4,
    subarcticWinter = 5,
    usStandard1976 = 6
};

/// Weather measured near the ground (the report's MeteoModel 2).
struct SurfaceObservation {
    double height_m = 5.0;               ///< measurement height, 2 to 40
    double temperature_K = 293.15;       ///< at that height
    double pressure_hPa = 1013.0;        ///< at that height, 800 to 1200
    double relativeHumidity = 0.5;       ///< at that height over water, 0 to 1
    double temperatureAtZero_K = 293.15; ///< air at altitude 0
};

/// Air from the ground to the top of the atmosphere (100 km or the highest level given).
///
/// Between levels the temperature is linear in altitude, the logarithms of pressure and of the mole
/// fractions are linear in altitude (mole fractions of 0 are linear). Below the lowest level the
/// lowest holds; above the top there is nothing (see `top_m`).
class Profile {
  public:
    /// Levels ascending in altitude from 0, at least two, pressures falling, 100 to 400 K,
    /// fractions 0 to 1. Throws InputError naming each level that breaks a rule.
    explicit Profile(std::vector<AtmosphericState> levels, std::string name = "profile");

    /// `co2_ppmv` replaces the tables' 330 ppmv by scaling the whole CO2 profile.
    static Profile model(ModelAtmosphere model, double co2_ppmv = 400.0);

    /// A radiosonde ascent: CSV with the header `altitude [m], pressure [hPa], temperature [K] |
    /// temperature [C], relative_humidity [%] | dew_point [C] | h2o [ppmv]` in any order and
    /// optionally `co2 [ppmv]`, `o3 [ppmv]`, `n2o [ppmv]`, `co [ppmv]`, `ch4 [ppmv]`, `o2 [ppmv]`,
    /// `hno3 [ppmv]`. Humidity and dew point are over water. Altitudes of the file are above sea
    /// level, `ground_m` of it is altitude 0 of the result and of `background`; what lies below is
    /// cut off. The first altitude is at most 1000 m above the ground; below it the air is
    /// isothermal and hydrostatic. Above its last level the ascent is blended into `background`
    /// over 5 km (smooth step; the pressures there must agree within a fifth); gases that the file
    /// lacks are the background's. Throws InputError naming every diagnostic.
    static Profile fromRadiosonde(const std::filesystem::path& file, const Profile& background,
                                  double ground_m = 0.0);

    /// The same air above a ground that lies higher: its altitude 0 is `ground_m` of this.
    /// LogicError for a ground below 0 or not below the top.
    Profile withGroundAt(double ground_m) const;

    /// The same air with a gas multiplied by a factor of 0 or more at all altitudes. Water stays
    /// where it is at saturation or goes no farther. LogicError for a negative factor.
    Profile withScaled(Gas gas, double factor) const;

    /// The lowest kilometre reshaped to pass through the measurements, with x = (z - h) / (1 km -
    /// h) above the measurement height h and S(x) = x^2 (3 - 2 x):
    /// - temperature: the model's plus a monotone piecewise cubic (Fritsch and Butland 1984, SIAM
    /// J.
    ///   Sci. Stat. Comput. 5, 300) through the two measured differences and 0 with slope 0 at 1
    ///   km;
    /// - relative humidity: the measured one up to h, then S of the model's and 1 - S of the
    ///   measured one, so that it never leaves 0 to 1;
    /// - pressure: hydrostatic from the measured one; what is then missing at 1 km in the logarithm
    ///   is added as S(x), up to 0.05 (about 50 hPa, all of it in ordinary weather).
    /// From 1 km up temperature and mole fractions are unchanged and join with a continuous first
    /// derivative; so is pressure, except that a misfit above 0.05 remains as a constant factor
    /// (the ground then lies at another altitude than the model's). The profile has to reach 1 km.
    /// Throws InputError for values outside the ranges of SurfaceObservation, temperatures 213.15
    /// to 333.15 K. docs/atmosphere-profiles.md has the reasons.
    Profile adjustedToSurfaceObservation(const SurfaceObservation& measured) const;

    const std::string& name() const { return name_; }
    const std::vector<AtmosphericState>& levels() const { return levels_; }
    double top_m() const { return levels_.back().altitude_m; }
    /// Air at an altitude in m; held below the lowest level and above the top.
    AtmosphericState at(double altitude_m) const;

  private:
    std::vector<AtmosphericState> levels_;
    std::string name_;
};

/// Saturation vapour pressure over water, hPa (Murphy and Koop 2005, eq. 10; 123 to 332 K).
double saturationPressure_hPa(double temperature_K);
/// 0 to 1 and beyond; over water.
double relativeHumidity(const AtmosphericState& air);

} // namespace irsg
