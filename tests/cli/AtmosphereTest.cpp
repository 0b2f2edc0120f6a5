#include <cmath>
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "irsg/atmosphere/TabulatedAtmosphere.h"
#include "smatcore/data/ResultTable.h"
#include "tests/atmosphere/KarmaSupport.h"
#include "tests/atmosphere/SyntheticTape7.h"
#include "tests/cli/Program.h"
#include "tests/support/TemporaryFolder.h"

namespace smat::test {
namespace {

using testing::HasSubstr;

/// Writes a tape7 of a horizontal path and says where.
std::string tape7File(const TemporaryFolder& folder, const std::string& name, double range_km) {
    irsg::SyntheticRun run;
    run.range_km = range_km;
    run.depth = [range_km](double) { return 0.1 * range_km; };
    write(folder.path() / name, irsg::tape7(run));
    return (folder.path() / name).string();
}

TEST(SmatBatchAtmosphere, InfoTellsWhatARunSupports) {
    const TemporaryFolder folder;
    const Ran ran = smatBatch({"atmosphere", "info", tape7File(folder, "tape7", 2.0)});
    EXPECT_EQ(ran.exitCode, 0) << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("supports transmittance, path radiance"));
    EXPECT_THAT(ran.out, HasSubstr("range up to 2000 m (1 path)"));
    EXPECT_THAT(ran.out, HasSubstr("not known, no run lies between two others"));
}

TEST(SmatBatchAtmosphere, ImportWritesOneTableOfAFamily) {
    const TemporaryFolder folder;
    const std::string out = (folder.path() / "family.smatatm").string();
    const Ran ran =
        smatBatch({"atmosphere", "import", tape7File(folder, "a", 1.0), tape7File(folder, "b", 2.0),
                   tape7File(folder, "c", 5.0), "--out", out});
    EXPECT_EQ(ran.exitCode, 0) << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("3 runs, 5 wavenumbers"));
    const auto json = nlohmann::json::parse(smatBatch({"atmosphere", "info", out, "--json"}).out);
    EXPECT_EQ(json["table"]["runs"].size(), 3u);
    EXPECT_EQ(json["table"]["interpolation_errors"][0]["quantity"], "transmittance");
    EXPECT_LT(json["table"]["interpolation_errors"][0]["worst"].get<double>(), 1e-6);
}

/// A table of air over exactly the wavelengths of a band, along a horizontal path at 1000 m.
std::string tableOver(double min_um, double max_um) {
    irsg::SpectralRun run;
    run.source = "table";
    run.kind = irsg::RunKind::thermalRadiance;
    run.geometry.sensorAltitude_m = run.geometry.targetAltitude_m = 1000.0;
    run.geometry.range_m = 2000.0;
    run.wavenumbers_per_cm = {1e4 / max_um, 0.5e4 / max_um + 0.5e4 / min_um, 1e4 / min_um};
    run.transmittance.assign(3, 0.5);
    run.pathRadiance_W_m2_sr_um.assign(3, 2.0);
    run.totalRadiance_W_m2_sr_um.assign(3, 3.0);
    return irsg::TabulatedAtmosphere({run}, "table").toText();
}

TEST(SmatBatchAtmosphere, ResultsOfAFamilySayHowFarItsNearestRunIs) {
    const TemporaryFolder folder;
    const std::string out = (folder.path() / "family.smatatm").string();
    ASSERT_EQ(smatBatch({"atmosphere", "import", tape7File(folder, "a", 1.0),
                         tape7File(folder, "b", 2.0), tape7File(folder, "c", 5.0), "--out", out})
                  .exitCode,
              0);
    const auto providedBy = [&](const char* range_m) {
        const std::string file = (folder.path() / "out.csv").string();
        const Ran ran = smatBatch({"radiative", out, "--quantity", "transmittance", "--band",
                                   "4.91-4.99", "--sensor-altitude", "0", "--altitude", "0",
                                   "--range", range_m, "--out", file});
        EXPECT_EQ(ran.exitCode, 0) << ran.err;
        return ResultTable::load(file).provenance.value("answered by");
    };
    EXPECT_THAT(providedBy("2000"),
                HasSubstr("(nearest run at most 0 m in altitude, 0 m in range"));
    EXPECT_THAT(providedBy("3400"),
                HasSubstr("(nearest run at most 0 m in altitude, 1400 m in range away)"));
}

TEST(SmatBatchAtmosphere, GivesASpectrumInBothWindowsFromEveryFileThatIsShipped) {
    const TemporaryFolder folder;
    int files = 0;
    for (const auto& file :
         std::filesystem::directory_iterator(sample("../resources/atmospheres"))) {
        ++files;
        for (const std::string band : {"3-5", "8-12"}) {
            const Ran ran =
                smatBatch({"spectrum", sample("box/box.smat"), "--band", band, "--atmosphere",
                           file.path(), "--resolution", "50", "--shadows", "off", "--bounces", "0",
                           "--width", "16", "--height", "16", "--out", folder / "o.csv"});
            ASSERT_EQ(ran.exitCode, 0) << file.path() << ", " << band << ": " << ran.err;
            const ResultTable table = ResultTable::load(folder / "o.csv");
            const ResultColumn* wavelengths = table.find("wavelength");
            ASSERT_NE(wavelengths, nullptr);
            // From end to end.
            EXPECT_EQ(wavelengths->values.front(), band == "3-5" ? 5.0 : 12.0) << file.path();
            EXPECT_EQ(wavelengths->values.back(), band == "3-5" ? 3.0 : 8.0) << file.path();
            for (const double value : table.find("spectral_intensity")->values) {
                EXPECT_TRUE(std::isfinite(value) && value >= 0.0) << file.path() << ", " << band;
            }
        }
    }
    EXPECT_GE(files, 5);
}

TEST(SmatBatchAtmosphere, GivesASpectrumFromEndToEndOfItsTable) {
    const TemporaryFolder folder;
    for (const auto& [min_um, max_um, band] :
         {std::tuple{3.0, 5.0, "3-5"}, std::tuple{8.0, 12.0, "8-12"}}) {
        write(folder / "air.smatatm", tableOver(min_um, max_um));
        const Ran ran = smatBatch({"spectrum",     sample("sphere/sphere.smat"),
                                   "--band",       band,
                                   "--atmosphere", folder / "air.smatatm",
                                   "--set",        "render.sun=off",
                                   "--set",        "render.ambientReflection=off",
                                   "--background", "none",
                                   "--elevation",  "0",
                                   "--altitude",   "1000",
                                   "--range",      "1000",
                                   "--set",        "spectrum.resolution=20",
                                   "--width",      "32",
                                   "--height",     "32",
                                   "--out",        folder / "o.csv"});
        ASSERT_EQ(ran.exitCode, 0) << band << ": " << ran.err;
        const auto table = smat::ResultTable::load(folder / "o.csv");
        ASSERT_GT(table.rowCount(), 10u);
        ASSERT_EQ(table.columns().at(1).key, "wavelength");
        const auto& wavelengths_um = table.columns().at(1).values;
        EXPECT_NEAR(wavelengths_um.front(), max_um, 1e-12);
        EXPECT_NEAR(wavelengths_um.back(), min_um, 1e-12);
    }
}

TEST(SmatBatchAtmosphere, InfoOfAHomogeneousAtmosphereTellsItsTemperatures) {
    const TemporaryFolder folder;
    write(folder.path() / "air.csv",
          "# air_temperature [K]: 280\nwavelength [um],extinction [km-1]\n3,0.1\n5,0.1\n");
    const Ran ran = smatBatch({"atmosphere", "info", (folder.path() / "air.csv").string()});
    EXPECT_EQ(ran.exitCode, 0) << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("base 3 to 5 um"));
    EXPECT_THAT(ran.out, HasSubstr("homogeneous air of 280 K"));
}

TEST(SmatBatchAtmosphere, InfoOfAnAtmosphereSmartMarksWhatDiffersFromTheDefault) {
    const TemporaryFolder folder;
    write(folder.path() / "air.xml",
          irsg::smartXml(irsg::numberXml("Visibility", "23000") +
                         irsg::numberXml("Co2_ppmv", "380") + irsg::numberXml("AirMass", "3")));
    const std::string file = (folder.path() / "air.xml").string();
    const Ran ran = smatBatch({"atmosphere", "info", file});
    EXPECT_EQ(ran.exitCode, 0) << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("base 3 to 5 um"));
    EXPECT_THAT(ran.out, HasSubstr("spectral and wideband-ck"));
    EXPECT_THAT(ran.out, HasSubstr("35 parameters, 2 not as by default (*)"));
    EXPECT_THAT(ran.out, HasSubstr("* Visibility                  23000 m  (default 0)"));
    EXPECT_THAT(ran.out, HasSubstr("* Co2_ppmv                    380 ppmv  (default 400)"));
    EXPECT_THAT(ran.out, HasSubstr("  AirMass                     3\n"));
    EXPECT_THAT(ran.out, HasSubstr("at the ground 294.20 K, 1013.0 hPa, relative humidity 76 %, "
                                   "CO2 380 ppmv"));
    EXPECT_THAT(ran.out, HasSubstr("remark: no AerosolModel"));

    const auto json = nlohmann::json::parse(smatBatch({"atmosphere", "info", file, "--json"}).out);
    const auto& parameters = json["smart"]["parameters"];
    ASSERT_EQ(parameters.size(), 35u);
    for (const auto& parameter : parameters) {
        const bool differs = parameter["name"] == "Visibility" || parameter["name"] == "Co2_ppmv";
        EXPECT_EQ(parameter["differs"], differs) << parameter;
    }
    EXPECT_EQ(json["smart"]["ground_air"]["temperature_K"], 294.2);
}

/// A parameter of a file of AtmosphereSmart as `atmosphere info` tells it.
std::string valueIn(const std::string& file, const std::string& name) {
    const auto json = nlohmann::json::parse(smatBatch({"atmosphere", "info", file, "--json"}).out);
    for (const auto& parameter : json["smart"]["parameters"]) {
        if (parameter["name"] == name) {
            return parameter["value"].is_string() ? parameter["value"].get<std::string>()
                                                  : parameter["value"].dump();
        }
    }
    return "none";
}

TEST(SmatBatchAtmosphere, NewAndSetWriteEveryParameterThatInfoTells) {
    const TemporaryFolder folder;
    const std::string file = (folder.path() / "air.xml").string();
    ASSERT_EQ(smatBatch({"atmosphere", "new", "AerosolModel=2", "--out", file}).exitCode, 0);
    const auto json = nlohmann::json::parse(smatBatch({"atmosphere", "info", file, "--json"}).out);
    ASSERT_EQ(json["smart"]["parameters"].size(), 35u);
    // Every one is given its own value anew.
    std::vector<std::string> all = {"atmosphere", "set", file};
    for (const auto& parameter : json["smart"]["parameters"]) {
        if (parameter["name"] == "Radiosonde") {
            continue;
        }
        std::string value;
        for (const auto& number : parameter["value"].is_array()
                                      ? parameter["value"]
                                      : nlohmann::json::array({parameter["value"]})) {
            value += (value.empty() ? "" : " ") +
                     (number.is_string() ? number.get<std::string>() : number.dump());
        }
        all.push_back(parameter["name"].get<std::string>() + "=" + value);
    }
    const std::string before = contentOf(file);
    const Ran ran = smatBatch(all);
    EXPECT_EQ(ran.exitCode, 0) << ran.err;
    EXPECT_EQ(contentOf(file), before);
    const std::string other = (folder.path() / "other.xml").string();
    const std::string unchanged = contentOf(file);
    ASSERT_EQ(smatBatch({"atmosphere", "set", file, "visibility=7000", "AlbedoValues=0.1, 0.2",
                         "AlbedoWavelengths=3 12", "OzoneScale=1.5", "--out", other})
                  .exitCode,
              0);
    EXPECT_EQ(contentOf(file), unchanged);
    EXPECT_EQ(std::stod(valueIn(other, "Visibility")), 7000.0);
    EXPECT_EQ(std::stod(valueIn(other, "OzoneScale")), 1.5);
    EXPECT_EQ(std::stod(valueIn(other, "AerosolModel")), 2.0);
}

TEST(SmatBatchAtmosphere, SetKeepsWhatItDoesNotKnow) {
    const TemporaryFolder folder;
    write(folder.path() / "air.xml",
          irsg::smartXml("<!-- mine -->" + irsg::numberXml("Visibility", "23000.0") +
                         irsg::numberXml("MyOwn", "1.50")));
    const std::string file = (folder.path() / "air.xml").string();
    ASSERT_EQ(smatBatch({"atmosphere", "set", file, "GroundTemperature=5"}).exitCode, 0);
    for (const char* kept : {"<!-- mine -->", "23000.0", "1.50", "MyOwn"}) {
        EXPECT_THAT(contentOf(file), HasSubstr(kept));
    }
    EXPECT_EQ(std::stod(valueIn(file, "GroundTemperature")), 5.0);
}

TEST(SmatBatchAtmosphere, NewAndSetRefuseEveryWrongValueByName) {
    const TemporaryFolder folder;
    const std::string file = (folder.path() / "air.xml").string();
    ASSERT_EQ(smatBatch({"atmosphere", "new", "--out", file}).exitCode, 0);
    const std::string before = contentOf(file);
    struct Wrong {
        const char *assignment, *name, *value;
    };
    for (const Wrong& wrong :
         {Wrong{"Visibility", "NAME=VALUE", "'Visibility'"}, Wrong{"=5", "NAME=VALUE", "'=5'"},
          Wrong{"Visbility=5000", "Visbility", "no such parameter"},
          Wrong{"Visibility=far", "Visibility", "'far'"},
          Wrong{"Visibility=-1", "Visibility", "-1"}, Wrong{"Visibility=nan", "Visibility", "nan"},
          Wrong{"Visibility=1e999", "Visibility", "1e999"},
          Wrong{"Visibility=", "Visibility", "''"}, Wrong{"Visibility=5,5", "Visibility", "'5,5'"},
          Wrong{"AerosolModel=1.5", "AerosolModel", "'1.5'"},
          Wrong{"AerosolModel=8", "AerosolModel", "8"},
          Wrong{"AerosolModel=1e12", "AerosolModel", "1e12"},
          Wrong{"CloudModel=11", "CloudModel", "11"}, Wrong{"Resolution=2", "Resolution", "2"},
          Wrong{"AlbedoValues=0.1 x", "AlbedoValues", "'0.1 x'"},
          Wrong{"AlbedoValues=", "AlbedoValues", "''"},
          Wrong{"AlbedoValues=0.1 0.2", "Albedo", "2"},
          Wrong{"BaseWavelengthMin=6", "BaseWavelengthMin", "6"},
          Wrong{"ModelType=OTHER", "ModelType", "OTHER"}}) {
        const Ran ran = smatBatch({"atmosphere", "set", file, wrong.assignment});
        EXPECT_EQ(ran.exitCode, 2) << wrong.assignment << ran.err;
        EXPECT_THAT(ran.err, HasSubstr(wrong.name)) << wrong.assignment;
        EXPECT_THAT(ran.err, HasSubstr(wrong.value)) << wrong.assignment;
        EXPECT_EQ(contentOf(file), before) << wrong.assignment;
    }
    const Ran two = smatBatch({"atmosphere", "set", file, "Visibility=far", "AirMass=x"});
    EXPECT_THAT(two.err, HasSubstr("Visibility"));
    EXPECT_THAT(two.err, HasSubstr("AirMass"));
}

TEST(SmatBatchAtmosphere, InfoOfAnEnvironmentListsItsAtmospheresInTheOrderTheyAreAsked) {
    const TemporaryFolder folder;
    write(folder.path() / "air.xml", irsg::smartXml(""));
    write(folder.path() / "haze.csv", "wavelength [um],extinction [km-1]\n2,0.1\n12,0.1\n");
    write(folder.path() / "world.xml",
          irsg::environmentXml(irsg::numberXml("SunAzimuth", "0") +
                               irsg::numberXml("SunElevation", "0.5235987755982988") +
                               irsg::vectorXml("BackgroundRadianceWavelengths", "3 5") +
                               irsg::vectorXml("BackgroundRadianceValues", "1 3") +
                               "<composition>\n" + irsg::compositeXml("rest", "haze.csv", 5) +
                               irsg::compositeXml("SMARTI", "air.xml", 1) + "</composition>"));
    const std::string file = (folder.path() / "world.xml").string();
    const Ran ran = smatBatch({"atmosphere", "info", file});
    EXPECT_EQ(ran.exitCode, 0) << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("sun at azimuth 0 deg, elevation 30 deg"));
    EXPECT_THAT(ran.out, HasSubstr("default background from 3 to 5 um, 2 nodes"));
    EXPECT_THAT(ran.out, HasSubstr("2 atmospheres; the first that provides a quantity"));
    EXPECT_THAT(ran.out, HasSubstr("1. SMARTI (priority 1): AtmosphereSmart (air.xml)\n"
                                   "       base 3 to 5 um"));
    EXPECT_THAT(ran.out, HasSubstr("2. rest (priority 5): Beer-Lambert (haze.csv)\n"
                                   "       base 2 to 12 um"));

    const auto json = nlohmann::json::parse(smatBatch({"atmosphere", "info", file, "--json"}).out);
    EXPECT_EQ(json["kind"], "environment");
    ASSERT_EQ(json["atmospheres"].size(), 2u);
    EXPECT_EQ(json["atmospheres"][0]["entry"], "SMARTI");
    EXPECT_EQ(json["atmospheres"][0]["smart"]["parameters"].size(), 35u);
    EXPECT_EQ(json["atmospheres"][1]["air_temperature_K"], 288.15);
    EXPECT_EQ(json["default_background"]["wavelengths_um"][1], 5.0);
}

TEST(SmatBatchAtmosphere, InfoKnowsTheWordsForNoAir) {
    const Ran ran = smatBatch({"atmosphere", "info", "none"});
    EXPECT_EQ(ran.exitCode, 0) << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("none: vacuum"));
}

TEST(SmatBatchAtmosphere, WhatDoesNotBelongTogetherIsRefused) {
    const TemporaryFolder folder;
    const std::string run = tape7File(folder, "a", 1.0);
    const std::string out = (folder.path() / "x.smatatm").string();
    const Ran twice = smatBatch({"atmosphere", "import", run, run, "--out", out});
    EXPECT_EQ(twice.exitCode, 2);
    EXPECT_THAT(twice.err, HasSubstr("/a again"));
    EXPECT_FALSE(std::filesystem::exists(out));
    const Ran nothing = smatBatch({"atmosphere", "info", (folder.path() / "no").string()});
    EXPECT_EQ(nothing.exitCode, 2);
}

} // namespace
} // namespace smat::test
