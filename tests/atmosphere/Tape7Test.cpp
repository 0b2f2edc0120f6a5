#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/atmosphere/TabulatedAtmosphere.h"
#include "irsg/atmosphere/import/Tape7.h"
#include "irsg/core/CsvTable.h"
#include "tests/atmosphere/SyntheticTape7.h"
#include "tests/support/Refusal.h"
#include "tests/support/SharedMaterial.h"

using namespace irsg;
using testing::HasSubstr;

namespace {

std::filesystem::path modtranFolder() {
    return smat::test::sharedMaterial("data/atmosphere/modtran");
}

/// Skips where the shared folder is absent.
#define NEEDS_MODTRAN_FILES()                                                                      \
    if (!std::filesystem::exists(modtranFolder() / "cards.csv")) {                                 \
        GTEST_SKIP() << "the MODTRAN results of the shared folder are not here";                   \
    }

std::vector<SpectralRun> parsed(const std::string& text) {
    return parseTape7(TextLines::parse(text, "tape7"));
}

std::string refusal(const std::string& text) {
    return smat::test::refusalOf([&] { TabulatedAtmosphere(parsed(text), "tape7"); });
}

std::string lineAt(const std::string& text, int number) {
    std::size_t begin = 0;
    for (int i = 1; i < number; ++i) {
        begin = text.find('\n', begin) + 1;
    }
    return text.substr(begin, text.find('\n', begin) - begin);
}

} // namespace

TEST(Tape7, ReadsARunAndConvertsItsUnits) {
    SyntheticRun made;
    made.path = 2;
    made.h1_km = 0.5;
    made.h2_km = 2.0;
    made.zenith_deg = 30.0;
    made.range_km = 1.73;
    made.ground_km = 0.25;
    const std::vector<SpectralRun> runs = parsed(tape7(made));
    ASSERT_EQ(runs.size(), 1u);
    const SpectralRun& run = runs.front();
    EXPECT_EQ(run.kind, RunKind::thermalRadiance);
    EXPECT_DOUBLE_EQ(run.geometry.sensorAltitude_m, 250.0);
    EXPECT_DOUBLE_EQ(run.geometry.targetAltitude_m, 1750.0);
    EXPECT_DOUBLE_EQ(run.geometry.range_m, 1730.0);
    EXPECT_NEAR(run.geometry.elevation_rad, radians(60.0), 1e-12);
    EXPECT_EQ(run.wavenumbers_per_cm, made.wavenumbers_per_cm);
    EXPECT_NEAR(run.transmittance[2], std::exp(-0.1), 1e-8);
    const double expected =
        (1.0 - std::exp(-0.1)) * planckRadiance_W_m2_sr_um(1e4 / 2020.0, made.temperature_K);
    EXPECT_NEAR(run.pathRadiance_W_m2_sr_um[2] / expected, 1.0, 1e-4);
    EXPECT_EQ(run.pathRadiance_W_m2_sr_um, run.totalRadiance_W_m2_sr_um);
    EXPECT_TRUE(run.warnings.empty());
}

TEST(Tape7, ReadsTheAsymmetryOfScatteringWhereItsLineGoesOnToIt) {
    const std::string text = tape7({});
    const std::string six = lineAt(text, 8);
    EXPECT_FALSE(parsed(text).front().cards.contains("G"));
    const std::string eight = replaced(text, six, six + "   0.00000   0.65000");
    EXPECT_EQ(parsed(eight).front().cards.at("G"), 0.65);
}

TEST(Tape7, ReadsSeveralRunsOfOneFile) {
    SyntheticRun near;
    SyntheticRun far;
    far.range_km = 5.0;
    const std::vector<SpectralRun> runs = parsed(tape7(near) + tape7(far) + "\n");
    ASSERT_EQ(runs.size(), 2u);
    EXPECT_EQ(runs[0].source, "tape7");
    EXPECT_EQ(runs[1].source, "tape7, run 2");
    EXPECT_DOUBLE_EQ(runs[1].geometry.range_m, 5000.0);
}

TEST(Tape7, OlderNamesWithBlanksMeanTheSameColumns) {
    const std::string text = tape7({});
    const std::string names = lineAt(text, 11);
    std::string older = names;
    std::ranges::replace(older, '_', ' ');
    EXPECT_EQ(parsed(replaced(text, names, older)), parsed(text));
}

TEST(Tape7, ScatteringIsRayleighAndWhatAerosolsDoNotAbsorb) {
    SyntheticRun made;
    made.kind = 0;
    made.depth = [](double) { return 0.25; };
    const SpectralRun run = parsed(tape7(made)).front();
    EXPECT_NEAR(run.scatteringDepth[1], 0.25, 1e-4);
    EXPECT_NEAR(run.transmittance[1], std::exp(-0.25), 1e-4);
}

TEST(Tape7, AnOpaqueLineKeepsItsDepth) {
    SyntheticRun made;
    made.kind = 0;
    made.depth = [](double) { return 23.456; };
    EXPECT_NEAR(-std::log(parsed(tape7(made)).front().transmittance[0]), 23.456, 1e-9);
}

TEST(Tape7, TheSumThatClosesDecidesWhatPathRadianceIs) {
    // Scattered light beside the emitted, or as a part of it.
    SpectralRun run;
    run.kind = RunKind::solarRadiance;
    RunTable table{.file = "x",
                   .positions = {"1", "2"},
                   .columns = {{RunColumn::wavenumber, {1000.0, 2000.0}},
                               {RunColumn::transmittance, {0.5, 0.5}},
                               {RunColumn::thermal, {3e-7, 3e-7}},
                               {RunColumn::thermalScatter, {1e-7, 1e-7}},
                               {RunColumn::solarScatter, {5e-8, 5e-8}},
                               {RunColumn::singleScatter, {2e-8, 2e-8}},
                               {RunColumn::surface, {1e-6, 1e-6}},
                               {RunColumn::total, {1.35e-6, 1.35e-6}}},
                   .unit = SpectralUnit::wavenumber,
                   .transmittanceRounding = 0.0,
                   .sumsIncluded = false};
    std::vector<Diagnostic> diagnostics;
    fillRun(run, table, diagnostics);
    EXPECT_NEAR(run.pathRadiance_W_m2_sr_um[0], 3.5e-7 * 1e6, 1e-9);
    table.columns[RunColumn::total] = {1.47e-6, 1.47e-6};
    SpectralRun apart = SpectralRun();
    apart.kind = run.kind;
    fillRun(apart, table, diagnostics);
    EXPECT_NEAR(apart.pathRadiance_W_m2_sr_um[0], 4.7e-7 * 1e6, 1e-9);
    EXPECT_TRUE(apart.warnings.empty());
    table.columns[RunColumn::total] = {3e-6, 3e-6};
    SpectralRun open = SpectralRun();
    open.kind = run.kind;
    fillRun(open, table, diagnostics);
    ASSERT_EQ(open.warnings.size(), 1u);
    EXPECT_THAT(open.warnings.front(), HasSubstr("TOTAL_RAD differs"));
    EXPECT_TRUE(diagnostics.empty());
}

TEST(Tape7, AnEarlyEndIsAWarningThatNamesTheLastWavenumber) {
    std::string text = tape7({});
    text.resize(text.find(" 2030.00"));
    const SpectralRun run = parsed(text).front();
    EXPECT_EQ(run.wavenumbers_per_cm.size(), 3u);
    ASSERT_EQ(run.warnings.size(), 1u);
    EXPECT_THAT(run.warnings.front(), HasSubstr("stops at 2020 cm-1"));

    // A complete table stops nowhere, whoever took the line behind it.
    std::string whole = tape7({});
    whole.resize(whole.find("-9999"));
    EXPECT_TRUE(parsed(whole).front().warnings.empty());
    EXPECT_EQ(parsed(whole).front().wavenumbers_per_cm,
              parsed(tape7({})).front().wavenumbers_per_cm);

    std::string cut = tape7({});
    cut.resize(cut.find(" 2030.00") + 15);
    const SpectralRun rest = parsed(cut).front();
    EXPECT_EQ(rest.wavenumbers_per_cm.size(), 3u);
    EXPECT_EQ(rest.warnings.size(), 2u);
}

TEST(Tape7, ASlantWithoutRangeIsTheChord) {
    SyntheticRun made;
    made.path = 2;
    made.h2_km = 10.0;
    made.zenith_deg = 0.0;
    made.range_km = 0.0;
    const SpectralRun run = parsed(tape7(made)).front();
    EXPECT_NEAR(run.geometry.range_m, 10000.0, 1e-6);
    EXPECT_THAT(run.warnings.front(), HasSubstr("chord"));
}

TEST(Tape7, ChordsOfASphere) {
    const double earth = 6371e3;
    EXPECT_NEAR(*chord_m(0.0, 1000.0, 0.5 * pi, earth), 1000.0, 1e-6);
    EXPECT_NEAR(*chord_m(1000.0, 0.0, -0.5 * pi, earth), 1000.0, 1e-6);
    EXPECT_NEAR(*chord_m(0.0, 1000.0, 0.0, earth), std::sqrt(1000.0 * (2 * earth + 1000.0)), 1e-6);
    EXPECT_FALSE(chord_m(10000.0, 0.0, -0.01, earth));
    EXPECT_FALSE(chord_m(1000.0, 0.0, 0.1, earth));
    // Down to the tangent and up again: the near and the far crossing are symmetric about it.
    const double elevation = -std::acos((earth + 500.0) / (earth + 1000.0));
    const double toTangent =
        std::sqrt((earth + 1000.0) * (earth + 1000.0) - (earth + 500.0) * (earth + 500.0));
    EXPECT_NEAR(*chord_m(1000.0, 700.0, elevation, earth) +
                    *chord_m(1000.0, 700.0, elevation, earth, true),
                2.0 * toTangent, 1e-3);
}

TEST(Tape7, NumbersOfFortran) {
    EXPECT_EQ(fortranNumber(" 1.5D-03 "), 1.5e-3);
    EXPECT_EQ(fortranNumber("8.1174-103"), 8.1174e-103);
    EXPECT_EQ(fortranNumber("30."), 30.0);
    EXPECT_FALSE(fortranNumber("*******"));
    EXPECT_FALSE(fortranNumber("NaN"));
    EXPECT_FALSE(fortranNumber(""));
}

TEST(Tape7, BadFilesAreRefusedByName) {
    const std::string good = tape7({});
    SyntheticRun transmittance;
    transmittance.kind = 0;
    SyntheticRun sun;
    sun.kind = 3;
    sun.path = 3;
    sun.zenith_deg = 30.0;
    SyntheticRun slant;
    slant.path = 2;
    slant.h2_km = 1.0;
    SyntheticRun single;
    single.wavenumbers_per_cm = {2000.0};
    SyntheticRun falling;
    falling.wavenumbers_per_cm = {2000.0, 1990.0, 1980.0};
    SyntheticRun twice;
    twice.wavenumbers_per_cm = {2000.0, 2010.0, 2010.0};
    SyntheticRun other;
    other.range_km = 2.0;
    SyntheticRun otherGrid = other;
    otherGrid.wavenumbers_per_cm = {2000.0, 2005.0, 2010.0};
    SyntheticRun otherAir = other;
    otherAir.model = 1;
    SyntheticRun otherGround = other;
    otherGround.ground_km = -1.0;
    SyntheticRun thicker = transmittance;
    thicker.depth = [](double) { return 0.2; };
    SyntheticRun sunned;
    sunned.kind = 2;
    sunned.iparm = 2;
    sunned.parm2_deg = 30.0;
    SyntheticRun otherSun = sunned;
    otherSun.parm2_deg = 60.0;
    otherSun.range_km = 2.0;
    const auto cell = [&](const std::string& what, const std::string& with) {
        return replaced(good, what, with);
    };
    const struct {
        const char* name;
        std::string text;
        const char* says;
    } rows[] = {
        {"empty", "", "an empty file"},
        {"blank lines", "\n  \n\n", "an empty file"},
        {"binary", std::string("T F\0 6", 7), "a NUL byte"},
        {"no header at all", "2000 0.5 1e-7\n2010 0.5 1e-7\n",
         "line 2: found a header that is cut"},
        {"header cut after card 3", good.substr(0, good.find("  -99  -99")), "line 6: found"},
        {"a card is missing", replaced(good, lineAt(good, 3) + "\n", ""),
         "line 10: found a header"},
        {"MODEL is no number", cell("T F 6", "T F X"),
         "line 1: found 'X', expected a number for MODEL"},
        {"VIS is no number", cell("  23.00000", "  2x.00000"), "line 2: found '2x.00000'"},
        {"unknown IEMSCT", cell("T F 6    1    1", "T F 6    1    4"), "found IEMSCT 4"},
        {"unknown ITYPE", cell("T F 6    1    1", "T F 6    7    1"), "found ITYPE 7"},
        {"RANGE of a horizontal path is 0", cell("  90.00000   1.00000", "  90.00000   0.00000"),
         "line 6: found RANGE 0"},
        {"H1 below the ground", cell("   0.00000   0.00000  90", "  -1.00000   0.00000  90"),
         "found H1 -1"},
        {"ANGLE beyond 180", replaced(tape7(slant), "  90.00000", " 190.00000"), "found ANGLE 190"},
        {"no column TOT_TRANS", cell("TOT_TRANS", "XXX_TRANS"), "no column TOT_TRANS"},
        {"no column PTH_THRML", cell("PTH_THRML", "XXX_THRML"), "no column PTH_THRML"},
        {"no column TOTAL_RAD", cell("TOTAL_RAD", "XXXXX_RAD"), "no column TOTAL_RAD"},
        {"no second line of names", replaced(tape7(transmittance), "    CM-1", "        "),
         "a second line of column names"},
        {"IEMSCT 3 without SOL TR", replaced(tape7(sun), "SOL TR", "      "), "SOL TR"},
        {"IEMSCT 3 of a horizontal path",
         replaced(tape7(sun), "T F 6    3    3", "T F 6    1    3"),
         "expected 3, a path to the sun"},
        {"a word for a number", cell(" 2010.00 0.90483742", " 2010.00 0.9x483742"),
         "line 13: found '0.9x483742'"},
        {"NaN", cell(" 2020.00 0.90483742", " 2020.00        NaN"), "line 14: found 'NaN'"},
        {"stars", cell(" 2020.00 0.90483742", " 2020.00 **********"),
         "line 14: found '**********'"},
        {"a blank transmittance", cell(" 2020.00 0.90483742", " 2020.00           "),
         "line 14: found a blank TOT_TRANS"},
        {"transmittance above 1", cell(" 2020.00 0.90483742", " 2020.00 1.10483742"),
         "line 14: found transmittance 1.10483742"},
        {"negative transmittance", cell(" 2020.00 0.90483742", " 2020.00-0.10483742"),
         "line 14: found transmittance -0.10483742"},
        {"wavenumbers fall", tape7(falling), "line 13: found wavenumber 1990"},
        {"a wavenumber twice", tape7(twice), "line 14: found wavenumber 2010"},
        {"a wavenumber of 0", cell(" 2000.00 0.9", "    0.00 0.9"), "line 12: found 0"},
        {"one wavenumber", tape7(single), "at least two wavenumbers"},
        {"no rows", good.substr(0, good.find(" 2000.00 0.9")), "0 rows"},
        {"the second run is cut", good + good.substr(0, 300), "found a header that is cut"},
        {"mixed grids", good + tape7(otherGrid), "tape7, run 2: found 3 wavenumbers"},
        {"mixed air", good + tape7(otherAir), "tape7, run 2: found MODEL 1, expected 6"},
        {"mixed ground", good + tape7(otherGround), "found GNDALT -1"},
        {"a geometry twice", good + good, "found the geometry of tape7 again"},
        {"two transmittances of one path", good + tape7(thicker),
         "a transmittance that differs by"},
        {"two suns", tape7(sunned) + tape7(otherSun), "found PARM2 60"},
    };
    for (const auto& row : rows) {
        EXPECT_THAT(refusal(row.text), HasSubstr(row.says)) << row.name;
    }
}

TEST(Tape7, EveryFileOfModtranHasTheCardsOfTheList) {
    NEEDS_MODTRAN_FILES();
    const CsvTable list = CsvTable::read(modtranFolder() / "cards.csv");
    const std::vector<CsvCell>& header = list.rows().front().cells;
    const std::map<std::string, std::string> cardOf = {
        {"VIS_km", "VIS"},    {"GNDALT_km", "GNDALT"}, {"H1_km", "H1"},
        {"H2_km", "H2"},      {"ANGLE_deg", "ANGLE"},  {"RANGE_km", "RANGE"},
        {"BETA_deg", "BETA"}, {"V1_cm-1", "V1"},       {"V2_cm-1", "V2"},
        {"DV_cm-1", "DV"},    {"FWHM_cm-1", "FWHM"},   {"RO_or_IDAY", "RO"}};
    ASSERT_EQ(list.rows().size(), 15u);
    for (std::size_t i = 1; i < list.rows().size(); ++i) {
        const std::vector<CsvCell>& row = list.rows()[i].cells;
        const std::string file = row[0].text;
        const std::vector<SpectralRun> runs = readTape7(modtranFolder() / file);
        ASSERT_EQ(runs.size(), 1u) << file;
        int compared = 0;
        for (std::size_t k = 1; k < row.size(); ++k) {
            const auto renamed = cardOf.find(header[k].text);
            const std::string card = renamed == cardOf.end() ? header[k].text : renamed->second;
            if (const auto found = runs.front().cards.find(card);
                found != runs.front().cards.end()) {
                EXPECT_NEAR(found->second, *parseNumber(row[k].text), 1e-4) << file << " " << card;
                ++compared;
            }
            if (card == "n_points") {
                EXPECT_EQ(std::to_string(runs.front().wavenumbers_per_cm.size()), row[k].text)
                    << file;
                ++compared;
            }
        }
        EXPECT_EQ(compared, 32) << file;
    }
}

TEST(Tape7, RealFilesReproduceTheirOwnNumbers) {
    NEEDS_MODTRAN_FILES();
    const std::filesystem::path slant = modtranFolder() / "pyradi/tape7-03b";
    const auto air = TabulatedAtmosphere::import(std::span(&slant, 1));
    EXPECT_TRUE(air.supports(AtmosphereProperty::transmittance));
    EXPECT_TRUE(air.supports(AtmosphereProperty::pathRadiance));
    EXPECT_FALSE(air.supports(AtmosphereProperty::backgroundRadiance));
    EXPECT_NEAR(air.base().min_um, 1e4 / 2100.0, 1e-12);
    const AtmosphericPath path{2000.0, 10000.0, 9235.9};
    EXPECT_NEAR(air.transmittance(path, air.base()).at(1e4 / 2051.0), 0.74512768, 1e-12);
    const double nu = 2051.0;
    EXPECT_NEAR(air.pathRadiance(path, {}, air.base()).at(1e4 / nu),
                (3.7278e-8 + 1.6775e-10) * nu * nu, 1e-9);
    EXPECT_NEAR(air.transmittance({10000.0, 2000.0, 9235.9}, air.base()).at(1e4 / 2051.0),
                0.74512768, 1e-12)
        << "the other way round";

    const std::filesystem::path sky = modtranFolder() / "pyradi/tape7-05b";
    const auto up = TabulatedAtmosphere::import(std::span(&sky, 1));
    EXPECT_NEAR(up.backgroundRadiance({0.0, radians(70.0), 0.0}, {}, up.base()).at(1e4 / 2100.0),
                1.1649e-7 * 2100.0 * 2100.0, 1e-9);
    EXPECT_NEAR(up.transmittance({0.0, 100e3, 106312.52}, up.base()).at(1e4 / 2100.0), 0.44108412,
                1e-12);

    const std::filesystem::path gases = modtranFolder() / "pyradi/horizon5kmtropical.fl7";
    const auto tropical = TabulatedAtmosphere::import(std::span(&gases, 1));
    EXPECT_EQ(tropical.runs().front().wavenumbers_per_cm.size(), 9867u);
    EXPECT_TRUE(tropical.supports(AtmosphereProperty::scatteringOpticalDepth));
    EXPECT_NEAR(
        tropical.scatteringOpticalDepth({0.0, 0.0, 5000.0}, tropical.base()).at(1e4 / 49987.0),
        -std::log(0.0121) + std::log(0.6373 / 0.1930), 1e-9);

    const std::filesystem::path sun = modtranFolder() / "pyradi/tape7-04";
    const auto low = TabulatedAtmosphere::import(std::span(&sun, 1));
    EXPECT_NEAR(low.solarIrradiance(2000.0, {0.0, radians(-0.93655)}, low.base()).at(1e4 / 2150.0),
                1.60e-10 * 2150.0 * 2150.0, 1e-9);
    EXPECT_FALSE(low.supports(AtmosphereProperty::transmittance));
}

TEST(Tape7, TheFileThatStopsEarlySaysWhere) {
    NEEDS_MODTRAN_FILES();
    const std::vector<SpectralRun> runs = readTape7(modtranFolder() / "well-fill/SW31km/tape7");
    ASSERT_EQ(runs.front().warnings.size(), 1u);
    EXPECT_THAT(runs.front().warnings.front(), HasSubstr("stops at 3140 cm-1"));
    EXPECT_EQ(runs.front().wavenumbers_per_cm.size(), 115u);
}

TEST(Tape7, ATransmittanceAndARadianceRunOfOnePathCompleteEachOther) {
    NEEDS_MODTRAN_FILES();
    const std::vector<std::filesystem::path> files = {modtranFolder() / "pyradi/tape7-01",
                                                      modtranFolder() / "pyradi/tape7-02"};
    const auto air = TabulatedAtmosphere::import(files);
    EXPECT_NEAR(air.transmittance({2000.0, 2000.0, 2000.0}, air.base()).at(1e4 / 2050.0),
                0.91000313, 1e-12);
    EXPECT_TRUE(air.supports(AtmosphereProperty::scatteringOpticalDepth));
    EXPECT_TRUE(air.supports(AtmosphereProperty::pathRadiance));
}
