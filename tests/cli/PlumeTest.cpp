#include <cmath>
#include <fstream>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "smatcore/data/ResultTable.h"
#include "tests/cli/Program.h"
#include "tests/support/TemporaryFolder.h"

namespace smat::test {
namespace {

using testing::HasSubstr;

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

class SmatBatchPlume : public testing::Test {
  protected:
    SmatBatchPlume() { writeJet(folder / "jet.csv"); }
    Ran run(std::vector<std::string> more) {
        more.insert(more.begin(), {"plume", "jet.csv"});
        return smatBatch(more, folder.path());
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
    // As analyses see the model that was written: from beside and the quarter, then from behind.
    const auto intensities = [&](const char* from_deg, const char* to_deg, const char* step_deg) {
        const Ran polar = smatBatch({"polar",
                                     "plume.obj",
                                     "--database",
                                     "plume.sigdb",
                                     "--band",
                                     "4.4-4.6",
                                     "--from",
                                     from_deg,
                                     "--to",
                                     to_deg,
                                     "--step",
                                     step_deg,
                                     "--range",
                                     "500",
                                     "--sun",
                                     "off",
                                     "--ambient-reflection",
                                     "off",
                                     "--bounces",
                                     "0",
                                     "--background",
                                     "none",
                                     "--atmosphere",
                                     "none",
                                     "--out",
                                     "polar.csv"},
                                    folder.path());
        EXPECT_EQ(polar.exitCode, 0) << polar.err;
        return ResultTable::load(folder / "polar.csv").find("intensity")->values;
    };
    std::vector<double> seen = intensities("90", "135", "45");
    seen.push_back(intensities("170", "190", "20").front());
    ASSERT_EQ(seen.size(), 3U);
    for (std::size_t view = 0; view < seen.size(); ++view) {
        const double expected = made["views"][view]["intensity_table_W_sr"];
        EXPECT_NEAR(seen[view] / expected, 1.0, 0.05) << made["views"][view]["view"];
    }
}

TEST_F(SmatBatchPlume, IsRefusedWhereTheBoundIsNotReached) {
    const Ran ran = run({"--band", "4.4-4.6", "--most-zones", "1", "--out", "plume.obj"});
    EXPECT_EQ(ran.exitCode, 2);
    EXPECT_THAT(ran.err, HasSubstr("with 1 zones"));
    EXPECT_FALSE(std::filesystem::exists(folder / "plume.obj"));
}

TEST_F(SmatBatchPlume, NamesEveryWrongOption) {
    const Ran ran = run({"--bound", "2", "--band", "5-3", "--most-zones", "0", "--out", "a.flt"});
    EXPECT_EQ(ran.exitCode, 2);
    for (const char* named : {"--bound", "band", "--most-zones", "--out"}) {
        EXPECT_THAT(ran.err, HasSubstr(named));
    }
}

} // namespace
} // namespace smat::test
