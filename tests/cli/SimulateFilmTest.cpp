#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cli/Scenarios.h"

namespace smat::test {
namespace {

using testing::HasSubstr;

/// Where programs are looked for, for as long as this lives.
class SearchPath {
  public:
    explicit SearchPath(const std::string& path) : before_(now()) {
        setenv("PATH", path.c_str(), 1);
    }
    ~SearchPath() { setenv("PATH", before_.c_str(), 1); }
    SearchPath(const SearchPath&) = delete;
    SearchPath& operator=(const SearchPath&) = delete;

    static std::string now() {
        const char* path = std::getenv("PATH");
        return path == nullptr ? "" : path;
    }

  private:
    std::string before_;
};

/// Stands for ffmpeg: writes down its arguments, and as a film all pictures one behind the other.
void writeEncoder(const std::filesystem::path& file, const std::string& script) {
    std::filesystem::create_directories(file.parent_path());
    write(file, "#!/bin/sh\n" + script);
    std::filesystem::permissions(file, std::filesystem::perms::owner_all);
}
const std::string encoder = R"sh(here=$(dirname "$0")
printf '%s\n' "$@" > "$here/arguments"
for film; do :; done
cat "$(dirname "$film")"/[0-9]*.png > "$film"
)sh";

/// A sphere that comes nearer: it grows brighter from frame to frame.
std::string approaching(const std::string& sensors = south) {
    return scenarioOf(entity("sphere", "sphere", R"("trajectory": "sphere.csv")"), sensors,
                      R"("dt_s": 0.5, "end_s": 1.5)");
}
const char* const approachPath =
    "t,x,y,z,yaw,pitch,roll\n0,0,3000,100,0,0,0\n1.5,0,200,100,0,0,0\n";

TEST(SmatBatchSimulate, AFilmHasOneScaleOfColours) {
    const TemporaryFolder folder;
    write(folder / "s.json", approaching());
    write(folder / "sphere.csv", approachPath);
    const Ran ran = simulated(folder, {"--film", "near.png"});
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("-> near-000000.png to near-000003.png"));
    // The same as frames whose limits are given: the least and the largest value of all.
    float low = INFINITY, high = -INFINITY;
    for (int frame = 0; frame < 4; ++frame) {
        for (const float value :
             pixels(folder / "out/south" / ("frame_00000" + std::to_string(frame) + ".exr"))) {
            low = std::min(low, value);
            high = std::max(high, value);
        }
    }
    char limits[2][60];
    std::snprintf(limits[0], sizeof limits[0], "display.minimum=%.17g", static_cast<double>(low));
    std::snprintf(limits[1], sizeof limits[1], "display.maximum=%.17g", static_cast<double>(high));
    const Ran again =
        simulated(folder, {"--format", "png", "--set", limits[0], "--set", limits[1]});
    ASSERT_EQ(again.exitCode, 0) << again.err;
    for (int frame = 0; frame < 4; ++frame) {
        const std::string number = "00000" + std::to_string(frame) + ".png";
        EXPECT_TRUE(contentOf(folder / ("near-" + number)) ==
                    contentOf(folder / "out/south" / ("frame_" + number)))
            << frame;
    }
    EXPECT_FALSE(contentOf(folder / "near-000000.png") == contentOf(folder / "near-000003.png"));
}

TEST(SmatBatchSimulate, AFilmIsEncodedByFfmpegWithoutAShell) {
    const TemporaryFolder folder;
    write(folder / "s.json", approaching(std::string(south) +
                                         R"(, {"name": "both", "position_m": [0, 0, 100],
  "sensor": {"band": "3-5,8-12"}})"));
    write(folder / "sphere.csv", approachPath);
    writeEncoder(folder / "bin/ffmpeg", encoder);
    const SearchPath path((folder / "bin").string() + ":" + SearchPath::now());
    const Ran ran = simulated(folder, {"--film", "a film; of $(touch broken).mp4"});
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    EXPECT_FALSE(std::filesystem::exists(folder / "broken"));
    for (const char* label : {"south", "both@3-5um", "both@8-12um"}) {
        const std::string film =
            contentOf(folder / ("a film; of $(touch broken)-" + std::string(label) + ".mp4"));
        std::size_t pictures = 0;
        for (std::size_t at = 0; (at = film.find("\x89PNG", at)) != std::string::npos; ++at) {
            ++pictures;
        }
        EXPECT_EQ(pictures, 4U) << label;
    }
    EXPECT_THAT(contentOf(folder / "bin/arguments"), HasSubstr("-framerate\n2\n-i\n"));
    EXPECT_THAT(contentOf(folder / "bin/arguments"), HasSubstr("-pix_fmt\nyuv420p\n"));
    // One that fails says why, and leaves the film that was there.
    writeEncoder(folder / "bin/ffmpeg", "echo 'Unknown encoder' >&2; exit 3\n");
    write(folder / "old.gif", "before");
    const Ran failed = simulated(folder, {"--sensor", "south", "--film", "old.gif"});
    EXPECT_EQ(failed.exitCode, 2);
    EXPECT_THAT(failed.err, HasSubstr("ffmpeg ended with 3: Unknown encoder"));
    EXPECT_EQ(contentOf(folder / "old.gif"), "before");
}

TEST(SmatBatchSimulate, AFilmThatCannotBeIsRefusedBeforeTheFirstFrame) {
    const TemporaryFolder folder;
    write(folder / "s.json", approaching());
    write(folder / "sphere.csv", approachPath);
    const struct {
        Words words;
        const char* told;
    } refused[] = {{{"--film", "a.mp4"}, "no ffmpeg on PATH"},
                   {{"--film", "a.avi"}, ".mp4, .gif, or .png"},
                   {{"--film", "a"}, "no extension"},
                   {{"--film", "a.png", "--format", "csv"}, "--format exr"}};
    std::filesystem::create_directories(folder / "empty");
    const SearchPath path((folder / "empty").string());
    for (const auto& one : refused) {
        const Ran ran = simulated(folder, one.words);
        EXPECT_EQ(ran.exitCode, 2) << one.told;
        EXPECT_THAT(ran.err, HasSubstr(one.told));
        EXPECT_FALSE(std::filesystem::exists(folder / "out"));
    }
}

} // namespace
} // namespace smat::test
