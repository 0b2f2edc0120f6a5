#include <filesystem>
#include <map>
#include <ostream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cli/Scenarios.h"

namespace smat::test {
namespace {

using testing::HasSubstr;

/// What stands in a folder and those in it, by name.
std::map<std::string, std::string> contents(const std::filesystem::path& folder) {
    std::map<std::string, std::string> found;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        if (entry.is_regular_file()) {
            found[entry.path().lexically_relative(folder).string()] = withoutCommand(entry.path());
        }
    }
    return found;
}

std::string air(const std::string& file) {
    return sample("../resources/atmospheres/" + file).lexically_normal().string();
}

struct ThreadsRow {
    const char* name;
    const char* air;
    const char* mode;
};

void PrintTo(const ThreadsRow& row, std::ostream* out) {
    *out << row.name;
}

/// The aircraft with plumes through one air in one mode, in a band and in a part of it that gas
/// fills.
class SmatBatchThreadsOfPlumes : public testing::TestWithParam<ThreadsRow> {
  protected:
    /// What the commands write with so many threads.
    static std::map<std::string, std::string> written(const std::string& threads,
                                                      const std::vector<Words>& commands) {
        const TemporaryFolder folder;
        write(folder / "s.json", scenario());
        std::filesystem::create_directory(folder / "out");
        const Words cheap = {"--threads",      threads, "--atmosphere", air(GetParam().air),
                             "--antialiasing", "3",     "--shadows",    "off",
                             "--bounces",      "0",     "--width",      "48",
                             "--height",       "32"};
        for (Words words : commands) {
            words.insert(words.end(), cheap.begin(), cheap.end());
            const Ran ran = smatBatch(words, folder.path());
            EXPECT_EQ(ran.exitCode, 0) << words.front() << ": " << ran.err;
        }
        return contents(folder / "out");
    }
    static void expectSameBytes(const std::vector<Words>& commands, std::size_t files) {
        const auto ofOne = written("1", commands);
        EXPECT_EQ(ofOne.size(), files);
        for (const char* threads : {"2", "7"}) {
            const auto ofMore = written(threads, commands);
            EXPECT_EQ(ofMore.size(), files);
            for (const auto& [file, bytes] : ofOne) {
                // Not the bytes themselves, which nobody reads.
                EXPECT_TRUE(ofMore.contains(file) && ofMore.at(file) == bytes)
                    << file << ", " << threads << " threads";
            }
        }
    }

  private:
    static std::string scenario() {
        const std::string plane =
            entity("plane", "turboprop4", R"("position_m": [0, 0, 1500], "power": 0.7)");
        return R"({"version": 1, "dt_s": 1, "end_s": 1, "scaling": {"use": false},
 "environment": {"sunAzimuth": 135, "sunElevation": 40}, "sensor": {"fov": 4},
 "entities": [)" +
               plane + R"(], "sensors": [
  {"name": "south", "track": "plane", "position_m": [0, -900, 1500]},
  {"name": "east", "track": "plane", "position_m": [700, 100, 1300]}]})";
    }
};

TEST_P(SmatBatchThreadsOfPlumes, SweepsAndEngagementsHaveTheSameBytesForAnyNumber) {
    const std::string bands = "3-5,4.2-4.5";
    expectSameBytes({{"polar", sample("turboprop4/turboprop4.smat"), "--step", "120", "--steps",
                      "fixed", "--mode", GetParam().mode, "--band", bands, "--out", "out/p.csv"},
                     {"simulate", "s.json", "--format", "csv", "--mode", GetParam().mode, "--band",
                      bands, "--out", "out"}},
                    // A polar plot; of two sensors a table, a sensor and two frames in two bands.
                    1 + 2 * (2 + 2 * 2));
}

INSTANTIATE_TEST_SUITE_P(
    Airs, SmatBatchThreadsOfPlumes,
    testing::Values(ThreadsRow{"ComputedSpectral", "midlatitude-summer-rural-23km.xml", "spectral"},
                    ThreadsRow{"ComputedCk", "midlatitude-summer-rural-23km.xml", "ck"},
                    ThreadsRow{"HazeSpectral", "haze-23km.csv", "spectral"},
                    ThreadsRow{"HazeCk", "haze-23km.csv", "ck"}),
    [](const auto& info) { return std::string(info.param.name); });

/// Spectra know no ck.
class SmatBatchThreadsOfSpectra : public SmatBatchThreadsOfPlumes {};

TEST_P(SmatBatchThreadsOfSpectra, HaveTheSameBytesForAnyNumber) {
    std::vector<Words> commands;
    for (const std::string band : {"3-5", "4.2-4.5"}) {
        commands.push_back({"spectrum", sample("turboprop4/turboprop4.smat"), "--band", band,
                            "--resolution", "20", "--out", "out/" + band + ".csv"});
    }
    expectSameBytes(commands, commands.size());
}

INSTANTIATE_TEST_SUITE_P(Airs, SmatBatchThreadsOfSpectra,
                         testing::Values(ThreadsRow{"Computed", "midlatitude-summer-rural-23km.xml",
                                                    "spectral"},
                                         ThreadsRow{"Haze", "haze-23km.csv", "spectral"}),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(SmatBatchThreads, ChangeNothingButTheTime) {
    const TemporaryFolder folder;
    const auto ran = [&](const std::string& threads) {
        const std::string file = folder / ("of" + threads + ".csv");
        const Ran one = smatBatch(
            {"polar", sample("box/box.smat"), "--step", "60", "--threads", threads, "--out", file});
        EXPECT_EQ(one.exitCode, 0) << one.err;
        return withoutCommand(file);
    };
    const std::string of1 = ran("1");
    EXPECT_EQ(of1, ran("2"));
    EXPECT_EQ(of1, ran("7"));
    for (const char* wrong : {"0", "1.5", "many"}) {
        const Ran refused = smatBatch({"settings", "--threads", wrong});
        EXPECT_EQ(refused.exitCode, 2);
        EXPECT_THAT(refused.err, HasSubstr("--threads"));
    }
}

} // namespace
} // namespace smat::test
