#include <cmath>
#include <filesystem>
#include <regex>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/atmosphere/TabulatedAtmosphere.h"
#include "irsg/atmosphere/import/ModtranCsv.h"
#include "irsg/atmosphere/import/ModtranJson.h"
#include "irsg/radiometry/Units.h"
#include "tests/atmosphere/SyntheticTape7.h"
#include "tests/support/Refusal.h"
#include "tests/support/TemporaryFolder.h"

using namespace irsg;
using smat::test::refusalOf;
using smat::test::writtenFile;
using testing::HasSubstr;

namespace {

const std::string input = R"("MODTRANINPUT": {
    "NAME": "slant", "CASE": 0,
    "RTOPTIONS": {"IEMSCT": "RT_SOLAR_AND_THERMAL", "IMULT": "RT_DISORT"},
    "ATMOSPHERE": {"MODEL": "ATM_MIDLAT_SUMMER", "CO2MX": 400.0},
    "AEROSOLS": {"IHAZE": "AER_RURAL", "VIS": 23.0, "ICLD": "CLOUD_NONE"},
    "GEOMETRY": {"ITYPE": 2, "H1ALT": 0.5, "H2ALT": 2.5, "OBSZEN": 60.0, "IPARM": 12,
                 "PARM1": 90.0, "PARM2": 35.0},
    "SURFACE": {"SURFTYPE": "REFL_CONSTANT", "SURREF": 0.1, "GNDALT": 0.25},
    "SPECTRAL": {"V1": 2000.0, "V2": 2020.0, "DV": 10.0, "FWHM": 20.0, "XFLAG": "W"},
    "FILEOPTIONS": {"CSVPRNT": "slant.csv", "JSONPRNT": "slant.json"}})";
const std::string axis = R"("FREQ": [2000, 2010, 2020],)";
const std::string output = R"("MODTRANOUTPUT": {"SPECTRA": {"RADIANCE": {)" + axis + R"(
    "TOT_TRANS": [0.5, 0.25, 0.0], "THRML_EM": [3e-7, 3e-7, 3e-7], "THRML_SCT": [1e-8, 1e-8, 1e-8],
    "SURF_EMIS": [1e-7, 1e-7, 0], "MULT_SCAT": [2e-9, 2e-9, 2e-9], "SING_SCAT": [3e-9, 3e-9, 3e-9],
    "GRND_RFLT": [0, 0, 0], "TOTAL_RAD": [4.15e-7, 4.15e-7, 3.15e-7],
    "SOL_AT_OBS": [9e-7, 8e-7, 0], "DEPTH": [0.693147, 1.386294, 12.345], "BBODY_TK": [1, 1, 1]
  }}})";
const std::string document = "{\"MODTRAN\": [{" + input + ",\n" + output + "}]}";

const std::string rows = "2000,0.5,3e-7,1e-8,1e-7,2e-9,3e-9,0,0,4.15e-7,0,9e-7,0.693,1,1e-6,290\n"
                         "2010,0.25,3e-7,1e-8,1e-7,2e-9,3e-9,0,0,4.15e-7,0,8e-7,1.386,1,1e-6,290\n"
                         "2020,0,3e-7,1e-8,0,2e-9,3e-9,0,0,3.15e-7,0,0,12.345,1,1e-6,290\n";
const std::string names = "freq,tot_trans,pth_thrml,thrml_sct,surf_emis,sol_scat,sing_scat,"
                          "grnd_rflt,drct_rflt,total_rad,ref_sol,sol@obs,depth,dir_em,toa_sun,"
                          "bbody_t\n";
const std::string longNames =
    "case 0: slant,,,,,,,,,,,,,,,\n"
    "freq,total,path,path thermal,surface,path multiple,path single,ground,direct,total,reference,"
    "irradiance,- nat log,directional,top-of-atmosphere,brightness\n"
    "[cm-1],transmittance,emission,scat,emission,scat,scat,reflect,reflect,radiance,irradiance,"
    "at observer,path trans,emissivity,irradiance,temp\n";

} // namespace

TEST(ModtranJson, ReadsADocumentWithItsResults) {
    const std::vector<SpectralRun> runs = parseModtranJson(document, "slant.json");
    ASSERT_EQ(runs.size(), 1u);
    const SpectralRun& run = runs.front();
    EXPECT_EQ(run.source, "slant.json, case slant");
    EXPECT_EQ(run.kind, RunKind::solarRadiance);
    EXPECT_DOUBLE_EQ(run.geometry.sensorAltitude_m, 250.0);
    EXPECT_DOUBLE_EQ(run.geometry.targetAltitude_m, 2250.0);
    EXPECT_NEAR(run.geometry.range_m, 4000.0, 5.0);
    EXPECT_NEAR(*run.geometry.sunElevation_rad, radians(55.0), 1e-12);
    EXPECT_EQ(run.cards.at("MODEL"), 2.0);
    EXPECT_EQ(run.cards.at("CO2MX"), 400.0);
    EXPECT_EQ(run.wavenumbers_per_cm, (std::vector<double>{2000.0, 2010.0, 2020.0}));
    EXPECT_EQ(run.transmittance[1], 0.25);
    // The scattered parts stand beside the emitted: that closes with TOTAL_RAD.
    EXPECT_NEAR(run.pathRadiance_W_m2_sr_um[0], 3.15e-7 * 4e6, 1e-9);
    EXPECT_NEAR(run.totalRadiance_W_m2_sr_um[0], 4.15e-7 * 4e6, 1e-9);
    EXPECT_NEAR(run.solarIrradiance_W_m2_um[0], 9e-7 * 4e6, 1e-9);
    ASSERT_EQ(run.warnings.size(), 1u);
    EXPECT_THAT(run.warnings.front(), HasSubstr("chord"));
    EXPECT_TRUE(isModtranJson(document));
    EXPECT_FALSE(isModtranJson("[\"MODTRAN\"]"));
    EXPECT_FALSE(isModtranJson(""));
}

TEST(ModtranJson, AMissingAxisIsThatOfTheInput) {
    EXPECT_EQ(parseModtranJson(replaced(document, axis, ""), "x").front().wavenumbers_per_cm,
              (std::vector<double>{2000.0, 2010.0, 2020.0}));
}

TEST(ModtranJson, ARangeAndAZenithAngleLeadToTheTarget) {
    const std::string text = replaced(document, "\"H2ALT\": 2.5", "\"HRANGE\": 4.0");
    const RunGeometry geometry = parseModtranJson(text, "x").front().geometry;
    EXPECT_NEAR(geometry.targetAltitude_m, 250.0 + 2000.0, 2.0);
    EXPECT_DOUBLE_EQ(geometry.range_m, 4000.0);
}

TEST(ModtranJson, NumbersOfModtran5AndWordsAreTheSame) {
    EXPECT_EQ(parseModtranJson(replaced(document, "\"RT_SOLAR_AND_THERMAL\"", "2"), "x"),
              parseModtranJson(document, "x"));
}

TEST(ModtranJson, BadDocumentsAreRefusedByName) {
    const auto with = [&](const std::string& what, const std::string& by) {
        return replaced(document, what, by);
    };
    const struct {
        const char* name;
        std::string text;
        const char* says;
    } table[] = {
        {"no JSON", "{\"MODTRAN\": [", "found the end of the text"},
        {"a key twice", with("\"ITYPE\": 2", "\"ITYPE\": 2, /* once\nmore */ \"ITYPE\": 2"),
         "GEOMETRY.ITYPE: found a key that occurs twice"},
        {"a zero byte", document + std::string("\0}", 2), "found a zero byte"},
        {"foreign", "{}", "no array MODTRAN"},
        {"no cases", "{\"MODTRAN\": []}", "no array MODTRAN"},
        {"no results", "{\"MODTRAN\": [{" + input + "}]}", "results of the case"},
        {"no input", "{\"MODTRAN\": [{" + output + "}]}", "MODTRAN[0].MODTRANINPUT: found no such"},
        {"unknown kind", with("RT_SOLAR_AND_THERMAL", "RT_LUNAR_IRRADIANCE"),
         "RT_LUNAR_IRRADIANCE"},
        {"kind 7", with("\"RT_SOLAR_AND_THERMAL\"", "7"), "IEMSCT: found 7"},
        {"no ITYPE", with("\"ITYPE\": 2,", ""), "no ITYPE"},
        {"no H1ALT", with("\"H1ALT\": 0.5,", ""), "no H1ALT"},
        {"ITYPE 4", with("\"ITYPE\": 2", "\"ITYPE\": 4"), "found ITYPE 4"},
        {"a text for a number", with("\"H1ALT\": 0.5", "\"H1ALT\": \"low\""),
         "H1ALT: found \"low\""},
        {"lines of sight that are none", with("\"ITYPE\": 2,", "\"ITYPE\": 2, \"MLOS\": 2,"),
         "MLOS: found 2, expected an array"},
        {"a line of sight that is none", with("\"ITYPE\": 2,", "\"ITYPE\": 2, \"MLOS\": [{}, 7],"),
         "MLOS[1]: found 7, expected an object"},
        {"a line of sight without altitude",
         with("\"H1ALT\": 0.5,", "\"MLOS\": [{\"H1ALT\": 1}, {}],"), "MLOS[1]: found no H1ALT"},
        {"a text in a line of sight",
         with("\"ITYPE\": 2,", "\"ITYPE\": 2, \"MLOS\": [{\"OBSZEN\": \"up\"}],"),
         "MLOS[0].OBSZEN: found \"up\""},
        {"two lines of sight with one result",
         with("\"ITYPE\": 2,", "\"ITYPE\": 2, \"MLOS\": [{}, {\"OBSZEN\": 50}],"),
         "found results of one line of sight, expected an array of 2"},
        {"two lines of sight with three results",
         replaced(with("\"ITYPE\": 2,", "\"ITYPE\": 2, \"MLOS\": [{}, {\"OBSZEN\": 50}],"),
                  "{\"SPECTRA\"", "[{}, {}, {}], \"unused\": {\"SPECTRA\""),
         "MODTRANOUTPUT: found 3 results, expected 2"},
        {"a target that is not reached", with("60.0", "120.0"), "found RANGE 0"},
        {"unknown unit", with("\"XFLAG\": \"W\"", "\"XFLAG\": \"Q\""), "XFLAG: found Q"},
        {"no transmittance", with("TOT_TRANS", "XX_TRANS"), "no column TOT_TRANS"},
        {"no total", with("TOTAL_RAD", "XX_RAD"), "no column TOTAL_RAD"},
        {"arrays of two lengths", with("[0.5, 0.25, 0.0]", "[0.5, 0.25]"), "2 values, expected 3"},
        {"null", with("[0.5, 0.25, 0.0]", "[0.5, null, 0.0]"), "TOT_TRANS[1]: found null"},
        {"transmittance of 2", with("[0.5, 0.25, 0.0]", "[0.5, 2, 0.0]"), "found transmittance 2"},
        {"axis falls", with("[2000, 2010, 2020]", "[2000, 1990, 2020]"), "found wavenumber 1990"},
        {"an axis of another length",
         replaced(replaced(document, axis, ""), "\"V2\": 2020.0", "\"V2\": 3000.0"),
         "no array FREQ"},
    };
    for (const auto& row : table) {
        const std::string said = refusalOf([&] { parseModtranJson(row.text, "x.json"); });
        EXPECT_THAT(std::regex_replace(said, std::regex(", line [0-9]+:"), ":"),
                    HasSubstr(row.says))
            << row.name;
    }
}

/// Two lines of sight: the one of `input`, and one 10 deg higher from 1 km.
const std::string twoSights = replaced(
    input, "\"ITYPE\": 2,", "\"ITYPE\": 2, \"MLOS\": [{}, {\"OBSZEN\": 50.0, \"H1ALT\": 1.0}],");
const std::string radiance = output.substr(output.find("{\"RADIANCE\""),
                                           output.rfind("}}") + 1 - output.find("{\"RADIANCE\""));

TEST(ModtranJson, SeveralLinesOfSightAreSeveralRuns) {
    const std::string second = replaced(radiance, "0.25", "0.2");
    const std::string spectra = output.substr(output.find("{\"SPECTRA\""));
    const std::string group = radiance.substr(radiance.find(": {") + 2);
    const std::string groupOnly = group.substr(0, group.rfind('}'));
    const std::string spectra2 = replaced(spectra, "0.25", "0.2");
    for (const std::string& results : {"[" + spectra + ", " + spectra2 + "]",
                                       "{\"SPECTRA\": [" + radiance + ", " + second + "]}",
                                       "{\"SPECTRA\": {\"RADIANCE\": [" + groupOnly + ", " +
                                           replaced(groupOnly, "0.25", "0.2") + "]}}"}) {
        const std::string text =
            "{\"MODTRAN\": [{" + twoSights + ", \"MODTRANOUTPUT\": " + results + "}]}";
        const std::vector<SpectralRun> runs = parseModtranJson(text, "x.json");
        ASSERT_EQ(runs.size(), 2u) << text;
        const SpectralRun alone = parseModtranJson(document, "x.json").front();
        EXPECT_EQ(runs[0].geometry, alone.geometry);
        EXPECT_EQ(runs[0].transmittance, alone.transmittance);
        EXPECT_EQ(runs[0].source, "x.json, case slant, line of sight 1");
        EXPECT_DOUBLE_EQ(runs[1].geometry.sensorAltitude_m, 750.0);
        EXPECT_DOUBLE_EQ(runs[1].geometry.elevation_rad, radians(40.0));
        EXPECT_DOUBLE_EQ(runs[1].geometry.targetAltitude_m, alone.geometry.targetAltitude_m);
        EXPECT_EQ(runs[1].transmittance[1], 0.2);
        EXPECT_EQ(runs[1].pathRadiance_W_m2_sr_um, alone.pathRadiance_W_m2_sr_um);
    }
}

TEST(ModtranJson, ResultsAloneAreOfTheInputThatNamesThem) {
    const auto folder = smat::test::ownFolder();
    const std::string results = "{\"MODTRAN\": [{" + output + "}]}";
    const auto file = writtenFile(folder / "slant.json", results);
    ASSERT_TRUE(TabulatedAtmosphere::canImport(file));
    // Nobody names it.
    writtenFile(folder / "other.json",
                "{\"MODTRAN\": [{" + replaced(input, "slant.json", "else.json") + "}]}");
    EXPECT_THAT(refusalOf([&] { readModtranJson(file); }), HasSubstr("JSONPRNT names this file"));
    for (const char* named : {"slant.json", "out/slant.json", "slant"}) {
        writtenFile(folder / "run.json",
                    "{\"MODTRAN\": [{" + replaced(input, "slant.json", named) + "}]}");
        const SpectralRun run = readModtranJson(file).front();
        SpectralRun expected = parseModtranJson(document, "slant.json").front();
        EXPECT_EQ(run, expected) << named;
    }
    // As the commands and the window import it.
    const std::filesystem::path one[] = {file};
    EXPECT_EQ(TabulatedAtmosphere::import(one).runs().size(), 1u);
    // Documents of other runs, damaged ones and folders beside it are in nobody's way.
    writtenFile(folder / "a.json", R"({"MODTRAN": [{"MODTRANINPUT": {"RTOPTIONS": 1}}]})");
    std::filesystem::create_directory(folder / "b.json");
    EXPECT_EQ(TabulatedAtmosphere::import(one).runs().size(), 1u);
    // Where none names it, a damaged one may be the one.
    writtenFile(folder / "run.json", "{}");
    EXPECT_THAT(refusalOf([&] { readModtranJson(file); }), HasSubstr("a.json"));
    std::filesystem::remove(folder / "a.json");
    // Two cases, the second of two lines of sight.
    writtenFile(folder / "run.json", "{\"MODTRAN\": [{" + input + "}, {" + twoSights + "}]}");
    EXPECT_THAT(refusalOf([&] { readModtranJson(file); }), HasSubstr("found 1 cases, expected 2"));
    writtenFile(folder / "slant.json", "{\"MODTRAN\": [{" + output +
                                           "}, {\"MODTRANOUTPUT\": {\"SPECTRA\": [" + radiance +
                                           ", " + radiance + "]}}]}");
    const std::vector<SpectralRun> runs = readModtranJson(file);
    ASSERT_EQ(runs.size(), 3u);
    EXPECT_EQ(runs[1].geometry, runs[0].geometry);
    EXPECT_DOUBLE_EQ(runs[2].geometry.sensorAltitude_m, 750.0);
}

TEST(ModtranCsv, TakesItsGeometryFromTheDocumentBesideIt) {
    for (const std::string& header : {names, longNames}) {
        const auto folder = smat::test::ownFolder();
        writtenFile(folder / "anything.json", "{\"MODTRAN\": [{" + input + "}]}");
        writtenFile(folder / "other.json", "{\"x\": 1}");
        const std::filesystem::path file =
            writtenFile(folder / "slant.csv", header + rows + "-9999.,,,,,,,,,,,,,,,\n");
        ASSERT_TRUE(TabulatedAtmosphere::canImport(file));
        const std::vector<SpectralRun> runs = readModtranCsv(file);
        ASSERT_EQ(runs.size(), 1u) << header;
        const SpectralRun expected = parseModtranJson(document, "x").front();
        EXPECT_EQ(runs.front().geometry, expected.geometry);
        EXPECT_EQ(runs.front().wavenumbers_per_cm, expected.wavenumbers_per_cm);
        EXPECT_EQ(runs.front().transmittance[1], 0.25);
        for (std::size_t i = 0; i < 3; ++i) {
            EXPECT_NEAR(runs.front().pathRadiance_W_m2_sr_um[i],
                        expected.pathRadiance_W_m2_sr_um[i], 1e-12);
        }
        EXPECT_EQ(runs.front().solarIrradiance_W_m2_um, expected.solarIrradiance_W_m2_um);
    }
}

TEST(ModtranCsv, TakesItsGeometryFromItsComments) {
    const auto folder = smat::test::ownFolder();
    const std::filesystem::path file = writtenFile(
        folder / "run.csv", "# ITYPE: 1\n# IEMSCT: 1\n# H1: 2\n# RANGE: 3\n" + names + rows);
    const SpectralRun run = readModtranCsv(file).front();
    EXPECT_EQ(run.kind, RunKind::thermalRadiance);
    EXPECT_DOUBLE_EQ(run.geometry.sensorAltitude_m, 2000.0);
    EXPECT_DOUBLE_EQ(run.geometry.targetAltitude_m, 2000.0);
    EXPECT_DOUBLE_EQ(run.geometry.range_m, 3000.0);
}

TEST(ModtranCsv, WavelengthsAndTheirDensitiesAreTheSameAir) {
    const auto folder = smat::test::ownFolder();
    const std::string place = "# ITYPE: 1\n# IEMSCT: 1\n# H1: 0\n# RANGE: 3\n";
    const double perCm = 4e-7;
    char text[200];
    std::snprintf(text, sizeof text, "5,0.5,%.12g,%.12g\n6,0.5,1e-6,1e-6\n",
                  perCm * 2000.0 * 2000.0 * 1e-4, perCm * 2000.0 * 2000.0 * 1e-4);
    const SpectralRun microns =
        readModtranCsv(
            writtenFile(folder / "um.csv",
                        place + "wavelength,tot_trans,pth_thrml,total_rad\nmicrons,,,\n" + text))
            .front();
    EXPECT_NEAR(microns.wavenumbers_per_cm.back(), 2000.0, 1e-9);
    EXPECT_NEAR(microns.pathRadiance_W_m2_sr_um.back(), perCm * 4e6, 1e-9);
    std::snprintf(text, sizeof text, "5000,0.5,%.12g,%.12g\n6000,0.5,1,1\n",
                  perCm * 2000.0 * 2000.0 * 1e-1, perCm * 2000.0 * 2000.0 * 1e-1);
    const SpectralRun nanometres =
        readModtranCsv(
            writtenFile(folder / "nm.csv",
                        place + "wavelength,tot_trans,pth_thrml,total_rad\n[nm],,,\n" + text))
            .front();
    EXPECT_NEAR(nanometres.wavenumbers_per_cm.back(), 2000.0, 1e-9);
    EXPECT_NEAR(nanometres.pathRadiance_W_m2_sr_um.back(), perCm * 4e6, 1e-9);
}

TEST(ModtranCsv, SeveralCasesOfOneFileAreSeveralRuns) {
    const auto folder = smat::test::ownFolder();
    const std::string second = replaced(input, "\"H2ALT\": 2.5", "\"H2ALT\": 3.5");
    writtenFile(folder / "slant.json", "{\"MODTRAN\": [{" + input + "}, {" + second + "}]}");
    const std::vector<SpectralRun> runs =
        readModtranCsv(writtenFile(folder / "slant.csv", longNames + rows + longNames + rows));
    ASSERT_EQ(runs.size(), 2u);
    EXPECT_DOUBLE_EQ(runs[0].geometry.targetAltitude_m, 2250.0);
    EXPECT_DOUBLE_EQ(runs[1].geometry.targetAltitude_m, 3250.0);
}

TEST(ModtranCsv, BadFilesAreRefusedByName) {
    const std::string place = "# ITYPE: 1\n# IEMSCT: 1\n# H1: 0\n# RANGE: 3\n";
    const struct {
        const char* name;
        std::string text;
        const char* says;
    } table[] = {
        {"empty", "", "an empty table"},
        {"nothing but comments", place, "an empty table"},
        {"binary", std::string("a,b\n1\0,2\n", 9), "NUL"},
        {"no word about the line of sight", names + rows, "no word about the line of sight"},
        {"an unknown kind", "# ITYPE: 1\n# IEMSCT: 9\n" + names + rows, "IEMSCT 9"},
        {"no range", "# ITYPE: 1\n# IEMSCT: 1\n" + names + rows, "found RANGE 0"},
        {"no names", place + rows, "no header or no rows"},
        {"names alone", place + names, "no header or no rows"},
        {"no transmittance", place + replaced(names, "tot_trans", "x") + rows,
         "no column TOT_TRANS"},
        {"a word", place + names + replaced(rows, "0.25", "zero"),
         "line 7, column 2: found 'zero'"},
        {"a word on the axis", place + names + replaced(rows, "2010", "x2010"),
         "line 7, column 1: found 'x2010'"},
        {"nan", place + names + replaced(rows, "0.25", "nan"), "found 'nan'"},
        {"a blank", place + names + replaced(rows, "0.25", ""), "line 7: found a blank TOT_TRANS"},
        {"a short row", place + names + replaced(rows, ",1,1e-6,290\n2010", "\n2010"), "cells"},
        {"the axis falls", place + names + replaced(rows, "2010", "1910"), "wavenumber 1910"},
    };
    const auto folder = smat::test::ownFolder();
    for (const auto& row : table) {
        const std::filesystem::path file = writtenFile(folder / "bad.csv", row.text);
        EXPECT_THAT(refusalOf([&] { readModtranCsv(file); }), HasSubstr(row.says)) << row.name;
    }
    writtenFile(folder / "bad.json", "{\"MODTRAN\": [{" + input + "}, {" + input + "}]}");
    EXPECT_THAT(refusalOf([&] { readModtranCsv(writtenFile(folder / "bad.csv", names + rows)); }),
                HasSubstr("1 tables of numbers"));
    writtenFile(folder / "bad.json",
                "{\"MODTRAN\": [{" + replaced(input, "\"W\"", "\"M\"") + "}]}");
    EXPECT_THAT(
        refusalOf([&] { readModtranCsv(writtenFile(folder / "bad.csv", longNames + rows)); }),
        HasSubstr("SPECTRAL.XFLAG"));
}
