#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/cli/Program.h"
#include "tests/support/Sanitized.h"
#include "tests/support/TemporaryFolder.h"

// What small files and long work may take of memory and time.

namespace smat::test {
namespace {

using testing::HasSubstr;

/// The sample of the box, in place, with `count` analyses like the named one.
std::filesystem::path projectOf(const TemporaryFolder& folder, int count,
                                const nlohmann::json& analysis) {
    auto project = nlohmann::json::parse(contentOf(sample("box/box.smat")));
    for (const char* file : {"file", "database"}) {
        project["models"][0][file] =
            sample("box/" + project["models"][0][file].get<std::string>()).string();
    }
    project["analyses"] = nlohmann::json::object();
    for (int i = 0; i < count; ++i) {
        project["analyses"]["a" + std::to_string(i)] = analysis;
    }
    write(folder / "p.smat", project.dump());
    return folder / "p.smat";
}

TEST(SmatBatchBounds, TenThousandAnalysesShareTheirProject) {
    const TemporaryFolder folder;
    const auto project = projectOf(folder, 10000, {{"kind", "image"}});
    const Ran ran = smatBatch({"run", project.string(), "--dry-run"}, folder.path());
    EXPECT_EQ(ran.exitCode, 0) << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("a9999"));
    if (!isSanitized()) {
        EXPECT_LT(ran.peak_MB, 250.0);
    }
}

TEST(SmatBatchBounds, ImagesThatAreWrittenAreLetGo) {
    const TemporaryFolder folder;
    const nlohmann::json image = {{"kind", "image"}, {"sensor", {{"width", 512}, {"height", 512}}}};
    double peaks_MB[2] = {};
    int which = 0;
    for (const int count : {4, 40}) {
        const auto project = projectOf(folder, count, image);
        const Ran ran = smatBatch({"run", project.string(), "--out", "out"}, folder.path());
        ASSERT_EQ(ran.exitCode, 0) << ran.err;
        ASSERT_TRUE(
            std::filesystem::exists(folder / "out" / ("a" + std::to_string(count - 1) + ".exr")));
        peaks_MB[which++] = ran.peak_MB;
    }
    // 36 images are 36 MB and more.
    if (!isSanitized()) {
        EXPECT_LT(peaks_MB[1] - peaks_MB[0], 20.0) << peaks_MB[0];
    }
}

/// A wavy square of side * side * 2 triangles, as binary STL.
void writeWaves(const std::filesystem::path& file, int side) {
    std::ofstream out(file, std::ios::binary);
    const auto put = [&](const auto& value) {
        out.write(reinterpret_cast<const char*>(&value), sizeof value);
    };
    out << std::string(80, ' ');
    put(static_cast<std::uint32_t>(2 * side * side));
    const auto corner = [&](int x, int y) {
        const double step_m = 20.0 / side;
        put(static_cast<float>(x * step_m - 10.0));
        put(static_cast<float>(y * step_m - 10.0));
        put(static_cast<float>(std::sin(0.5 * x * step_m) * std::cos(0.7 * y * step_m)));
    };
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            for (const bool upper : {false, true}) {
                for (int i = 0; i < 3; ++i) {
                    put(0.0f); // the reader finds the normal
                }
                corner(x, y);
                corner(x + 1, upper ? y + 1 : y);
                corner(upper ? x : x + 1, y + 1);
                put(static_cast<std::uint16_t>(0));
            }
        }
    }
}

TEST(SmatBatchBounds, AnImageOfALargeModelTakesSoMuchForATriangle) {
    // Without inter-reflection, whose memory has a bound of its own.
    const TemporaryFolder folder;
    auto project = nlohmann::json::parse(contentOf(sample("box/box.smat")));
    auto& model = project["models"][0];
    model["database"] = sample("box/" + model["database"].get<std::string>()).string();
    model["file"] = "waves.stl";
    model["fallbackTemperature"] = model["fallbackMaterial"] = 1;
    project["render"]["bounces"] = 0;
    project["analyses"] = nlohmann::json::object();
    write(folder / "p.smat", project.dump());
    double peaks_MB[2] = {};
    constexpr int sides[] = {100, 500};
    for (int i = 0; i < 2; ++i) {
        writeWaves(folder / "waves.stl", sides[i]);
        const Ran ran =
            smatBatch({"image", "p.smat", "--elevation", "40", "--out", "i.exr"}, folder.path());
        ASSERT_EQ(ran.exitCode, 0) << ran.err;
        peaks_MB[i] = ran.peak_MB;
    }
    const double triangles = 2.0 * (sides[1] * sides[1] - sides[0] * sides[0]);
    const double perTriangle_B = (peaks_MB[1] - peaks_MB[0]) * 1e6 / triangles;
    RecordProperty("bytes_per_triangle", std::to_string(perTriangle_B));
    EXPECT_GT(perTriangle_B, 36.0) << "its corners alone: this measures nothing";
    if (!isSanitized()) {
        EXPECT_LT(perTriangle_B, 420.0) << peaks_MB[0] << " and " << peaks_MB[1] << " MB";
    }
}

TEST(SmatBatchBounds, AMillionBadRowsAreAHundredSentences) {
    const TemporaryFolder folder;
    {
        std::ofstream out(folder / "t.csv");
        out << "t [s],x [m],y [m],z [m],yaw [deg],pitch [deg],roll [deg]\n";
        for (int i = 0; i < 1'000'000; ++i) {
            out << i / 2 << ",0,0,100,0,0,0\n"; // each time twice
        }
    }
    auto scenario = nlohmann::json::parse(contentOf(sample("flyby/flyby.json")));
    scenario["entities"] = {{{"name", "a"},
                             {"model", sample("box/box.flt").string()},
                             {"database", sample("box/box.sigdb").string()},
                             {"trajectory", "t.csv"}}};
    scenario["sensors"] = {{{"name", "south"}, {"position_m", {0, 0, 100}}}};
    write(folder / "s.json", scenario.dump());
    const Ran ran = smatBatch({"simulate", "s.json", "--out", "out", "--dry-run"}, folder.path());
    EXPECT_EQ(ran.exitCode, 2);
    EXPECT_THAT(ran.err, HasSubstr("t.csv: line 3, column 1: "));
    EXPECT_THAT(ran.err, HasSubstr("and 499900 more"));
    EXPECT_LT(std::ranges::count(ran.err, '\n'), 120);
    if (!isSanitized()) {
        EXPECT_LT(ran.peak_MB, 500.0);
    }
}

} // namespace
} // namespace smat::test
