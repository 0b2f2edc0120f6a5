#include "irsg/atmosphere/import/EnvironmentXml.h"

#include <cstdlib>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/atmosphere/AtmosphereFile.h"
#include "irsg/radiometry/Units.h"
#include "tests/atmosphere/KarmaSupport.h"
#include "tests/support/SharedMaterial.h"

namespace irsg {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;

const char* const haze = "wavelength [um],extinction [km-1]\n3,0.1\n5,0.1\n";

EnvironmentReading readOf(const std::string& inside) {
    return environmentFromKarma(KarmaXml::parse(environmentXml(inside), "world.xml"));
}

TEST(EnvironmentXml, TheFileOfTheReportIsReadAndComesBackEqual) {
    const auto file = smat::test::sharedMaterial("data/karma/Environment.xml");
    if (file.empty()) {
        GTEST_SKIP() << "the KARMA files of the shared material are not here";
    }
    KarmaXml document = KarmaXml::read(file);
    const EnvironmentReading reading = environmentFromKarma(document);
    const EnvironmentParameters& parameters = reading.parameters;
    EXPECT_EQ(parameters.sun.azimuth_rad, 0.0);
    EXPECT_EQ(parameters.sun.elevation_rad, 0.7854);
    EXPECT_EQ(*parameters.background,
              Spectrum({3.0, 4.0, 5.0}, {0.05, 0.3, 1.2}, Spectrum::Outside::zero));
    ASSERT_EQ(parameters.composition.size(), 1u);
    EXPECT_EQ(parameters.composition[0].name, "SMARTI");
    EXPECT_EQ(parameters.composition[0].component, "AtmosphereSmart");
    EXPECT_TRUE(reading.remarks.empty());
    toKarma(parameters, document);
    EXPECT_EQ(significant(document.text()), significant(contentOf(file)));
    // The report's own path leads nowhere here; the file of that name beside it is taken.
    const LoadedEnvironment loaded = loadEnvironment(file);
    ASSERT_EQ(loaded.environment.atmospheres().size(), 1u);
    EXPECT_EQ(loaded.environment.atmospheres()[0]->name(), "AtmosphereSmart (AtmosphereSmart.xml)");
}

TEST(EnvironmentXml, WhatIsWrittenIsReadBackEqual) {
    EnvironmentParameters parameters;
    parameters.sun = {1.25, -0.5};
    parameters.background = Spectrum({3.0, 4.1, 5.0}, {0.05, 0.3, 1.2}, Spectrum::Outside::zero);
    parameters.composition = {{"A", "AtmosphereSmart", "a\\b.xml", "none", -1, "asked first", 0},
                              {"B", "BeerLambert", "b.csv", "none", 7, "", 0}};
    KarmaXml document = toKarma(parameters);
    for (int round = 0; round < 2; ++round) {
        const EnvironmentReading again =
            environmentFromKarma(KarmaXml::parse(document.text(), "again.xml"));
        EXPECT_EQ(again.parameters.sun.azimuth_rad, 1.25);
        EXPECT_EQ(again.parameters.sun.elevation_rad, -0.5);
        EXPECT_EQ(again.parameters.background, parameters.background);
        EXPECT_EQ(again.parameters.composition, parameters.composition);
        toKarma(again.parameters, document);
    }
    parameters.background.reset();
    toKarma(parameters, document);
    EXPECT_THAT(document.text(), testing::Not(HasSubstr("BackgroundRadiance")));
}

TEST(EnvironmentXml, AtmospheresAreAskedByPriority) {
    const auto folder = ownFolder();
    writtenFile(folder / "sub" / "haze.csv", haze);
    writtenFile(folder / "summer.xml", smartXml(""));
    writtenFile(folder / "world.xml",
                environmentXml(
                    numberXml("SunAzimuth", "6.2832") + numberXml("SunElevation", "1.5708") +
                    "<composition>\n" + compositeXml("later", "$(KARMA_ROOT)\\sub\\haze.csv", 5) +
                    compositeXml("first", "C:\\far\\away\\summer.xml", -3) + "</composition>"));
    unsetenv("KARMA_ROOT");
    const LoadedEnvironment loaded = loadEnvironment(folder / "world.xml");
    ASSERT_EQ(loaded.environment.atmospheres().size(), 2u);
    EXPECT_EQ(loaded.environment.atmospheres()[0]->name(), "AtmosphereSmart (summer.xml)");
    EXPECT_EQ(loaded.environment.atmospheres()[1]->name(), "Beer-Lambert (haze.csv)");
    EXPECT_LE(loaded.environment.sun.elevation_rad, 0.5 * pi);
    // Each answer says who gave it.
    EXPECT_EQ(loaded.environment.ambientTemperature_K(0.0).providedBy,
              "AtmosphereSmart (summer.xml)");
}

TEST(EnvironmentXml, TheDefaultBackgroundAnswersWhereNoAtmosphereDoes) {
    const auto file = writtenFile(ownFolder() / "world.xml",
                                  environmentXml(vectorXml("BackgroundRadianceWavelengths", "3 5") +
                                                 vectorXml("BackgroundRadianceValues", "1 3")));
    const LoadedEnvironment loaded = loadEnvironment(file);
    const auto answer = loaded.environment.spectrum(
        AtmosphericQuery::backgroundRadiance({}, loaded.environment.sun), {3.0, 5.0});
    EXPECT_EQ(answer.providedBy, "default");
    EXPECT_EQ(answer.value.at(4.0), 2.0);
    EXPECT_EQ(answer.value.at(9.0), 0.0);
    EXPECT_THAT(loaded.remarks, Contains("no SunElevation: taken as 0.7854 rad"));
    EXPECT_THAT(loaded.remarks, Contains("no composition: no atmosphere"));
}

TEST(EnvironmentXml, IsToldFromOtherFiles) {
    const auto folder = ownFolder();
    const auto world = writtenFile(folder / "world.xml", "\n " + environmentXml("").substr(39));
    EXPECT_TRUE(isEnvironmentXml(world));
    EXPECT_FALSE(isEnvironmentXml(writtenFile(folder / "air.xml", smartXml(""))));
    EXPECT_FALSE(isEnvironmentXml(writtenFile(folder / "haze.csv", haze)));
    EXPECT_FALSE(isEnvironmentXml(writtenFile(folder / "cut.xml", "<data>")));
    EXPECT_FALSE(isEnvironmentXml(folder / "none.xml"));
    EXPECT_FALSE(isEnvironmentXml(folder));
    EXPECT_THAT(refusalOf([&] { loadAtmosphere(world); }),
                AllOf(HasSubstr("world.xml: type"), HasSubstr("an Environment holds several")));
    EXPECT_THAT(refusalOf([&] {
                    std::string text = smartXml("");
                    text.replace(text.find("/AtmosphereSmart/"), 17, "/Imaging/");
                    text.replace(text.find("/AtmosphereSmart"), 16, "/Sensor");
                    loadAtmosphere(writtenFile(folder / "sensor.xml", text));
                }),
                AllOf(HasSubstr("/Sensor'"), HasSubstr("/AtmosphereSmart")));
}

TEST(EnvironmentXml, FaultsOfAllFilesAreToldTogether) {
    const auto folder = ownFolder();
    writtenFile(folder / "bad.xml", smartXml(numberXml("AirMass", "0")));
    writtenFile(folder / "world.xml",
                environmentXml("<composition>\n" + compositeXml("one", "bad.xml", 0) +
                               compositeXml("two", "missing.xml", 1) + "</composition>"));
    EXPECT_THAT(refusalOf([&] { loadEnvironment(folder / "world.xml"); }),
                AllOf(HasSubstr("bad.xml: line 5, parameter AirMass"),
                      HasSubstr("world.xml: line 7, composite two"), HasSubstr("missing.xml")));
}

struct BadEnvironment {
    const char* name;
    std::string inside;
    std::vector<const char*> says;
};
void PrintTo(const BadEnvironment& row, std::ostream* stream) {
    *stream << row.name;
}

class BadEnvironmentXml : public testing::TestWithParam<BadEnvironment> {};

TEST_P(BadEnvironmentXml, IsRefusedByName) {
    const std::string message = refusalOf([] { readOf(GetParam().inside); });
    EXPECT_THAT(message, HasSubstr("world.xml: line 5"));
    for (const char* words : GetParam().says) {
        EXPECT_THAT(message, HasSubstr(words));
    }
}

INSTANTIATE_TEST_SUITE_P(
    Files, BadEnvironmentXml,
    testing::Values(BadEnvironment{"aSunAzimuthInDegrees",
                                   numberXml("SunAzimuth", "180"),
                                   {"SunAzimuth", "180 rad", "0 to 2 pi rad"}},
                    BadEnvironment{
                        "aSunAzimuthBelowZero", numberXml("SunAzimuth", "-0.1"), {"-0.1 rad"}},
                    BadEnvironment{"aSunBehindTheZenith",
                                   numberXml("SunElevation", "1.6"),
                                   {"SunElevation", "1.6 rad", "-pi/2 to pi/2 rad"}},
                    BadEnvironment{"aSunThatIsAVector",
                                   vectorXml("SunElevation", "1 2"),
                                   {"SunElevation", "a vector", "a double"}},
                    BadEnvironment{"aBackgroundWithoutValues",
                                   vectorXml("BackgroundRadianceWavelengths", "3 5"),
                                   {"no BackgroundRadianceValues", "or neither"}},
                    BadEnvironment{"aBackgroundWithoutWavelengths",
                                   vectorXml("BackgroundRadianceValues", "3 5"),
                                   {"no BackgroundRadianceWavelengths"}},
                    BadEnvironment{"aBackgroundThatFalls",
                                   vectorXml("BackgroundRadianceWavelengths", "5 3") +
                                       vectorXml("BackgroundRadianceValues", "3 5"),
                                   {"BackgroundRadianceWavelengths", "ascending"}},
                    BadEnvironment{"aBackgroundOfOneWavelength",
                                   vectorXml("BackgroundRadianceWavelengths", "5") +
                                       vectorXml("BackgroundRadianceValues", "3"),
                                   {"at least two"}},
                    BadEnvironment{"aBackgroundOfZeroWavelength",
                                   vectorXml("BackgroundRadianceWavelengths", "0 5") +
                                       vectorXml("BackgroundRadianceValues", "3 3"),
                                   {"not positive"}},
                    BadEnvironment{"aCompositionInAComposition",
                                   "<composition>" + compositeXml("C", "c.xml", 0, "other.xml") +
                                       "</composition>",
                                   {"composite C", "'other.xml'", "none"}}),
    [](const auto& row) { return row.param.name; });

TEST(EnvironmentXml, ABackgroundOfOtherNumberOrBelowZeroIsRefused) {
    EXPECT_THAT(refusalOf([] {
                    readOf(vectorXml("BackgroundRadianceWavelengths", "3 4 5") +
                           vectorXml("BackgroundRadianceValues", "1 -2"));
                }),
                AllOf(HasSubstr("line 6, parameter BackgroundRadianceValues: found 2 numbers"),
                      HasSubstr("found -2 W m-2 sr-1 um-1, expected radiances of at least 0")));
    EXPECT_THAT(refusalOf([] { environmentFromKarma(KarmaXml("/A/B", "")); }),
                HasSubstr("/Environment"));
}

} // namespace
} // namespace irsg
