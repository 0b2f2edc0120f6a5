#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "irsg/atmosphere/engine/Continuum.h"
#include "irsg/atmosphere/engine/EvenTable.h"
#include "irsg/atmosphere/engine/Profile.h"
#include "irsg/atmosphere/engine/SolarSpectrum.h"
#include "irsg/radiometry/CsvTable.h"
#include "irsg/radiometry/Errors.h"
#include "tests/atmosphere/SharedMaterial.h"

namespace irsg {
namespace {

AirState air(double pressure_hPa, double temperature_K, double water) {
    AirState state = Profile::model(ModelAtmosphere::usStandard1976).at(0.0);
    state.pressure_hPa = pressure_hPa;
    state.temperature_K = temperature_K;
    state.moleFraction[0] = water;
    return state;
}

TEST(Continuum, ofWaterGrowsWithTheSquareOfWaterOrWithWaterTimesAir) {
    const AirState dry = air(1000.0, 290.0, 0.005), moist = air(1000.0, 290.0, 0.02);
    for (const double nu : {900.0, 1150.0, 2600.0, 4500.0}) {
        EXPECT_NEAR(continuumAbsorption_per_m(Continuum::waterSelf, moist, nu) /
                        continuumAbsorption_per_m(Continuum::waterSelf, dry, nu),
                    16.0, 1e-9);
        EXPECT_NEAR(continuumAbsorption_per_m(Continuum::waterForeign, moist, nu) /
                        continuumAbsorption_per_m(Continuum::waterForeign, dry, nu),
                    4.0 * 0.98 / 0.995, 1e-9);
    }
}

TEST(Continuum, ofWaterWeakensAsAirWarms) {
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

TEST(Continuum, ofNitrogenAbsorbsHalfOfTheLightOverFiveKilometres) {
    // The published MODTRAN run gives 0.539 at 2332 cm-1, 5 km of tropical air at the ground.
    const AirState tropical = Profile::model(ModelAtmosphere::tropical).at(0.0);
    const double depth = 5000.0 * continuumAbsorption_per_m(Continuum::nitrogen, tropical, 2332.0);
    EXPECT_NEAR(std::exp(-depth), 0.539, 0.02);
    EXPECT_EQ(continuumAbsorption_per_m(Continuum::nitrogen, tropical, 1500.0), 0.0);
}

TEST(Continuum, ofOzoneIsItsCrossSectionTimesItsDensity) {
    AirState state = air(20.0, 273.15, 0.0);
    state.moleFraction[static_cast<std::size_t>(Gas::O3)] = 8e-6;
    // 1.1e-17 cm2 near 39000 cm-1, the top of the Hartley band.
    const double cross_cm2 = continuumAbsorption_per_m(Continuum::ozone, state, 39300.0) * 0.01 /
                             (state.density_per_m3(Gas::O3) * 1e-6);
    EXPECT_NEAR(cross_cm2, 1.15e-17, 0.1e-17);
    EXPECT_EQ(continuumAbsorption_per_m(Continuum::ozone, state, 5000.0), 0.0);
}

TEST(Continuum, isNothingWithoutItsGasAndOutsideItsRange) {
    AirState nothing = air(1000.0, 290.0, 0.0);
    nothing.moleFraction.fill(0.0);
    for (const double nu : {300.0, 900.0, 1500.0, 2600.0, 15000.0, 40000.0})
        for (const Continuum which : {Continuum::waterSelf, Continuum::waterForeign,
                                      Continuum::oxygen, Continuum::ozone, Continuum::nitricAcid})
            EXPECT_EQ(continuumAbsorption_per_m(which, nothing, nu), 0.0) << nu;
    const AirState moist = air(1000.0, 290.0, 0.02);
    for (const double nu : {100.0, 60000.0, -1.0})
        EXPECT_EQ(continuumAbsorption_per_m(moist, nu), 0.0);
}

TEST(Continuum, isNeverNegativeWhateverTheAir) {
    for (const double temperature_K : {100.0, 180.0, 250.0, 330.0, 500.0})
        for (double nu = 200.0; nu < 50000.0; nu *= 1.013)
            EXPECT_GE(continuumAbsorption_per_m(air(500.0, temperature_K, 0.01), nu), 0.0) << nu;
}

TEST(Rayleigh, agreesWithThePublishedOpticalDepthOfTheAtmosphere) {
    // Bodhaine et al. 1999, table 3: 0.0973 at 0.55 um for the whole standard atmosphere.
    const Profile profile = Profile::model(ModelAtmosphere::usStandard1976);
    double depth = 0.0;
    for (double z = 50.0; z < 90000.0; z += 100.0)
        depth += 100.0 * rayleighScattering_per_m(profile.at(z), 1e4 / 0.55);
    EXPECT_NEAR(depth, 0.0973, 0.001);
}

TEST(SolarSpectrum, holdsTheSolarConstantAndAddsUp) {
    const double whole = solarIrradiance_W_m2_per_cm(250.0, 50000.0) * 49750.0;
    EXPECT_NEAR(whole, 1368.0, 1.0);
    const double left = solarIrradiance_W_m2_per_cm(2000.3, 2511.7) * 511.4;
    const double right = solarIrradiance_W_m2_per_cm(2511.7, 3333.9) * 822.2;
    EXPECT_NEAR(solarIrradiance_W_m2_per_cm(2000.3, 3333.9) * 1333.6, left + right, 1e-9);
    EXPECT_NEAR(solarIrradiance_W_m2_per_cm(2000.0, 1e4 / 3.0) * (1e4 / 3.0 - 2000.0), 21.07, 0.1);
    EXPECT_THROW((void)solarIrradiance_W_m2_per_cm(2000.0, 2000.0), LogicError);
}

TEST(Continuum, ofWaterGivesThePublishedTransmittance) {
    const auto file = sharedMaterial("data/atmosphere/modtran/pyradi/horizon5kmtropical.fl7");
    if (file.empty())
        GTEST_SKIP() << "the published MODTRAN run is not here";
    const AirState tropical = Profile::model(ModelAtmosphere::tropical).at(0.0);
    std::ifstream in(file);
    std::string line;
    double squares = 0.0, worst = 0.0;
    int count = 0;
    for (int number = 1; std::getline(in, line); ++number) {
        std::istringstream words(line);
        double nu = 0.0, value = 0.0;
        if (number <= 13 || !(words >> nu) || nu < 660.0 || nu > 10000.0)
            continue;
        for (int i = 0; i < 7; ++i)
            words >> value;
        const double depth =
            5000.0 * (continuumAbsorption_per_m(Continuum::waterSelf, tropical, nu) +
                      continuumAbsorption_per_m(Continuum::waterForeign, tropical, nu));
        const double error = std::exp(-depth) - value;
        squares += error * error;
        worst = std::max(worst, std::abs(error));
        ++count;
    }
    RecordProperty("rms", std::to_string(std::sqrt(squares / count)));
    EXPECT_LT(std::sqrt(squares / count), 0.006);
    EXPECT_LT(worst, 0.05);
}

/// How far the free continuum is from MT_CKD 4.3, which may be compared with but not shipped.
TEST(Continuum, ofWaterLiesNearMtCkd) {
    const auto file = sharedMaterial("data/atmosphere/continuum/mt_ckd_4.3_h2o.csv");
    if (file.empty())
        GTEST_SKIP() << "the MT_CKD table is not here";
    const CsvTable table = CsvTable::read(file);
    struct Case {
        const char* name;
        AirState air;
        double length_m;
    };
    struct Region {
        double lower_cm, upper_cm, rms; ///< of transmittance, not to be passed in any case
    };
    const Profile winter = Profile::model(ModelAtmosphere::midlatitudeWinter);
    const std::array<Case, 3> cases = {
        {{"tropical", Profile::model(ModelAtmosphere::tropical).at(0.0), 5e3},
         {"winter", winter.at(0.0), 10e3},
         {"aloft", winter.at(8000.0), 50e3}}};
    const std::array<Region, 7> regions = {{{500, 800, 0.01},
                                            {800, 1250, 0.075},
                                            {1250, 2000, 0.07},
                                            {2000, 2900, 0.035},
                                            {2900, 4200, 0.1},
                                            {4200, 5000, 0.09},
                                            {5000, 10000, 0.085}}};
    for (const Case& test : cases)
        for (const Region& region : regions) {
            double squares = 0.0, worst = 0.0, worstAt = 0.0;
            int count = 0;
            for (std::size_t r = 1; r < table.rows().size(); ++r) {
                std::vector<Offence> offences;
                std::array<double, 5> row{};
                for (std::size_t c = 0; c < row.size(); ++c)
                    row[c] = table.number(table.rows()[r].cells[c], offences).value_or(0.0);
                const double nu = row[0];
                if (nu < region.lower_cm || nu > region.upper_cm)
                    continue;
                const AirState& air = test.air;
                const double reference = 101300.0 / (1.380649e-23 * 296.0);
                const double water = air.density_per_m3(Gas::H2O), all = air.airDensity_per_m3();
                const double radiation =
                    nu * std::tanh(1.438776877 * nu / (2.0 * air.temperature_K));
                const double published =
                    1e-4 * water * radiation *
                    (row[1] * water / reference * std::pow(296.0 / air.temperature_K, row[4]) +
                     row[2] * (all - water) / reference);
                const double ours = continuumAbsorption_per_m(Continuum::waterSelf, air, nu) +
                                    continuumAbsorption_per_m(Continuum::waterForeign, air, nu);
                const double error =
                    std::exp(-ours * test.length_m) - std::exp(-published * test.length_m);
                squares += error * error;
                if (std::abs(error) > worst) {
                    worst = std::abs(error);
                    worstAt = nu;
                }
                ++count;
            }
            std::cout << "MT_CKD 4.3, " << test.name << ", " << region.lower_cm << "-"
                      << region.upper_cm << " cm-1: rms " << std::sqrt(squares / count)
                      << ", largest " << worst << " at " << worstAt << " cm-1\n";
            EXPECT_LT(std::sqrt(squares / count), region.rms)
                << test.name << " from " << region.lower_cm;
        }
}

struct BadTable {
    const char* name;
    const char* text;
    const char* expected;
};

class BadEvenTable : public testing::TestWithParam<BadTable> {};

TEST_P(BadEvenTable, isRefusedByName) {
    const auto file =
        std::filesystem::temp_directory_path() / (std::string("even-") + GetParam().name + ".csv");
    std::ofstream(file) << GetParam().text;
    try {
        (void)EvenTable::read(file, {"k"});
        FAIL() << "it was read";
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find(GetParam().expected), std::string::npos)
            << error.what();
        EXPECT_NE(std::string(error.what()).find(file.filename().string()), std::string::npos);
    }
    std::filesystem::remove(file);
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
