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
