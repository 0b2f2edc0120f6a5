#include <algorithm>
#include <gtest/gtest.h>
#include <sstream>

#include "tests/cli/Program.h"
#include "tests/support/TemporaryFolder.h"

namespace smat::test {
namespace {

/// Contrast intensities of a range analysis through an atmosphere, W sr-1.
std::vector<double> intensities(const std::string& project, const std::string& band,
                                const std::string& mode, const std::string& file) {
    const std::string air = sample("../resources/atmospheres/" + file).string();
    const TemporaryFolder folder;
    const Ran ran = smatBatch({"range", sample(project).string(), "--from", "500", "--to", "8000",
                               "--points", "4", "--band", band, "--atmosphere", air, "--mode", mode,
                               "--out", (folder.path() / "range.csv").string()});
    EXPECT_EQ(ran.exitCode, 0) << ran.err;
    std::vector<double> values;
    std::istringstream lines(contentOf(folder.path() / "range.csv"));
    std::size_t column = 0;
    for (std::string line; std::getline(lines, line);) {
        if (line.empty() || line[0] == '#') {
            continue;
        }
        std::vector<std::string> cells;
        std::istringstream row(line);
        for (std::string cell; std::getline(row, cell, ',');) {
            cells.push_back(cell);
        }
        const auto named = std::ranges::find(cells, "intensity [W sr-1]");
        if (named != cells.end()) {
            column = static_cast<std::size_t>(named - cells.begin());
        } else {
            values.push_back(std::stod(cells.at(column)));
        }
    }
    return values;
}

struct WidebandCase {
    const char* name;
    const char* project;
    const char* band;
    const char* air = "midlatitude-summer-rural-23km.xml";
};
void PrintTo(const WidebandCase& row, std::ostream* out) {
    *out << row.name;
}

class SmatBatchWideband : public testing::TestWithParam<WidebandCase> {};

TEST_P(SmatBatchWideband, GivesTheIntensitiesOfTheSpectralMode) {
    const auto spectral =
        intensities(GetParam().project, GetParam().band, "spectral", GetParam().air);
    const auto wideband = intensities(GetParam().project, GetParam().band, "ck", GetParam().air);
    ASSERT_EQ(spectral.size(), 4u);
    ASSERT_EQ(wideband.size(), 4u);
    for (std::size_t i = 0; i < spectral.size(); ++i) {
        EXPECT_NEAR(wideband[i] / spectral[i], 1.0, 0.005) << i;
    }
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, SmatBatchWideband,
    testing::Values(WidebandCase{"SphereInMidWave", "sphere/sphere.smat", "3.2-4.8"},
                    WidebandCase{"BoxInLongWave", "box/box.smat", "8-12"},
                    WidebandCase{"SphereInHaze", "sphere/sphere.smat", "3.2-4.8", "haze-23km.csv"}),
    [](const auto& info) { return std::string(info.param.name); });

TEST(SmatBatchComputedAtmosphere, IsSeenStraightDownAndStraightUp) {
    const std::string air =
        sample("../resources/atmospheres/midlatitude-summer-rural-23km.xml").string();
    const TemporaryFolder folder;
    for (const std::string elevation : {"90", "-90"}) {
        const Ran ran = smatBatch({"polar", sample("sphere/sphere.smat").string(), "--elevation",
                                   elevation, "--step", "180", "--altitude", "2000", "--atmosphere",
                                   air, "--out", (folder.path() / (elevation + ".csv")).string()});
        EXPECT_EQ(ran.exitCode, 0) << elevation << ": " << ran.err;
    }
}

} // namespace
} // namespace smat::test
