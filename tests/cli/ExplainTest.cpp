// smat-batch explain: what pixels of the samples are made of, beside what is drawn of them.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "irsg/image/ImageFile.h"
#include "irsg/image/ImageFormat.h"
#include "irsg/render/rays/RaysBuilt.h"
#include "tests/cli/Program.h"
#include "tests/support/TemporaryFolder.h"

namespace smat::test {
namespace {

using testing::HasSubstr;

const std::string sphere = sample("sphere/sphere.smat");

class SmatBatchExplain : public testing::Test {
  protected:
    void SetUp() override {
        if (!irsg::areRaysBuilt()) {
            GTEST_SKIP() << irsg::whyNoRays();
        }
    }
};

TEST_F(SmatBatchExplain, TellsOfSurfaceTermsAndDifference) {
    const Ran ran =
        smatBatch({"explain", sphere, "--pixel", "32,32", "--width", "64", "--height", "64"});
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    for (const char* said :
         {"pixel 32,32 (0,0 is the top left)", "layer 1: ", "temperature index", "emissivity",
          "transmittance of the air", "thermal", "path", "background", "computed", "drawn",
          "difference", "rays through the pixel", "3 x 3 pixels hit the same facet"}) {
        EXPECT_THAT(ran.out, HasSubstr(said));
    }
}

TEST_F(SmatBatchExplain, OfACornerIsBackgroundAlone) {
    const Ran ran = smatBatch({"explain", sphere, "--pixel", "0,0", "--json"});
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    const auto pixel = nlohmann::json::parse(ran.out)["pixels"].at(0);
    EXPECT_TRUE(pixel["surfaces"].empty());
    EXPECT_EQ(pixel["computed_W_m2_sr"], pixel["background"]["behind_W_m2_sr"]);
    EXPECT_LT(std::abs(pixel["relative_difference"].get<double>()), 1e-6);
}

TEST_F(SmatBatchExplain, OfAnImageFileExplainsThePictureThatItHolds) {
    const TemporaryFolder folder;
    const std::string file = folder / "box.exr";
    std::filesystem::copy(sample("box"), folder.path(), std::filesystem::copy_options::recursive);
    ASSERT_EQ(smatBatch({"image", folder / "box.smat", "--width", "48", "--height", "32",
                         "--azimuth", "20", "--out", file})
                  .exitCode,
              0);
    // In every format that keeps values, with what they are of.
    const irsg::RadianceImage image = irsg::readImageFile(file);
    for (const irsg::ImageFormat* format : irsg::imageFormats()) {
        if (format->read == nullptr) {
            continue;
        }
        const std::string own = folder / ("own" + format->extensionList().front());
        irsg::writeImageFile(image, own);
        const Ran ran = smatBatch({"explain", own, "--pixel", "24,16", "--json"});
        ASSERT_EQ(ran.exitCode, 0) << own << ran.err;
        const auto pixel = nlohmann::json::parse(ran.out)["pixels"].at(0);
        EXPECT_EQ(pixel["drawn_W_m2_sr"], pixel["in_image_W_m2_sr"]) << own;
        EXPECT_FALSE(pixel["surfaces"].empty()) << own;
    }
    // Without its project it is said why not.
    std::filesystem::remove(folder / "box.smat");
    const Ran without = smatBatch({"explain", file, "--pixel", "24,16"});
    EXPECT_EQ(without.exitCode, 2);
    EXPECT_THAT(without.err, HasSubstr("box.smat, which is neither open nor beside"));
    const Ran options = smatBatch({"explain", file, "--pixel", "1,1", "--width", "9"});
    EXPECT_EQ(options.exitCode, 2);
    EXPECT_THAT(options.err, HasSubstr("an image says how it was computed"));
}

struct Bad {
    const char* name;
    std::vector<std::string> options;
    const char* says;
};
void PrintTo(const Bad& bad, std::ostream* out) {
    *out << bad.name;
}

class BadPixel : public testing::TestWithParam<Bad> {};
TEST_P(BadPixel, IsRefusedWithASentence) {
    std::vector<std::string> arguments{"explain", sphere, "--width", "64", "--height", "48"};
    arguments.insert(arguments.end(), GetParam().options.begin(), GetParam().options.end());
    const Ran ran = smatBatch(arguments);
    EXPECT_EQ(ran.exitCode, 2);
    EXPECT_TRUE(ran.out.empty());
    EXPECT_THAT(ran.err, HasSubstr(GetParam().says));
}
INSTANTIATE_TEST_SUITE_P(
    Explain, BadPixel,
    testing::Values(Bad{"None", {}, "--pixel"},
                    Bad{"Right", {"--pixel", "64,0"}, "columns 0 to 63 and rows 0 to 47"},
                    Bad{"Below", {"--pixel", "0,48"}, "found 0,48"},
                    Bad{"Negative", {"--pixel=-1,0"}, "found -1,0"},
                    Bad{"OneNumber", {"--pixel", "12"}, "column and row of a pixel"},
                    Bad{"Words", {"--pixel", "a,b"}, "column and row of a pixel"},
                    Bad{"Trailing", {"--pixel", "1,2,3"}, "column and row of a pixel"},
                    Bad{"Fraction", {"--pixel", "1.5,2"}, "column and row of a pixel"},
                    Bad{"Bands", {"--pixel", "1,2", "--band", "3-5", "--band", "8-12"}, "one band"},
                    Bad{"Analysis", {"--pixel", "1,2", "--analysis", "nothing"}, "nothing"}),
    [](const auto& one) { return std::string(one.param.name); });

/// Pixels of a sample, the same on every machine, drawn from its whole picture and its middle.
class PixelsOfSamples : public SmatBatchExplain, public testing::WithParamInterface<const char*> {};
TEST_P(PixelsOfSamples, AreWhatIsDrawn) {
    constexpr int side = 96, count = 60;
    std::vector<std::string> arguments{
        "explain",  sample(GetParam()),   "--json",        "--width", std::to_string(side),
        "--height", std::to_string(side), "--light-error", "0.1"};
    std::mt19937 random(7);
    for (int i = 0; i < count; ++i) {
        const int within = i % 2 == 0 ? side : side / 3, first = (side - within) / 2;
        const auto place = [&] {
            return first + static_cast<int>(random() % static_cast<unsigned>(within));
        };
        const int x = place();
        arguments.insert(arguments.end(),
                         {"--pixel", std::to_string(x) + "," + std::to_string(place())});
    }
    const Ran ran = smatBatch(arguments);
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    int inside = 0;
    const auto json = nlohmann::json::parse(ran.out);
    ASSERT_EQ(json["pixels"].size(), static_cast<std::size_t>(count));
    for (const auto& pixel : json["pixels"]) {
        if (!pixel["same_facet_3x3"].get<bool>()) {
            continue;
        }
        ++inside;
        // Of terrain with a fine texture OpenGL's own interpolation is a part.
        const double most = pixel["remarks"].empty() ? 1e-5 : 1e-3;
        EXPECT_LT(std::abs(pixel["relative_difference"].get<double>()), most) << pixel.dump(1);
    }
    EXPECT_GT(inside, 0);
}
INSTANTIATE_TEST_SUITE_P(Samples, PixelsOfSamples,
                         testing::Values("box/box.smat", "chessboard/chessboard.smat",
                                         "corvette/corvette.smat", "heron/heron.smat",
                                         "ship/ship.smat", "sphere/sphere.smat", "tern/tern.smat",
                                         "turboprop4/turboprop4.smat", "valley/valley.smat"),
                         [](const auto& one) {
                             const std::string file = one.param;
                             return file.substr(0, file.find('/'));
                         });

} // namespace
} // namespace smat::test
