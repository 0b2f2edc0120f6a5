#include <cmath>
#include <filesystem>
#include <fstream>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "irsg/atmosphere/engine/Continuum.h"
#include "irsg/atmosphere/engine/EvenTable.h"
#include "irsg/atmosphere/engine/Profile.h"
#include "irsg/atmosphere/engine/ResourceFile.h"
#include "irsg/core/CsvTable.h"
#include "irsg/core/Errors.h"
#include "tests/support/TemporaryFolder.h"

namespace irsg {
namespace {

AtmosphericState air(double pressure_hPa, double temperature_K, double water) {
    AtmosphericState state = Profile::model(ModelAtmosphere::usStandard1976).at(0.0);
    state.pressure_hPa = pressure_hPa;
    state.temperature_K = temperature_K;
    state.moleFraction[0] = water;
    return state;
}

TEST(Continuum, OfWaterGrowsWithTheSquareOfWaterOrWithWaterTimesAir) {
    const AtmosphericState dry = air(1000.0, 290.0, 0.005), moist = air(1000.0, 290.0, 0.02);
    for (const double nu : {900.0, 1150.0, 2600.0, 4500.0}) {
        EXPECT_NEAR(continuumAbsorption_per_m(Continuum::waterSelf, moist, nu) /
                        continuumAbsorption_per_m(Continuum::waterSelf, dry, nu),
                    16.0, 1e-9);
        EXPECT_NEAR(continuumAbsorption_per_m(Continuum::waterForeign, moist, nu) /
                        continuumAbsorption_per_m(Continuum::waterForeign, dry, nu),
                    4.0 * 0.98 / 0.995, 1e-9);
    }
}

TEST(Continuum, OfWaterWeakensAsAirWarms) {
    for (const double nu : {900.0, 2500.0}) {
        // At the same density of water.
        const double cold = continuumAbsorption_per_m(Continuum::waterSelf,
                                                      air(1000.0 * 260.0 / 296.0, 260.0, 0.01), nu);
        const double warm =
            continuumAbsorption_per_m(Continuum::waterSelf, air(1000.0, 296.0, 0.01), nu);
        EXPECT_GT(cold, 1.3 * warm);
        EXPECT_LT(cold, 3.0 * warm);
    }
}

TEST(Continuum, OfWaterIsThatOfThePublishedFitInTheTenMicrometreWindow) {
    // Roberts, Selby and Biberman 1976 (Appl. Opt. 15, 2085), self part at 296 K: 4.18 + 5577.8
    // exp(-7.87e-3 v) cm2 per gram and atmosphere of water.
    const AtmosphericState moist = air(1013.25, 296.0, 0.02);
    const double grams_per_cm3 = moist.density_per_m3(Gas::H2O) * 1e-6 * 18.015 / 6.02214e23;
    for (const double nu : {750.0, 850.0, 950.0, 1000.0}) {
        const double published_per_m =
            100.0 * (4.18 + 5577.8 * std::exp(-7.87e-3 * nu)) * grams_per_cm3 * 0.02;
        EXPECT_NEAR(continuumAbsorption_per_m(Continuum::waterSelf, moist, nu) / published_per_m,
                    1.0, 0.15)
            << nu;
    }
}

/// The unit of the table's header, worked by hand from one of its rows.
TEST(Continuum, OfWaterFollowsTheUnitsOfItsTable) {
    const CsvTable table = CsvTable::read(atmosphereResource("continuum-water.csv"));
    std::vector<Diagnostic> diagnostics;
    for (const CsvRow& row : table.rows()) {
        if (row.cells[0].text != "1000") {
            continue;
        }
        const double self = table.number(row.cells[1], diagnostics).value_or(0.0);
        const double foreign = table.number(row.cells[3], diagnostics).value_or(0.0);
        // 1013.25 hPa and 296 K: 2.4794e19 molecules cm-3, a tenth of them water.
        const double water = 2.4794e18, radiation = 1000.0 * std::tanh(1.438777 * 1000.0 / 592.0);
        const AtmosphericState moist = air(1013.25, 296.0, 0.1);
        EXPECT_NEAR(continuumAbsorption_per_m(Continuum::waterSelf, moist, 1000.0) /
                        (100.0 * self * 1e-20 * water * radiation * 0.1),
                    1.0, 1e-4);
        EXPECT_NEAR(continuumAbsorption_per_m(Continuum::waterForeign, moist, 1000.0) /
                        (100.0 * foreign * 1e-20 * water * radiation * 0.9),
                    1.0, 1e-4);
        return;
    }
    FAIL() << "no row of 1000 cm-1";
}

TEST(Continuum, OfNitrogenAbsorbsHalfOfTheLightOverFiveKilometres) {
    // The published MODTRAN run gives 0.539 at 2332 cm-1, 5 km of tropical air at the ground.
    const AtmosphericState tropical = Profile::model(ModelAtmosphere::tropical).at(0.0);
    const double depth = 5000.0 * continuumAbsorption_per_m(Continuum::nitrogen, tropical, 2332.0);
    EXPECT_NEAR(std::exp(-depth), 0.539, 0.02);
    EXPECT_EQ(continuumAbsorption_per_m(Continuum::nitrogen, tropical, 1500.0), 0.0);
}

TEST(Continuum, OfNitrogenAndOxygenGrowsWithTheSquareOfTheDensityOfAir) {
    const AtmosphericState thin = air(500.0, 280.0, 0.0), dense = air(1000.0, 280.0, 0.0);
    for (const double nu : {250.0, 2332.0}) {
        EXPECT_NEAR(continuumAbsorption_per_m(Continuum::nitrogen, dense, nu) /
                        continuumAbsorption_per_m(Continuum::nitrogen, thin, nu),
                    4.0, 1e-9);
    }
    for (const double nu : {1552.0, 7890.0, 9400.0, 17320.0}) {
        EXPECT_NEAR(continuumAbsorption_per_m(Continuum::oxygen, dense, nu) /
                        continuumAbsorption_per_m(Continuum::oxygen, thin, nu),
                    4.0, 1e-9);
    }
}

TEST(Continuum, OfOxygenHasItsPublishedStrengths) {
    const AtmosphericState state = air(1013.25, 273.15, 0.0); // one amagat
    // Mate et al. 1999 at 1.27 um, cm-2 amagat-2: 3.499e-4 with oxygen, 0.679e-4 with nitrogen.
    double integral = 0.0;
    for (double nu = 7545.0; nu < 8500.0; nu += 10.0) {
        integral += 0.01 * continuumAbsorption_per_m(Continuum::oxygen, state, nu) * 10.0;
    }
    EXPECT_NEAR(integral / (0.2095 * (0.2095 * 3.499e-4 + 0.7808 * 0.679e-4)), 1.0, 0.06);
    // Greenblatt et al. 1990: peaks of oxygen pairs, 1e-46 cm5.
    for (const auto& [nu, peak] : {std::pair{17325.0, 11.0}, {20965.0, 6.3}, {15873.0, 7.2}}) {
        const double oxygen_per_cm3 = state.density_per_m3(Gas::O2) * 1e-6;
        EXPECT_NEAR(0.01 * continuumAbsorption_per_m(Continuum::oxygen, state, nu) /
                        (oxygen_per_cm3 * oxygen_per_cm3) * 1e46,
                    peak, 0.1 * peak)
            << nu;
    }
    // The Herzberg continuum without collisions: 1.01e-24 cm2 at 240 nm.
    const AtmosphericState thin = air(0.1, 273.15, 0.0);
    EXPECT_NEAR(0.01 * continuumAbsorption_per_m(Continuum::oxygen, thin, 1e7 / 240.0) /
                    (thin.density_per_m3(Gas::O2) * 1e-6),
                1.01e-24, 0.03e-24);
}

TEST(Continuum, HasNoStepsLargerThanATenThousandthOverFiveKilometres) {
    // Half a wavenumber from any table's end, and where one table takes over from another.
    const AtmosphericState tropical = Profile::model(ModelAtmosphere::tropical).at(0.0);
    for (const double end : {550.0,   845.0,   1395.0,  1740.0,  1760.0,  2010.0,  2720.0,
                             7540.0,  10000.0, 13000.0, 15300.0, 15780.0, 15990.0, 20000.0,
                             24000.0, 27370.0, 30000.0, 36000.0, 40000.0, 40800.0}) {
        for (std::size_t i = 0; i < continuumCount; ++i) {
            const auto which = static_cast<Continuum>(i);
            const double below = 5e3 * continuumAbsorption_per_m(which, tropical, end - 1e-6 * end),
                         above = 5e3 * continuumAbsorption_per_m(which, tropical, end + 1e-6 * end);
            // The two tables of ozone differ by 0.7 % where they meet.
            EXPECT_NEAR(std::exp(-below), std::exp(-above), end == 40800.0 ? 1e-3 : 1e-4)
                << continuumNames[i] << " at " << end;
        }
    }
}

TEST(Continuum, IsHeldBeyondItsTemperatures) {
    for (const double nu : {250.0, 900.0, 1552.0, 2332.0, 33000.0}) {
        for (std::size_t i = 0; i < continuumCount; ++i) {
            // The same density of all molecules, so that only the coefficient could differ.
            const auto which = static_cast<Continuum>(i);
            const auto at = [&](double temperature_K) {
                AtmosphericState state = air(500.0 * temperature_K / 300.0, temperature_K, 0.01);
                return continuumAbsorption_per_m(which, state, nu);
            };
            if (which == Continuum::oxygen && nu < 2000.0) {
                continue; // goes with pressure
            }
            EXPECT_NEAR(at(120.0), at(150.0), 1e-12 * at(150.0)) << continuumNames[i] << nu;
            EXPECT_NEAR(at(400.0), at(350.0), 1e-12 * at(350.0)) << continuumNames[i] << nu;
        }
    }
}

TEST(Continuum, OfOzoneIsItsCrossSectionTimesItsDensity) {
    AtmosphericState state = air(20.0, 273.15, 0.0);
    state.moleFraction[static_cast<std::size_t>(Gas::O3)] = 8e-6;
    // 1.1e-17 cm2 near 39000 cm-1, the top of the Hartley band.
    const double cross_cm2 = continuumAbsorption_per_m(Continuum::ozone, state, 39300.0) * 0.01 /
                             (state.density_per_m3(Gas::O3) * 1e-6);
    EXPECT_NEAR(cross_cm2, 1.15e-17, 0.1e-17);
    EXPECT_EQ(continuumAbsorption_per_m(Continuum::ozone, state, 5000.0), 0.0);
}

TEST(Continuum, IsNothingWithoutItsGasAndOutsideItsRange) {
    AtmosphericState nothing = air(1000.0, 290.0, 0.0);
    nothing.moleFraction.fill(0.0);
    for (const double nu : {300.0, 900.0, 1500.0, 2600.0, 15000.0, 40000.0}) {
        for (const Continuum which : {Continuum::waterSelf, Continuum::waterForeign,
                                      Continuum::oxygen, Continuum::ozone, Continuum::nitricAcid}) {
            EXPECT_EQ(continuumAbsorption_per_m(which, nothing, nu), 0.0) << nu;
        }
    }
    const AtmosphericState moist = air(1000.0, 290.0, 0.02);
    for (const double nu : {100.0, 60000.0, -1.0}) {
        EXPECT_EQ(continuumAbsorption_per_m(moist, nu), 0.0);
    }
}

TEST(Continuum, IsNeverNegativeWhateverTheAir) {
    for (const double temperature_K : {100.0, 180.0, 250.0, 330.0, 500.0}) {
        for (double nu = 200.0; nu < 50000.0; nu *= 1.013) {
            EXPECT_GE(continuumAbsorption_per_m(air(500.0, temperature_K, 0.01), nu), 0.0) << nu;
        }
    }
}

TEST(ContinuumSpectrum, IsTheSumOfTheContinuaAtEveryWavenumber) {
    std::vector<double> wavenumbers_per_cm;
    for (double nu = 150.0; nu < 52000.0; nu *= 1.0091) {
        wavenumbers_per_cm.push_back(nu);
    }
    const ContinuumSpectrum spectrum(wavenumbers_per_cm);
    for (const AtmosphericState& state : {air(1000.0, 300.0, 0.03), air(200.0, 215.0, 1e-5),
                                          air(0.1, 100.0, 0.0), air(1100.0, 400.0, 0.1)}) {
        std::vector<double> found(wavenumbers_per_cm.size(), -1.0);
        spectrum.absorption_per_m(state, found);
        for (std::size_t i = 0; i < found.size(); ++i) {
            const double expected = continuumAbsorption_per_m(state, wavenumbers_per_cm[i]);
            EXPECT_NEAR(found[i], expected, 1e-13 * expected) << wavenumbers_per_cm[i];
        }
    }
}

TEST(Rayleigh, AgreesWithThePublishedCrossSection) {
    // Bodhaine et al. 1999, equation 29, 1e-28 cm2, air of 360 ppm CO2.
    const AtmosphericState state = air(1013.25, 288.15, 0.0);
    for (const auto& [wavelength_um, part] :
         {std::pair{0.25, 0.013}, {0.3, 0.006}, {0.55, 0.001}, {1.0, 0.001}}) {
        const double square = wavelength_um * wavelength_um;
        const double published_cm2 = 1e-28 *
                                     (1.0455996 - 341.29061 / square - 0.90230850 * square) /
                                     (1.0 + 0.0027059889 / square - 85.968563 * square);
        EXPECT_NEAR(0.01 * rayleighScattering_per_m(state, 1e4 / wavelength_um) /
                        (state.airDensity_per_m3() * 1e-6 * published_cm2),
                    1.0, part)
            << wavelength_um;
    }
}

TEST(Rayleigh, AgreesWithThePublishedOpticalDepthOfTheAtmosphere) {
    // Bodhaine et al. 1999, table 3: 0.0973 at 0.55 um for the whole standard atmosphere.
    const Profile profile = Profile::model(ModelAtmosphere::usStandard1976);
    double depth = 0.0;
    for (double z = 50.0; z < 90000.0; z += 100.0) {
        depth += 100.0 * rayleighScattering_per_m(profile.at(z), 1e4 / 0.55);
    }
    EXPECT_NEAR(depth, 0.0973, 0.001);
}

struct BadTable {
    const char* name;
    const char* text;
    const char* expected;
};
void PrintTo(const BadTable& row, std::ostream* out) {
    *out << row.name;
}

class BadEvenTable : public testing::TestWithParam<BadTable> {};

TEST_P(BadEvenTable, IsRefusedByName) {
    const auto file = smat::test::writtenFile(smat::test::ownFolder() / "bad.csv", GetParam().text);
    try {
        (void)EvenTable::read(file, {"k"});
        FAIL() << "it was read";
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find(GetParam().expected), std::string::npos)
            << error.what();
        EXPECT_NE(std::string(error.what()).find(file.filename().string()), std::string::npos);
    }
}

INSTANTIATE_TEST_SUITE_P(
    Tables, BadEvenTable,
    testing::Values(BadTable{"empty", "# nothing\n", "0 rows"},
                    BadTable{"otherColumn", "wavenumber [cm-1],x\n1,2\n2,3\n", "k as column 2"},
                    BadTable{"noNumber", "wavenumber [cm-1],k\n1,2\n2,x\n", "line 3, column 2"},
                    BadTable{"short", "wavenumber [cm-1],k\n1,2\n2\n", "1 cells"},
                    BadTable{"uneven", "wavenumber [cm-1],k\n1,2\n2,3\n4,5\n", "even steps"},
                    BadTable{"falling", "wavenumber [cm-1],k\n2,2\n1,3\n", "ascending"}),
    [](const auto& info) { return std::string(info.param.name); });

} // namespace
} // namespace irsg
