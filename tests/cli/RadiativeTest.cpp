#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "irsg/image/ExrFile.h"
#include "smatcore/data/ResultTable.h"
#include "tests/atmosphere/KarmaSupport.h"
#include "tests/cli/Program.h"
#include "tests/support/BinComparison.h"
#include "tests/support/TemporaryFolder.h"

namespace smat::test {
namespace {

using testing::HasSubstr;

const std::string haze = "# name: haze\n# air_temperature [K]: 290\n# ground_temperature [K]: 300\n"
                         "# sky_temperature [K]: 230\nwavelength [um],extinction [km-1]\n"
                         "2.5,1\n4,3\n6,2\n13,4\n";

class SmatBatchRadiative : public testing::Test {
  protected:
    void SetUp() override { write(folder / "haze.csv", haze); }

    /// An Environment of `haze.csv` behind `near.csv`, which knows 3 to 5 um alone.
    void writeWorld() {
        write(folder / "near.csv", "# name: near\n# air_temperature [K]: 270\n"
                                   "wavelength [um],extinction [km-1]\n3,0\n5,0\n");
        write(folder / "world.xml",
              irsg::environmentXml(irsg::numberXml("SunAzimuth", "0.5235987755982988") +
                                   irsg::numberXml("SunElevation", "1.0471975511965976") +
                                   "<composition>\n" + irsg::compositeXml("far", "haze.csv", 2) +
                                   irsg::compositeXml("near", "near.csv", 1) + "</composition>"));
    }

    ResultTable made(std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), "radiative");
        arguments.insert(arguments.end(), {"--out", "s.csv"});
        const Ran ran = smatBatch(arguments, folder.path());
        EXPECT_EQ(ran.exitCode, 0) << ran.err;
        return ResultTable::load(folder / "s.csv");
    }

    /// The sphere from above and ahead, with everything that takes part of the air.
    irsg::RadianceImage imageIn(const std::string& atmosphere, const std::string& out,
                                int backgroundRows = 0) {
        const Ran ran = smatBatch({"image",
                                   sample("sphere/sphere.smat"),
                                   "--atmosphere",
                                   atmosphere,
                                   "--elevation",
                                   "30",
                                   "--altitude",
                                   "1000",
                                   "--sun",
                                   "smart",
                                   "--ambient-reflection",
                                   "smart",
                                   "--width",
                                   "64",
                                   "--height",
                                   "64",
                                   "--set",
                                   "render.backgroundRows=" + std::to_string(backgroundRows),
                                   "--out",
                                   out},
                                  folder.path());
        EXPECT_EQ(ran.exitCode, 0) << ran.err;
        return irsg::readExr(folder / out);
    }

    const TemporaryFolder folder;
};

TEST_F(SmatBatchRadiative, WritesTheTransmittanceOfBeersLaw) {
    const ResultTable table = made({"haze.csv", "--quantity", "transmittance", "--sensor-altitude",
                                    "10", "--altitude", "10", "--range", "2000"});
    ASSERT_EQ(table.columns().size(), 3u);
    EXPECT_EQ(table.columns()[0].header(), "wavenumber [cm-1]");
    EXPECT_EQ(table.columns()[1].header(), "wavelength [um]");
    EXPECT_EQ(table.columns()[2].header(), "transmittance");
    EXPECT_NEAR(table.columns()[2].values.front(), std::exp(-5.0), 1e-6); // 5 um: 2.5 km-1
    EXPECT_EQ(table.provenance.value("atmosphere"), "haze");
    EXPECT_EQ(table.provenance.value("target_altitude [m]"), "10");
    EXPECT_NE(table.provenance.value("band_mean_transmittance"), "");
    EXPECT_THAT(table.provenance.value("command"), HasSubstr("--quantity transmittance"));
}

TEST_F(SmatBatchRadiative, TakesSeveralQuantitiesAndAPathToSpace) {
    const ResultTable table =
        made({"none", "--quantity", "transmittance", "--quantity", "path", "--sensor-altitude", "0",
              "--los-elevation", "90", "--to-space", "--band", "8-12"});
    EXPECT_EQ(table.columns().size(), 4u);
    EXPECT_EQ(table.provenance.value("range [m]"), "1e+05");
    EXPECT_EQ(table.provenance.value("in_band_path_radiance [W m-2 sr-1]"), "0");
}

TEST_F(SmatBatchRadiative, WritesJsonToAFileAndToItsOutput) {
    const Ran ran = smatBatch({"radiative", "haze.csv", "--quantity", "sun", "--altitude", "500",
                               "--out", "s.json", "--json"},
                              folder.path());
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    const auto json = nlohmann::json::parse(ran.out);
    EXPECT_EQ(json["kind"], "radiative");
    EXPECT_EQ(json["files"][0], "s.json");
    EXPECT_EQ(json["summary"][0]["label"], "in_band_solar_irradiance");
    EXPECT_EQ(json["summary"][0]["unit"], "W m-2");
    EXPECT_EQ(json["table"], nlohmann::json::parse(contentOf(folder / "s.json")));

    const Ran alone =
        smatBatch({"radiative", "haze.csv", "--quantity", "sun", "--altitude", "500", "--json"},
                  folder.path());
    ASSERT_EQ(alone.exitCode, 0) << alone.err;
    const auto printed = nlohmann::json::parse(alone.out);
    EXPECT_TRUE(printed["files"].empty());
    EXPECT_EQ(printed["summary"], json["summary"]);
    EXPECT_EQ(printed["table"]["columns"], json["table"]["columns"]);
}

TEST_F(SmatBatchRadiative, AnImageInExportedAirIsTheImageInTheAirItself) {
    // A camera in front of the nose looks south.
    made({"haze.csv", "--quantity", "all", "--sensor-altitude", "1050", "--altitude", "1000",
          "--range", "100", "--los-azimuth", "180"});
    // Spectra of one line of sight have one background; automatic rows know it.
    const irsg::RadianceImage original = imageIn("haze.csv", "a.exr", 1);
    const irsg::RadianceImage again = imageIn("s.csv", "b.exr");
    ASSERT_EQ(original.primary().values.size(), again.primary().values.size());
    double largest = 0.0;
    for (std::size_t i = 0; i < original.primary().values.size(); ++i) {
        const double expected = original.primary().values[i];
        EXPECT_NEAR(again.primary().values[i], expected, 1e-6 * expected) << i;
        largest = std::max(largest, expected);
    }
    EXPECT_GT(largest, 0.0);
    EXPECT_THAT(again.attributes.at("answered by"), HasSubstr("haze, spectra of s.csv"));

    // The air is seen in these images: without it they differ.
    const irsg::RadianceImage clear = imageIn("none", "c.exr");
    EXPECT_GT(std::abs(clear.at(32, 32) - original.at(32, 32)), 0.01 * original.at(32, 32));
}

TEST_F(SmatBatchRadiative, AnImageOfAnotherGeometryIsRefusedByName) {
    made({"haze.csv", "--quantity", "all", "--sensor-altitude", "1050", "--altitude", "1000",
          "--range", "100", "--los-azimuth", "180"});
    const Ran ran =
        smatBatch({"image", sample("sphere/sphere.smat"), "--atmosphere", "s.csv", "--elevation",
                   "30", "--altitude", "1000", "--range", "200", "--out", "a.exr"},
                  folder.path());
    EXPECT_EQ(ran.exitCode, 2);
    EXPECT_THAT(ran.err, HasSubstr("haze, spectra of s.csv: sensor altitude: found 1100 m, "
                                   "expected 1050 m"));
}

TEST_F(SmatBatchRadiative, ATemperatureProfileListsAltitudes) {
    const Ran ran = smatBatch({"temperature-profile", "haze.csv", "--min", "0", "--max", "1000",
                               "--step", "250", "--out", "t.csv", "--json"},
                              folder.path());
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    EXPECT_EQ(nlohmann::json::parse(ran.out)["kind"], "temperature-profile");
    const ResultTable table = ResultTable::load(folder / "t.csv");
    EXPECT_THAT(table.find("altitude")->values, testing::ElementsAre(0, 250, 500, 750, 1000));
    EXPECT_THAT(table.find("temperature")->values, testing::Each(290.0));
}

TEST_F(SmatBatchRadiative, TheFirstAtmosphereOfAnEnvironmentThatHoldsTheBandAnswers) {
    writeWorld();
    const std::vector<std::string> asked = {
        "world.xml", "--quantity", "transmittance", "--sensor-altitude", "10", "--altitude",
        "10",        "--range",    "2000",          "--los-elevation",   "0"};
    const auto madeIn = [&](const std::string& band) {
        auto arguments = asked;
        arguments.insert(arguments.end(), {"--band", band});
        return made(arguments);
    };
    const ResultTable inner = madeIn("3-5");
    EXPECT_THAT(inner.find("transmittance")->values, testing::Each(1.0));
    EXPECT_EQ(inner.provenance.value("answered by"), "transmittance: near");
    EXPECT_EQ(inner.provenance.value("ambient_temperature [K]"), "270");
    // A nanometre more is too much for the first.
    const ResultTable outer = madeIn("2.999-5");
    EXPECT_NEAR(outer.find("transmittance")->values.front(), std::exp(-5.0), 1e-6);
    EXPECT_EQ(outer.provenance.value("answered by"), "transmittance: haze");
}

TEST_F(SmatBatchRadiative, OfSeveralAtmospheresTheFirstThatHoldsTheBandAnswers) {
    writeWorld();
    const auto madeIn = [&](const std::string& band) {
        return made({"near.csv", "haze.csv", "--quantity", "transmittance", "--sensor-altitude",
                     "10", "--altitude", "10", "--range", "2000", "--los-elevation", "0", "--band",
                     band});
    };
    EXPECT_EQ(madeIn("3-5").provenance.value("answered by"), "transmittance: near");
    EXPECT_EQ(madeIn("2.999-5").provenance.value("answered by"), "transmittance: haze");

    const Ran ran = smatBatch({"temperature-profile", "near.csv", "haze.csv", "--min", "0", "--max",
                               "10", "--step", "10", "--out", "t.csv"},
                              folder.path());
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    EXPECT_THAT(ResultTable::load(folder / "t.csv").find("temperature")->values,
                testing::Each(270.0));
}

TEST_F(SmatBatchRadiative, SaysWhatIsWrongWithEveryAtmosphere) {
    const Ran ran = smatBatch({"radiative", "no.csv", "haze.csv", "nor.xml", "--quantity", "all",
                               "--sensor-altitude", "10", "--altitude", "10", "--range", "2000",
                               "--out", "s.csv"},
                              folder.path());
    EXPECT_EQ(ran.exitCode, 2);
    EXPECT_THAT(ran.err, testing::AllOf(HasSubstr("no.csv"), HasSubstr("nor.xml")));
}

TEST_F(SmatBatchRadiative, TheSunOfAnEnvironmentHoldsWhereTheCommandSetsNone) {
    writeWorld();
    const std::vector<std::string> asked = {"world.xml", "--quantity", "sun", "--altitude", "0"};
    const ResultTable own = made(asked);
    EXPECT_EQ(own.provenance.value("sun_azimuth [deg]"), "30");
    EXPECT_EQ(own.provenance.value("sun_elevation [deg]"), "60");
    auto lower = asked;
    lower.insert(lower.end(), {"--sun-elevation", "20"});
    const ResultTable set = made(lower);
    EXPECT_EQ(set.provenance.value("sun_azimuth [deg]"), "30");
    EXPECT_EQ(set.provenance.value("sun_elevation [deg]"), "20");
}

TEST_F(SmatBatchRadiative, ATemperatureProfileOfAnEnvironmentIsThatOfItsFirst) {
    writeWorld();
    const Ran ran = smatBatch({"temperature-profile", "world.xml", "--min", "0", "--max", "1000",
                               "--step", "500", "--out", "t.csv"},
                              folder.path());
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    const ResultTable table = ResultTable::load(folder / "t.csv");
    EXPECT_THAT(table.find("temperature")->values, testing::Each(270.0));
    EXPECT_EQ(table.provenance.value("answered by"), "ambient temperature: near");
}

TEST_F(SmatBatchRadiative, WithoutAtmospheresTheDefaultBackgroundAnswers) {
    write(folder / "world.xml",
          irsg::environmentXml(irsg::vectorXml("BackgroundRadianceWavelengths", "3 5") +
                               irsg::vectorXml("BackgroundRadianceValues", "2 2")));
    const ResultTable table = made({"world.xml", "--quantity", "background", "--sensor-altitude",
                                    "0", "--los-elevation", "10"});
    EXPECT_EQ(table.provenance.value("in_band_background_radiance [W m-2 sr-1]"), "4");
    EXPECT_EQ(table.provenance.value("answered by"), "background radiance: default");
}

TEST_F(SmatBatchRadiative, WithTheSunOffHasNoneOfItsLight) {
    const ResultTable dark = made({"none", "--quantity", "sun", "--altitude", "0", "--sun", "off"});
    EXPECT_THAT(dark.find("solar_irradiance")->values, testing::Each(0.0));
    EXPECT_EQ(dark.provenance.value("sun_elevation [deg]"), "-90");
    const ResultTable lit =
        made({"none", "--quantity", "sun", "--altitude", "0", "--sun", "smart"});
    EXPECT_GT(lit.find("solar_irradiance")->values.front(), 0.0);
    const Ran ran = smatBatch({"radiative", "none", "--quantity", "sun", "--altitude", "0", "--sun",
                               "shining", "--out", "s.csv"},
                              folder.path());
    EXPECT_EQ(ran.exitCode, 2);
    EXPECT_THAT(ran.err, testing::AllOf(HasSubstr("--sun"), HasSubstr("shining")));
}

// The published example of NREL's Solar Position Algorithm (TP-560-34302).
TEST_F(SmatBatchRadiative, PlacesTheSunOfAMomentAndAPlace) {
    const std::vector<std::string> moment{
        "--date",   "2003-10-17",           "--utc",
        "19:30:30", "--latitude=39.742476", "--longitude=-105.1786"};
    std::vector<std::string> arguments{"none", "--quantity", "sun", "--altitude", "1830"};
    arguments.insert(arguments.end(), moment.begin(), moment.end());
    const ResultTable table = made(arguments);
    const auto number = [&](const char* key) { return std::stod(table.provenance.value(key)); };
    EXPECT_NEAR(number("sun_azimuth [deg]"), 194.340241, 1e-3);
    EXPECT_NEAR(number("sun_elevation [deg]"), 39.872046, 1e-3);
    EXPECT_NEAR(number("sun_distance [au]"), 0.9965423, 1e-6);
}

TEST_F(SmatBatchRadiative, RefusesHalfAMomentAndASunBesideIt) {
    const auto refusal = [&](std::vector<std::string> more) {
        std::vector<std::string> arguments{"radiative",  "none", "--quantity", "sun",
                                           "--altitude", "0",    "--out",      "s.csv"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Ran ran = smatBatch(arguments, folder.path());
        EXPECT_EQ(ran.exitCode, 2) << ran.out;
        return ran.err;
    };
    const std::vector<std::string> whole{"--date",   "2003-10-17",    "--utc",
                                         "19:30:30", "--latitude=40", "--longitude=-105"};
    const auto with = [&](std::vector<std::string> more) {
        more.insert(more.begin(), whole.begin(), whole.end());
        return more;
    };
    EXPECT_THAT(refusal({"--date", "2003-10-17"}), HasSubstr("--longitude"));
    EXPECT_THAT(refusal({"--utc", "12:00", "--latitude=0", "--longitude=0"}), HasSubstr("--date"));
    EXPECT_THAT(
        refusal({"--date", "2003-02-30", "--utc", "12:00", "--latitude=0", "--longitude=0"}),
        HasSubstr("2003-02-30"));
    EXPECT_THAT(
        refusal({"--date", "2003-02-03", "--utc", "12:61", "--latitude=91", "--longitude=361"}),
        testing::AllOf(HasSubstr("12:61"), HasSubstr("91"), HasSubstr("361")));
    EXPECT_THAT(refusal(with({"--sun-elevation", "20"})), HasSubstr("--sun-elevation"));
    EXPECT_THAT(refusal(with({"--sun-azimuth", "20"})), HasSubstr("--sun-azimuth"));
    EXPECT_THAT(refusal(with({"--day-of-year", "20"})), HasSubstr("--day-of-year"));
    EXPECT_THAT(refusal({"--day-of-year", "367"}), HasSubstr("366"));
    EXPECT_THAT(refusal({"--day-of-year", "0"}), HasSubstr("366"));
    const Ran image = smatBatch({"image", sample("sphere/sphere.smat"), "--date", "2003-10-17",
                                 "--utc", "19:30:30", "--latitude=40", "--longitude=-105",
                                 "--sun-elevation", "3", "--out", "x.exr"},
                                folder.path());
    EXPECT_EQ(image.exitCode, 2);
    EXPECT_THAT(image.err, HasSubstr("--sun-elevation"));
}

TEST_F(SmatBatchRadiative, InfoTellsWhatAnOutputWasMadeFor) {
    made({"haze.csv", "--quantity", "all", "--sensor-altitude", "1050", "--altitude", "1000",
          "--range", "100", "--sun-elevation", "20"});
    const Ran ran = smatBatch({"atmosphere", "info", "s.csv"}, folder.path());
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    for (const char* line : {"sensor altitude 1050 m", "target altitude 1000 m", "range 100 m",
                             "los elevation -30", "sun elevation 20 deg"}) {
        EXPECT_THAT(ran.out, HasSubstr(line));
    }
}

TEST_F(SmatBatchRadiative, BinsOfAnyWidthTellTheSameOfRealAir) {
    const auto madeWith = [&](const char* resolution) {
        return made({sample("../resources/atmospheres/midlatitude-summer-rural-23km.xml").string(),
                     "--quantity", "transmittance", "--quantity", "path", "--band", "8-12",
                     "--sensor-altitude", "200", "--altitude", "3000", "--range", "6000",
                     "--resolution", resolution});
    };
    const ResultTable narrow = madeWith("1");
    const ResultTable wide = madeWith("15");
    EXPECT_GT(narrow.rowCount(), 14 * wide.rowCount());
    for (const char* column : {"transmittance", "path_radiance"}) {
        const BinComparison found = compareBins(narrow, 1.0, wide, 15.0, column);
        EXPECT_GE(found.bins, 26u);
        EXPECT_LE(found.rms, 0.006 * found.largest) << column;
        EXPECT_LE(found.worst, 0.03 * found.largest) << column;
    }
    for (const char* number : {"band_mean_transmittance", "in_band_path_radiance [W m-2 sr-1]"}) {
        const double expected = std::stod(narrow.provenance.value(number));
        EXPECT_NEAR(std::stod(wide.provenance.value(number)) / expected, 1.0, 0.005) << number;
    }
}

} // namespace
} // namespace smat::test
