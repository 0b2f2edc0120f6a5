#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/core/Errors.h"
#include "smatcore/settings/Settings.h"
#include "smatcore/support/NearestNames.h"

namespace smat::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

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
        NearRow{"AnotherLetter", "polor", {"polar"}},
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
    EXPECT_EQ(oneOf({"polar", "range"}, "rang"), "one of polar, range; did you mean 'range'?");
}

TEST(FormerNames, AreReadAndTheNamesOfTodayWritten) {
    Settings settings;
    settings.set("render.fluxes", "off");
    settings.set("render.hotParts", "false");
    settings.set("render.referenceAir", "segment");
    settings.setFromArgument("environment.bins=own");
    settings.setFromArgument("render.supersampling= inAll ");
    const std::map<std::string, std::string, std::less<>> today = {
        {"environment.bins", "native"},
        {"render.ambientReflection", "off"},
        {"render.hotSpots", "false"},
        {"render.referenceTransmittance", "segment"},
        {"render.supersampling", "perPixel"}};
    EXPECT_EQ(settings.values(), today);
}

TEST(FormerNames, HaveARemarkEach) {
    EXPECT_THAT(formerNameRemarks("render.fluxes", "off"),
                ElementsAre("render.fluxes is called render.ambientReflection now"));
    EXPECT_THAT(formerNameRemarks("render.supersampling", "inAll"),
                ElementsAre("the value inAll of render.supersampling is called perPixel now"));
    EXPECT_THAT(formerNameRemarks("render.supersampling", "perPixel"), IsEmpty());
    EXPECT_THAT(formerNameRemarks("render.nothing", "inAll"), IsEmpty());
}

TEST(FormerNames, AreNoNamesOfOtherSettings) {
    for (const SettingInfo& setting : settingTable()) {
        for (const std::string& key : setting.former.keys) {
            EXPECT_EQ(findSetting(key), &setting) << key;
            EXPECT_THROW(settingInfo(key), irsg::LogicError) << "the program names those of today";
        }
        for (const auto& [word, today] : setting.former.choices) {
            EXPECT_THAT(setting.choices, testing::Contains(today));
            EXPECT_THAT(setting.choices, testing::Not(testing::Contains(word)));
        }
    }
}

} // namespace
} // namespace smat::test
