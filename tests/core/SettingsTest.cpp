#include "smatcore/settings/Settings.h"

#include <ostream>
#include <regex>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/core/CsvTable.h"
#include "irsg/core/Errors.h"
#include "smatcore/support/TextFile.h"

namespace smat {
namespace {

TEST(SettingTable, EverySettingIsDescribedInFull) {
    for (const SettingInfo& setting : settingTable()) {
        EXPECT_NE(setting.key.find('.'), std::string::npos) << setting.key;
        EXPECT_FALSE(setting.label.empty()) << setting.key;
        EXPECT_GE(setting.help.size(), 10u) << setting.key;
        EXPECT_EQ(setting.help.back(), '.') << setting.key;
        EXPECT_TRUE(setting.option.starts_with("--")) << setting.key;
        EXPECT_FALSE(setting.expected().empty()) << setting.key;
        EXPECT_FALSE(sectionTitle(setting.section()).empty()) << setting.key;
    }
}

TEST(SettingTable, EverySettingStandsOnItsPageAndThoseOfAnAnalysisInItsForm) {
    for (const SettingInfo& setting : settingTable()) {
        EXPECT_EQ(setting.page == SettingPage::none, isAnalysisSection(setting.section()))
            << setting.key;
    }
    EXPECT_EQ(settingsOn(SettingPage::scattering),
              (std::vector<std::string>{"render.scattering", "environment.mtf",
                                        "environment.scatteringCoefficient"}))
        << "by place before the order of the table";
}

TEST(SettingTable, EveryDefaultIsAValueInItsCanonicalForm) {
    for (const SettingInfo& setting : settingTable()) {
        EXPECT_EQ(canonicalText(setting, setting.defaultText), setting.defaultText) << setting.key;
    }
}

TEST(SettingTable, NumbersHaveARangeAndChoicesHaveChoices) {
    for (const SettingInfo& setting : settingTable()) {
        const bool isNumber =
            setting.kind == SettingKind::real || setting.kind == SettingKind::integer ||
            setting.kind == SettingKind::choiceOrReal || setting.kind == SettingKind::realList;
        EXPECT_EQ(isNumber, setting.minimum < setting.maximum) << setting.key;
        const bool isChoice = setting.kind == SettingKind::choice ||
                              setting.kind == SettingKind::choiceOrReal ||
                              setting.kind == SettingKind::realList;
        EXPECT_EQ(isChoice, !setting.choices.empty()) << setting.key;
    }
}

TEST(SettingTable, WordsForFormsStandForEachValue) {
    for (const SettingInfo& setting : settingTable()) {
        if (setting.names.empty()) {
            continue;
        }
        const std::set<std::string> words(setting.names.begin(), setting.names.end());
        EXPECT_EQ(words.size(), setting.names.size()) << setting.key;
        EXPECT_EQ(words.count(""), 0u) << setting.key;
        const auto values = setting.kind == SettingKind::choice
                                ? setting.choices.size()
                                : static_cast<std::size_t>(setting.maximum - setting.minimum) + 1;
        EXPECT_EQ(setting.names.size(), values) << setting.key;
    }
}

TEST(SettingTable, EveryHandleHasItsRow) {
    const std::string header = readTextFile(SMAT_SOURCE_DIR "/smatcore/settings/SettingKeys.h");
    const std::regex handle(R"re(Key \w+\{"([^"]+)"\};)re");
    int handles = 0;
    for (std::sregex_iterator found(header.begin(), header.end(), handle), end; found != end;
         ++found, ++handles) {
        EXPECT_NE(findSetting((*found)[1].str()), nullptr) << (*found)[1];
    }
    EXPECT_GT(handles, 50);
}

TEST(SettingTable, KeysAreUniqueAndSoAreTheOptionsOfOneCommand) {
    std::set<std::string> keys;
    std::set<std::string> common;
    std::set<std::pair<std::string, std::string>> ofAnalyses;
    for (const SettingInfo& setting : settingTable()) {
        EXPECT_TRUE(keys.insert(setting.key).second) << setting.key;
        if (isAnalysisSection(setting.section())) {
            EXPECT_TRUE(ofAnalyses.insert({setting.section(), setting.option}).second)
                << setting.key;
        } else {
            EXPECT_TRUE(common.insert(setting.option).second) << setting.key;
        }
    }
    for (const auto& [section, option] : ofAnalyses) {
        EXPECT_EQ(common.count(option), 0u) << section << " " << option;
    }
}

TEST(SettingTable, TheCommonOptionsOfTheFormatsPageAreThere) {
    std::set<std::string> options;
    for (const SettingInfo& setting : settingTable()) {
        options.insert(setting.option);
        // Their words are read, also where an option has another name today.
        options.insert(setting.former.options.begin(), setting.former.options.end());
    }
    for (const char* option :
         {"--range",       "--azimuth",       "--elevation", "--yaw",        "--pitch",
          "--roll",        "--altitude",      "--width",     "--height",     "--fov",
          "--band",        "--response",      "--mode",      "--atmosphere", "--antialiasing",
          "--sun-azimuth", "--sun-elevation", "--sun",       "--fluxes",     "--background",
          "--time",        "--power",         "--mach",      "--type",       "--step",
          "--offset",      "--from",          "--to",        "--points",     "--log",
          "--resolution",  "--quantity"}) {
        EXPECT_EQ(options.count(option), 1u) << option;
    }
}

TEST(SettingsManual, IsCurrentInDocs) {
    EXPECT_EQ(readTextFile(SMAT_SOURCE_DIR "/docs/settings.md"), settingsManual())
        << "write it anew: smat-batch settings --markdown > docs/settings.md";
}

struct TextRow {
    const char* name;
    const char* key;
    const char* text;
    const char* canonical; ///< null where it is refused
};

void PrintTo(const TextRow& row, std::ostream* out) {
    *out << row.name;
}

class SettingText : public testing::TestWithParam<TextRow> {};

TEST_P(SettingText, IsAcceptedInItsCanonicalFormOrRefusedWithKeyValueAndExpectation) {
    const TextRow& row = GetParam();
    Settings settings;
    if (row.canonical != nullptr) {
        settings.set(row.key, row.text);
        EXPECT_EQ(settings.text(row.key), row.canonical);
        return;
    }
    try {
        settings.set(row.key, row.text, "here");
        FAIL() << "accepted as " << settings.text(row.key);
    } catch (const irsg::InputError& error) {
        const irsg::Diagnostic& diagnostic = error.diagnostics().front();
        EXPECT_EQ(diagnostic.file, "here");
        EXPECT_EQ(diagnostic.position, row.key);
        EXPECT_EQ(diagnostic.value, row.text);
        EXPECT_FALSE(diagnostic.expected.empty());
    }
    EXPECT_EQ(settings, Settings());
}

INSTANTIATE_TEST_SUITE_P(
    Texts, SettingText,
    testing::Values(
        TextRow{"LeadingZeros", "sensor.width", "0640", "640"},
        TextRow{"ExponentOfAWholeNumber", "sensor.width", "1e3", "1000"},
        TextRow{"BlanksAround", "sensor.fov", " 2.50 ", "2.5"},
        TextRow{"MinusZero", "camera.azimuth", "-0", "0"},
        TextRow{"LowerEnd", "sensor.width", "1", "1"},
        TextRow{"UpperEnd", "sensor.width", "16384", "16384"},
        TextRow{"Choice", "render.sun", "off", "off"},
        TextRow{"ChoiceAmongNumbers", "render.background", "none", "none"},
        TextRow{"NumberAmongChoices", "render.background", "1.50", "1.5"},
        TextRow{"Band", "sensor.band", "8.0-12", "8-12"},
        TextRow{"BandsInTheirOrder", "sensor.band", "8-12, 3.0-5,3.4-4.1", "8-12,3-5,3.4-4.1"},
        TextRow{"BandTwice", "sensor.band", "3-5,8-12,3.0-5.0", nullptr},
        TextRow{"HoleAmongBands", "sensor.band", "3-5,,8-12", nullptr},
        TextRow{"NoBand", "sensor.band", "", nullptr},
        TextRow{"ListOfFiles", "environment.atmospheres", "a.csv ; b.csv", "a.csv;b.csv"},
        TextRow{"EmptyList", "environment.atmospheres", "", "none"},
        TextRow{"BelowLowerEnd", "sensor.width", "0", nullptr},
        TextRow{"AboveUpperEnd", "sensor.width", "16385", nullptr},
        TextRow{"FractionOfAPixel", "sensor.width", "640.5", nullptr},
        TextRow{"HugeInteger", "sensor.width", "1e30", nullptr},
        TextRow{"NoNumber", "sensor.fov", "wide", nullptr},
        TextRow{"NumberWithRest", "sensor.fov", "2deg", nullptr},
        TextRow{"NotANumber", "sensor.fov", "nan", nullptr},
        TextRow{"Infinity", "camera.range", "inf", nullptr},
        TextRow{"Nothing", "sensor.fov", "", nullptr},
        TextRow{"UnknownChoice", "render.sun", "bright", nullptr},
        TextRow{"UnknownMode", "sensor.mode", "fast", nullptr},
        TextRow{"AntialiasingModeThatIsNotThere", "render.antialiasing", "6", nullptr},
        TextRow{"NegativeBackground", "render.background", "-1", nullptr},
        TextRow{"ReversedBand", "sensor.band", "5-3", nullptr},
        TextRow{"BandOfOneNumber", "sensor.band", "4", nullptr},
        TextRow{"NoTruthValue", "range.log", "maybe", nullptr},
        TextRow{"HoleInAList", "environment.atmospheres", "a.csv;;b.csv", nullptr},
        TextRow{"UnknownKey", "sensor.widht", "640", nullptr}),
    [](const auto& row) { return row.param.name; });

TEST(Settings, NumbersReadBackExactly) {
    Settings settings;
    const double value = 0.1 + 0.2;
    settings.set("camera.range", value);
    EXPECT_EQ(settings[key::cameraRange], value);
}

TEST(Settings, AnOverrideOfTheDefaultValueStillOverrides) {
    Settings project;
    project.set("sensor.width", 320);
    Settings analysis;
    analysis.set("sensor.width", "640");
    EXPECT_EQ(project.with(analysis)[key::sensorWidth], 640);
    analysis.reset("sensor.width");
    EXPECT_EQ(project.with(analysis)[key::sensorWidth], 320);
}

TEST(Settings, ArgumentsOfSetNeedAnEqualsSign) {
    Settings settings;
    settings.setFromArgument("sensor.response=a=b.csv");
    EXPECT_EQ(settings.text("sensor.response"), "a=b.csv");
    EXPECT_THROW(settings.setFromArgument("sensor.width"), irsg::InputError);
}

TEST(Settings, AskingForAnotherKindIsOurOwnFault) {
    const Settings settings;
    EXPECT_THROW((void)settings[RealKey{"render.sun"}], irsg::LogicError);
    EXPECT_THROW((void)settings[IntegerKey{"sensor.fov"}], irsg::LogicError);
    EXPECT_THROW((void)settings.text("sensor.widht"), irsg::LogicError);
}

} // namespace
} // namespace smat
