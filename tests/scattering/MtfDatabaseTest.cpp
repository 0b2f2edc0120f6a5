#include "irsg/scattering/MtfDatabase.h"

#include <bit>
#include <cmath>
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/core/Errors.h"
#include "tests/scattering/SmallDatabase.h"

namespace irsg {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(MtfDatabase, ComesBackAsItWasWritten) {
    const auto file = std::filesystem::temp_directory_path() / "round.mtf";
    const MtfDatabase written = smallDatabase();
    written.write(file);
    // 40 + 8 n + M (8 + 8 n), report table 21.
    EXPECT_EQ(std::filesystem::file_size(file), 40u + 8 * 4 + 2 * (8 + 8 * 4));
    const MtfDatabase read = MtfDatabase::read(file);
    EXPECT_EQ(read.header(), written.header());
    EXPECT_EQ(read.frequencies_per_rad(), written.frequencies_per_rad());
    EXPECT_EQ(read.opticalDepths(), written.opticalDepths());
    EXPECT_EQ(read.values(1), written.values(1));
}

TEST(MtfDatabase, IsLittleEndianByteByByte) {
    const std::string bytes = smallDatabase().bytes();
    // 1.0 as the field of view, then 2 curves and 4 points.
    EXPECT_EQ(bytes.substr(0, 8), std::string("\0\0\0\0\0\0\xf0\x3f", 8));
    EXPECT_EQ(bytes.substr(32, 8), std::string("\2\0\0\0\4\0\0\0", 8));
}

TEST(MtfDatabase, InterpolatesTheLogarithmInOpticalDepth) {
    const MtfDatabase database = smallDatabase();
    EXPECT_EQ(database.at(1.0, "p").values(), database.values(0));
    EXPECT_EQ(database.at(2.0, "p").values().front(), database.values(1).front());
    EXPECT_NEAR(database.at(1.5, "p").values()[1],
                std::sqrt(database.values(0)[1] * database.values(1)[1]), 1e-14);
    EXPECT_NEAR(database.at(0.25, "p").values()[0], std::exp(0.25 * 0.9), 1e-12);
    EXPECT_THAT(database.at(0.0, "p").values(), ElementsAre(1.0, 1.0, 1.0, 1.0));
}

TEST(MtfDatabase, IsMonotoneBetweenItsFrequencies) {
    const MtfCurve curve = smallDatabase().at(2.0, "p");
    double last = curve.at(0.0);
    for (double f = 0.0; f <= 120.0; f += 0.25) {
        EXPECT_LE(curve.at(f), last);
        last = curve.at(f);
    }
    EXPECT_EQ(curve.at(1e9), curve.direct());
}

TEST(MtfDatabase, RefusesWhatItDoesNotReach) {
    try {
        smallDatabase().at(2.5, "the path to 'ship'");
        FAIL();
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("the path to 'ship'"));
        EXPECT_THAT(error.what(), HasSubstr("2.5"));
        EXPECT_THAT(error.what(), HasSubstr("at most the 2"));
    }
    EXPECT_THROW(smallDatabase().at(-0.1, "p"), InputError);
    EXPECT_THROW(smallDatabase().at(std::nan(""), "p"), InputError);
}

TEST(MtfDatabase, TellsWhatItIs) {
    const std::vector<std::string> lines = smallDatabase().description();
    EXPECT_THAT(lines, testing::Contains(HasSubstr("field of view: 57.296 deg")));
    EXPECT_THAT(lines, testing::Contains(HasSubstr("particle diameter: 100 um")));
    EXPECT_THAT(lines, testing::Contains(HasSubstr("wavelength: 4 um")));
    EXPECT_TRUE(smallDatabase().remarks().empty());
    MtfHeader odd = smallDatabase().header();
    odd.particleDiameter_m = 100.0;
    odd.waveFrequency_Hz = 4.0;
    const MtfDatabase strange(odd, {0.0, 1.0}, {1.0}, {{2.0, 1.5}});
    EXPECT_EQ(strange.remarks().size(), 3u);
}

} // namespace
} // namespace irsg
