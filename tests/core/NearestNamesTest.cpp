#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "smatcore/support/NearestNames.h"

namespace smat::test {
namespace {

using testing::ElementsAre;

struct NearRow {
    const char* name;
    const char* word;
    std::vector<std::string> nearest;
};

void PrintTo(const NearRow& row, std::ostream* out) {
    *out << row.name;
}

const std::vector<std::string> names = {"polar",      "power",      "range",
                                        "sensor.fov", "state.mach", "temperature-profile",
                                        "--azimuth",  "--altitude", "perPixel"};

class NearNames : public testing::TestWithParam<NearRow> {};

TEST_P(NearNames, AreThoseOfTheFewestEdits) {
    EXPECT_EQ(nearestNames(GetParam().word, names), GetParam().nearest);
}

INSTANTIATE_TEST_SUITE_P(
    Words, NearNames,
    testing::Values(
        NearRow{"AnotherLetter", "poler", {"polar"}},
        NearRow{"NeighboursSwapped", "rnage", {"range"}}, NearRow{"ALetterLess", "polr", {"polar"}},
        NearRow{"ALetterMore", "rangee", {"range"}}, NearRow{"UpperCase", "POLAR", {"polar"}},
        NearRow{"SeveralEquallyNear", "powar", {"polar", "power"}},
        NearRow{"TheLastPartOfAKey", "fov", {"sensor.fov"}},
        NearRow{"AKeyWithItsSection", "state.mahc", {"state.mach"}},
        NearRow{"TheBeginning", "temp", {"temperature-profile"}},
        NearRow{"AnOption", "--azimut", {"--azimuth"}},
        NearRow{"OneEditForEveryThreeLetters", "--atlitdue", {"--altitude"}},
        NearRow{"WordsRunTogether", "perpixel", {"perPixel"}}, NearRow{"TooFar", "spectrum", {}},
        NearRow{"ANumber", "15", {}}, NearRow{"Nothing", "", {}}, NearRow{"DashesAlone", "--", {}}),
    [](const auto& row) { return std::string(row.param.name); });

TEST(NearestNames, AreAtMostThree) {
    EXPECT_THAT(nearestNames("ac", {"ab", "ad", "ae", "af"}), ElementsAre("ab", "ad", "ae"));
}

TEST(NearestNames, StandAtTheEndOfAMessage) {
    EXPECT_EQ(didYouMean("powar", names), "; did you mean 'polar' or 'power'?");
    EXPECT_EQ(didYouMean("spectrum", names), "");
}

} // namespace
} // namespace smat::test
