#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "irsg/gas/GasSpectrum.h"
#include "irsg/radiometry/Units.h"
#include "irsg/signature/SignatureFile.h"
#include "irsg/signature/SurfaceTemperature.h"
#include "smatcore/data/ResultTable.h"
#include "tests/cli/Program.h"
#include "tests/cli/SeenPlume.h"
#include "tests/support/TemporaryFolder.h"

namespace smat::test {
namespace {

using testing::HasSubstr;
using testing::Not;

/// A jet whose gas thins out and cools down away from its axis and its nozzle.
void writeJet(const std::filesystem::path& file) {
    std::ofstream out(file);
    out << "x [m],r [m],T [K],CO2,H2O\n";
    for (int i = 0; i < 16; ++i) {
        for (int j = 0; j < 16; ++j) {
            const double x_m = 3.0 * i / 15, r_m = 1.2 * j / 15, width_m = 0.2 + 0.09 * x_m;
            const double part = 0.2 / width_m * std::exp(-r_m * r_m / (width_m * width_m));
            out << x_m << "," << r_m << "," << 288.0 + 600.0 * part << "," << 0.04 * part << ","
                << 0.04 * part << "\n";
        }
    }
}

/// A table of 60 x 40 nodes of exhaust of 900 K, and what it sends, summed along lines of sight
/// through its nodes by nothing but layers of gas.
class DensePlume {
  public:
    DensePlume() {
        for (int i = 0; i < along; ++i) {
            for (int j = 0; j < across; ++j) {
                const double x_m = length_m * i / (along - 1), r_m = radius_m * j / (across - 1);
                const double width_m = 0.12 + 0.09 * x_m;
                const double axis = std::min(1.0, 0.58 / std::max(x_m, 1e-6));
                part_[i][j] = axis * std::exp(-r_m * r_m / (width_m * width_m));
            }
        }
    }

    void write(const std::filesystem::path& file) const {
        std::ofstream out(file);
        out.precision(17);
        out << "x [m],r [m],T [K],CO2,H2O\n";
        for (int i = 0; i < along; ++i) {
            for (int j = 0; j < across; ++j) {
                const irsg::GasLayer gas = gasOf(part_[i][j]);
                out << length_m * i / (along - 1) << "," << radius_m * j / (across - 1) << ","
                    << gas.temperature_K << "," << gas.fraction(irsg::HotGas::CO2) << ","
                    << gas.fraction(irsg::HotGas::H2O) << "\n";
            }
        }
    }

    /// Along parallel lines of sight by so many degrees to the axis, from behind.
    double intensity_W_sr(double angle_deg, const irsg::SpectralRange& band) const {
        constexpr int rows = 36, columns = 36, steps = 160;
        const double sine = std::sin(irsg::radians(angle_deg));
        const double cosine = std::cos(irsg::radians(angle_deg));
        double sum = 0.0;
        // Corners of the lengthwise section, as the sensor sees them above and below the nozzle.
        for (const double end_m : {length_m * sine + radius_m * cosine, -radius_m * cosine}) {
            for (int row = 0; row < rows; ++row) {
                const double t = (row + 0.5) / rows;
                for (int column = 0; column < columns; ++column) {
                    const double s = (column + 0.5) / columns;
                    // By cubes, which begin without a jump where it is hot.
                    const double area_m2 =
                        std::abs(end_m) * 3.0 * t * t / rows * radius_m * 3.0 * s * s / columns;
                    if (std::abs(end_m) > 1e-9) {
                        sum += 2.0 * area_m2 *
                               radianceAlong(end_m * t * t * t, radius_m * s * s * s, sine, cosine,
                                             steps, band);
                    }
                }
            }
        }
        return sum;
    }

  private:
    static constexpr int along = 60, across = 40;
    static constexpr double length_m = 6.0, radius_m = 1.6;

    static irsg::GasLayer gasOf(double part) {
        irsg::GasLayer gas;
        gas.temperature_K = 288.0 + 612.0 * part;
        gas.fraction(irsg::HotGas::CO2) = 0.04 * part;
        gas.fraction(irsg::HotGas::H2O) = 0.04 * part;
        return gas;
    }
    double partAt(double x_m, double r_m) const {
        const double i = x_m / length_m * (along - 1), j = r_m / radius_m * (across - 1);
        const int i0 = std::min(static_cast<int>(i), along - 2);
        const int j0 = std::min(static_cast<int>(j), across - 2);
        return std::lerp(std::lerp(part_[i0][j0], part_[i0][j0 + 1], j - j0),
                         std::lerp(part_[i0 + 1][j0], part_[i0 + 1][j0 + 1], j - j0), i - i0);
    }
    /// Of a line of sight that goes through (x, y) = p (sine, -cosine) + s (cosine, sine) at
    /// `beside_m` from the plane of the axis; the sensor is where s is largest.
    double radianceAlong(double p_m, double beside_m, double sine, double cosine, int steps,
                         const irsg::SpectralRange& band) const {
        const auto isIn = [&](double s_m) {
            const double x_m = p_m * sine + s_m * cosine, y_m = -p_m * cosine + s_m * sine;
            return x_m >= 0.0 && x_m <= length_m && std::hypot(y_m, beside_m) <= radius_m;
        };
        const double reach_m = length_m + 2.0 * radius_m;
        double first_m = reach_m, last_m = -reach_m;
        constexpr int looks = 2000;
        for (int i = 0; i <= looks; ++i) {
            const double s_m = reach_m * (1.0 - 2.0 * i / looks);
            if (isIn(s_m)) {
                first_m = std::min(first_m, s_m);
                last_m = std::max(last_m, s_m);
            }
        }
        // To where it ends between two looks.
        const auto toTheEnd = [&](double& end_m, double outside_m) {
            for (int i = 0; i < 20; ++i) {
                const double middle_m = 0.5 * (end_m + outside_m);
                (isIn(middle_m) ? end_m : outside_m) = middle_m;
            }
        };
        toTheEnd(first_m, first_m - 2.0 * reach_m / looks);
        toTheEnd(last_m, last_m + 2.0 * reach_m / looks);
        std::vector<irsg::GasLayer> layers;
        for (int i = 0; i < steps && last_m > first_m; ++i) {
            const double s_m = last_m - (last_m - first_m) * (i + 0.5) / steps;
            const double x_m = p_m * sine + s_m * cosine, y_m = -p_m * cosine + s_m * sine;
            layers.push_back(gasOf(partAt(std::clamp(x_m, 0.0, length_m),
                                          std::min(std::hypot(y_m, beside_m), radius_m))));
            layers.back().length_m = (last_m - first_m) / steps;
        }
        return layers.empty() ? 0.0
                              : irsg::gasSpectrum(
                                    {.layers = layers, .band = band, .step_per_cm = finer_per_cm})
                                    .bandRadiance_W_m2_sr();
    }

    /// Steps of 5 cm-1 leave 0.4 % of the band.
    static constexpr double finer_per_cm = 2.0;

    std::array<std::array<double, across>, along> part_{};
};

class SmatBatchPlume : public testing::Test {
  protected:
    SmatBatchPlume() { writeJet(folder / "jet.csv"); }
    Ran run(std::vector<std::string> more) {
        more.insert(more.begin(), {"plume", "jet.csv"});
        return smatBatch(more, folder.path());
    }

    /// From beside, the quarter and behind.
    std::vector<double> seenFromThreeSides(const std::string& name) {
        std::vector<double> seen;
        for (const auto& [from_deg, to_deg, step_deg] :
             {std::array{"90", "135", "45"}, std::array{"170", "190", "20"}}) {
            const std::vector<double> values =
                seenPlume_W_sr(folder, name, from_deg, to_deg, step_deg);
            seen.insert(seen.end(), values.begin(), values.end());
        }
        seen.resize(std::min<std::size_t>(seen.size(), 3)); // 190 degrees is 170 once more
        return seen;
    }

    TemporaryFolder folder;
};

TEST_F(SmatBatchPlume, MakesZonesOfAJetOfExhaust) {
    const auto jet = [&](const std::string& text, const std::string& out) {
        return smatBatch(
            {"plume", "--jet", text, "--band", "4.4-4.6", "--bound", "0.1", "--json", "--out", out},
            folder.path());
    };
    const std::string engine = "D_m=0.3,T_K=800,velocity_m_s=200,fuel_air=0.02,ends_at=0.3";
    const Ran ran = jet(engine, "jet.obj");
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    const auto made = nlohmann::json::parse(ran.out);
    EXPECT_GT(made["zones"], 1);
    // A nozzle of twice the size is a jet of twice all lengths: four times as wide to the view,
    // and thicker.
    const Ran larger =
        jet("D_m=0.6,T_K=800,velocity_m_s=200,fuel_air=0.02,ends_at=0.3", "larger.obj");
    ASSERT_EQ(larger.exitCode, 0) << larger.err;
    const auto intensityOf = [](const nlohmann::json& of) {
        return of["views"][0]["intensity_table_W_sr"].get<double>();
    };
    const double ratio = intensityOf(nlohmann::json::parse(larger.out)) / intensityOf(made);
    EXPECT_GT(ratio, 4.0);
    EXPECT_LT(ratio, 8.0);

    for (const auto& [text, named] : std::vector<std::pair<std::string, std::string>>{
             {"D_m=0.3,T_K=800,velocity_m_s=200", "fuel_air"},
             {engine + ",wind=3", "wind"},
             {"D_m=0.3,T_K=800,velocity_m_s=200,fuel_air=0.2", "fuel_air"},
             {"D_m=0.3,T_K=200,velocity_m_s=200,fuel_air=0.02", "T_K"}}) {
        const Ran refused = jet(text, "none.obj");
        EXPECT_EQ(refused.exitCode, 2) << text;
        EXPECT_THAT(refused.err, HasSubstr(named)) << text;
    }
    EXPECT_EQ(run({"--jet", engine, "--out", "both.obj"}).exitCode, 2);
    EXPECT_EQ(smatBatch({"plume", "--out", "none.obj"}, folder.path()).exitCode, 2);
}

TEST_F(SmatBatchPlume, MakesZonesThatAreSeenAsTheTable) {
    const Ran ran = run({"--band", "4.4-4.6", "--bound", "0.02", "--out", "plume.obj", "--json"});
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    const auto made = nlohmann::json::parse(ran.out);
    EXPECT_GT(made["zones"], 2);
    const std::vector<double> seen = seenFromThreeSides("plume");
    ASSERT_EQ(seen.size(), 3U);
    for (std::size_t view = 0; view < seen.size(); ++view) {
        const double expected = made["views"][view]["intensity_table_W_sr"];
        EXPECT_NEAR(seen[view] / expected, 1.0, 0.05) << made["views"][view]["view"];
    }
}

TEST_F(SmatBatchPlume, IsSeenAsADenseIntegrationFromThreeSides) {
    const DensePlume plume;
    plume.write(folder / "jet.csv");
    const Ran ran = run({"--band", "4.4-4.6", "--bound", "0.004", "--most-zones", "30", "--out",
                         "plume.obj", "--json"});
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    const std::vector<double> seen = seenFromThreeSides("plume");
    ASSERT_EQ(seen.size(), 3U);
    std::size_t view = 0;
    for (const double angle_deg : {90.0, 45.0, 10.0}) {
        const double dense = plume.intensity_W_sr(angle_deg, {4.4, 4.6});
        EXPECT_NEAR(seen[view++] / dense, 1.0, 0.005) << angle_deg << " degrees to the axis";
    }
}

TEST_F(SmatBatchPlume, IsRefusedWhereTheBoundIsNotReached) {
    const Ran ran = run({"--band", "4.4-4.6", "--most-zones", "1", "--out", "plume.obj"});
    EXPECT_EQ(ran.exitCode, 2);
    EXPECT_THAT(ran.err, HasSubstr("with 1 zones"));
    EXPECT_FALSE(std::filesystem::exists(folder / "plume.obj"));
}

TEST_F(SmatBatchPlume, IsNotOneZoneAsLongAsItsColdEnd) {
    const Ran ran = run({"--bound", "1", "--out", "plume.obj"});
    EXPECT_EQ(ran.exitCode, 2);
    EXPECT_THAT(ran.err, HasSubstr("--bound: found 1"));
    EXPECT_THAT(ran.err, HasSubstr("a single zone up to the cold end"));
}

TEST_F(SmatBatchPlume, NamesEveryWrongOption) {
    const Ran ran = run({"--bound", "2", "--band", "5-3", "--most-zones", "0", "--out", "a.flt"});
    EXPECT_EQ(ran.exitCode, 2);
    for (const char* named : {"--bound", "band", "--most-zones", "--out"}) {
        EXPECT_THAT(ran.err, HasSubstr(named));
    }
}

/// A sample whose gas is that of a plume command: its zones' first index, and the air in which the
/// temperatures of its database are those of the command.
struct SamplePlume {
    const char* sample;
    std::vector<std::string> arguments;
    int first;
    double air_K;
};
void PrintTo(const SamplePlume& row, std::ostream* out) {
    *out << row.sample;
}

class PlumeOfSample : public testing::TestWithParam<SamplePlume> {};

TEST_P(PlumeOfSample, HasTheGasOfItsCommand) {
    const SamplePlume& row = GetParam();
    const TemporaryFolder folder;
    std::vector<std::string> arguments{"plume"};
    arguments.insert(arguments.end(), row.arguments.begin(), row.arguments.end());
    arguments.insert(arguments.end(), {"--out", folder / "plume.obj"});
    const Ran ran = smatBatch(arguments);
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    const auto plume = irsg::loadSignatureFile(folder / "plume.sigdb").database;
    const std::string name = row.sample;
    const auto database = irsg::loadSignatureFile(sample(name + "/" + name + ".sigdb")).database;
    ASSERT_GT(plume.materials.size(), 3U);
    irsg::EntityState state;
    state.ambient_K = row.air_K;
    state.power = 1.0;
    for (const auto& [zone, gas] : plume.materials) {
        const irsg::Material& own = database.materials.at(row.first + zone - 1);
        EXPECT_NEAR(own.gasCO2, gas.gasCO2, 1e-5 * gas.gasCO2) << zone;
        EXPECT_NEAR(own.gasH2O, gas.gasH2O, 1e-5 * gas.gasH2O) << zone;
        EXPECT_NEAR(own.gasO2, gas.gasO2, 1e-5) << zone;
        const auto at_K = [&](const irsg::SignatureDatabase& of, int index) {
            return irsg::surfaceTemperature_K(of.temperatures.at(index).terms, state);
        };
        EXPECT_NEAR(at_K(database, row.first + zone - 1), at_K(plume, zone), 0.01) << zone;
    }
    // The zones are those of the model, and the next entry fills the nozzle.
    const int next = row.first + static_cast<int>(plume.materials.size());
    EXPECT_GT(database.materials.at(next).gasPressure_atm, 0.0);
    EXPECT_FALSE(database.materials.contains(next + 1));
}

// Walls that cross would be counted wrongly there.
TEST_P(PlumeOfSample, HasZonesThatAreClosedAndDoNotCross) {
    const TemporaryFolder folder;
    const std::string name = GetParam().sample;
    const Ran ran = smatBatch({"image", sample(name + "/" + name + ".smat"), "--width", "32",
                               "--height", "18", "--set", "render.bounces=0", "--set",
                               "environment.terrain=", "--out", folder / "image.csv"});
    EXPECT_EQ(ran.exitCode, 0) << ran.err;
    EXPECT_THAT(ran.err, Not(HasSubstr("crosses")));
}

INSTANTIATE_TEST_SUITE_P(
    Samples, PlumeOfSample,
    testing::Values(
        SamplePlume{"corvette", {sample("corvette/funnel.csv"), "--bound", "0.15"}, 61, 286.0},
        SamplePlume{"heron",
                    {"--jet",
                     "D_m=0.37,T_K=790,velocity_m_s=180,fuel_air=0.0185,air_K=286,coflow_m_s=102,"
                     "ends_at=0.15",
                     "--bound", "0.04"},
                    71,
                    286.0}),
    [](const auto& row) { return std::string(row.param.sample); });

// Tiles of the nozzles end where the plume is bright: sums over samples that stand off their cells,
// all to one side, were off by up to 1.4 %, the other way from the other side.
TEST(SampleTern, SendsTheSameToBothSidesFromAllRanges) {
    const TemporaryFolder folder;
    std::vector<double> intensities_W_sr;
    for (const char* range_m : {"20500", "24500", "33500"}) {
        const Ran ran = smatBatch({"polar",        sample("tern/tern.smat"),
                                   "--atmosphere", "none",
                                   "--sun",        "off",
                                   "--band",       "3-5",
                                   "--bounces",    "0",
                                   "--set",        "environment.terrain=",
                                   "--range",      range_m,
                                   "--step",       "180",
                                   "--set",        "polar.from=90",
                                   "--set",        "polar.to=270",
                                   "--out",        "sides.csv"},
                                  folder.path());
        ASSERT_EQ(ran.exitCode, 0) << ran.err;
        const ResultTable table = ResultTable::load(folder / "sides.csv");
        const ResultColumn* seen = table.find("intensity");
        ASSERT_NE(seen, nullptr);
        ASSERT_EQ(seen->values.size(), 2u);
        intensities_W_sr.insert(intensities_W_sr.end(), seen->values.begin(), seen->values.end());
    }
    const auto [least, greatest] = std::ranges::minmax(intensities_W_sr);
    EXPECT_LT(greatest / least, 1.005);
}

} // namespace
} // namespace smat::test
