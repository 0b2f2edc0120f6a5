#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>
#include <numbers>
#include <string>

#include "irsg/signature/SignatureFile.h"
#include "smatcore/data/ResultTable.h"
#include "tests/cli/Program.h"
#include "tests/support/TemporaryFolder.h"

namespace smat::test {
namespace {

using testing::HasSubstr;

TEST(SmatBatch, SaysItsVersionAndItsRenderer) {
    const Ran ran = smatBatch({"--version"});
    EXPECT_EQ(ran.exitCode, 0);
    EXPECT_THAT(ran.out, HasSubstr("smat-batch 0."));
    EXPECT_THAT(ran.out, HasSubstr("renderer: "));
}

TEST(SmatBatch, HelpOfACommandListsItsOptionsWithRangesAndDefaults) {
    const Ran ran = smatBatch({"polar", "--help"});
    EXPECT_EQ(ran.exitCode, 0);
    EXPECT_THAT(ran.out, HasSubstr("--azimuth"));
    EXPECT_THAT(ran.out, HasSubstr("from 1 to 16384 px"));
    EXPECT_THAT(ran.out, HasSubstr("camera-azimuth"));
    EXPECT_THAT(ran.out, testing::Not(HasSubstr("--points")));
}

TEST(SmatBatch, ListsSettingsForPeopleMachinesAndTheManual) {
    EXPECT_THAT(smatBatch({"settings"}).out, HasSubstr("sensor.width (--width)"));
    EXPECT_EQ(smatBatch({"settings", "--markdown"}).out,
              contentOf(std::filesystem::path(SMAT_SOURCE_DIR) / "docs" / "settings.md"));
    const auto json = nlohmann::json::parse(smatBatch({"settings", "--json"}).out);
    EXPECT_EQ(json["settings"][0]["key"], "sensor.width");
}

TEST(SmatBatch, TakesTheLastOfASettingAndTheWordBehindAFlag) {
    const TemporaryFolder folder;
    // What differs from the defaults stands in the remarks of an image.
    const auto imageOf = [&](std::vector<std::string> options) {
        const std::filesystem::path out = folder / "a.csv";
        options.insert(options.begin(), {"image", sample("box/box.smat"), "--height", "4"});
        options.insert(options.end(), {"--width", "8", "--out", out.string()});
        const Ran ran = smatBatch(options);
        EXPECT_EQ(ran.exitCode, 0) << ran.err;
        return contentOf(out);
    };
    EXPECT_THAT(imageOf({"--width", "100"}), HasSubstr("# sensor.width: 8 px"));
    EXPECT_THAT(imageOf({"--hot-spots", "false"}), HasSubstr("# render.hotSpots: false"));
    EXPECT_THAT(imageOf({"--hot-spots=false", "--hot-spots", "true"}),
                testing::Not(HasSubstr("# render.hotSpots")));
    EXPECT_THAT(imageOf({"--sun-disc"}), HasSubstr("# render.sunDisc: true"));

    const Ran wrong = smatBatch({"polar", sample("box/box.smat"), "--sun-disc", "perhaps"});
    EXPECT_EQ(wrong.exitCode, 2);
    EXPECT_THAT(wrong.err, HasSubstr("perhaps"));
}

TEST(SmatBatch, ModelInfoCountsFacesByCode) {
    const Ran ran = smatBatch({"model", "info", sample("turboprop4/turboprop4.flt"), "--json"});
    EXPECT_EQ(ran.exitCode, 0);
    const auto json = nlohmann::json::parse(ran.out);
    int faces = 0;
    for (const auto& code : json["codes"]) {
        faces += code["faces"].get<int>();
    }
    EXPECT_EQ(json["codes"].size(), 9u);
    EXPECT_EQ(faces, 862);
}

TEST(SmatBatch, ModelInfoTellsWhatIsClosedAndSeenFromBothSides) {
    const std::string file = sample("turboprop4/turboprop4.flt");
    const auto surfaces =
        nlohmann::json::parse(smatBatch({"model", "info", file, "--json"}).out)["surfaces"];
    EXPECT_GT(surfaces["count"].get<int>(), 1);
    EXPECT_LE(surfaces["closed"].get<int>(), surfaces["count"].get<int>());
    EXPECT_NE(smatBatch({"model", "info", file})
                  .out.find("  surfaces: " + surfaces["count"].dump() + ", of which"),
              std::string::npos);
    EXPECT_EQ(surfaces["two_sided_triangles_of_closed"], 0);

    // STL knows no sides: all are seen from both. A tetrahedron is closed, without a face it is
    // not.
    const TemporaryFolder folder;
    const auto stl = [&](int faces) {
        const char* const corners[4] = {"0 0 0", "1 0 0", "0 1 0", "0 0 1"};
        const int triangles[4][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
        std::string text = "solid t\n";
        for (int f = 0; f < faces; ++f) {
            text += "facet normal 0 0 0\nouter loop\n";
            for (const int corner : triangles[f]) {
                text += std::string("vertex ") + corners[corner] + "\n";
            }
            text += "endloop\nendfacet\n";
        }
        std::ofstream(folder / "t.stl") << text << "endsolid t\n";
        return nlohmann::json::parse(
            smatBatch({"model", "info", folder / "t.stl", "--json"}).out)["surfaces"];
    };
    const auto whole = stl(4), open = stl(3);
    EXPECT_EQ(whole["closed"], 1);
    EXPECT_EQ(whole["two_sided_triangles_of_closed"], 4);
    EXPECT_EQ(whole["open_edges"], 0);
    EXPECT_EQ(open["closed"], 0);
    EXPECT_EQ(open["two_sided_triangles"], 3);
    EXPECT_EQ(open["open_edges"], 3);
}

TEST(SmatBatch, ConvertKeepsCodesThroughEveryFormat) {
    const TemporaryFolder folder;
    const auto codesOf = [](const std::filesystem::path& file) {
        auto codes =
            nlohmann::json::parse(smatBatch({"model", "info", file, "--json"}).out)["codes"];
        for (auto& code : codes) {
            code.erase("faces"); // a format may count triangles
            code["area_m2"] = std::round(code["area_m2"].get<double>());
        }
        return codes;
    };
    const auto original = codesOf(sample("turboprop4/turboprop4.flt"));
    for (const char* name : {"a.osgt", "a.osgb", "a.ive"}) {
        const Ran ran = smatBatch({"convert", sample("turboprop4/turboprop4.flt"), folder / name});
        EXPECT_EQ(ran.exitCode, 0) << ran.err;
        EXPECT_EQ(codesOf(folder / name), original) << name;
    }
}

TEST(SmatBatch, ConvertTakesUnitAndAxesAsModelInfoDoes) {
    const TemporaryFolder folder;
    std::ofstream(folder / "plate.ply")
        << "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
           "property float z\nelement face 1\nproperty list uchar int vertex_indices\n"
           "end_header\n0 0 0\n100 0 0\n100 0 300\n0 0 300\n4 0 1 2 3\n";
    const auto info = [&](std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), {"model", "info", "--json"});
        auto json = nlohmann::json::parse(smatBatch(arguments, folder.path()).out);
        return nlohmann::json{json["min_m"], json["max_m"], json["codes"][0]["area_m2"]};
    };
    const std::vector<std::string> placing = {"--unit", "in", "--up-axis", "y", "--nose-axis=-z"};
    std::vector<std::string> convert = {"convert", "plate.ply", "plate.osgb", "--json"},
                             told = {"plate.ply"};
    convert.insert(convert.end(), placing.begin(), placing.end());
    told.insert(told.end(), placing.begin(), placing.end());
    const Ran ran = smatBatch(convert, folder.path());
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    const auto report = nlohmann::json::parse(ran.out);
    EXPECT_EQ(report["placing"],
              nlohmann::json({{"upAxis", "+y"}, {"noseAxis", "-z"}, {"unit_m", 0.0254}}));
    EXPECT_THAT(report["remarks"].dump(), HasSubstr("as read it is in inches"));
    const auto before = info(told), after = info({"plate.osgb"});
    EXPECT_NEAR(after[2].get<double>(), 30000 * 0.0254 * 0.0254, 1e-4);
    for (std::size_t i : {0, 1}) {
        for (std::size_t axis : {0, 1, 2}) {
            EXPECT_NEAR(after[i][axis].get<double>(), before[i][axis].get<double>(), 1e-5);
        }
    }
    const Ran open = smatBatch({"convert", "plate.ply", "plate.osgb"}, folder.path());
    EXPECT_THAT(open.out, HasSubstr("does not state its unit, up axis or nose axis"));
    const Ran wrong =
        smatBatch({"convert", "plate.ply", "plate.osgb", "--unit", "mile"}, folder.path());
    EXPECT_EQ(wrong.exitCode, 2);
    EXPECT_THAT(wrong.err, HasSubstr("--unit: found mile"));
}

/// A tube about z of 12 sides and 2 m, open at its low end if `isOpen`, with every part turned to
/// the inside from `turned` on.
void writeTube(const std::filesystem::path& file, bool isOpen, int turned = 12) {
    std::ofstream out(file);
    for (int side = 0; side < 12; ++side) {
        const double angle = side * std::numbers::pi / 6.0;
        out << "v " << std::cos(angle) << " " << std::sin(angle) << " 0\nv " << std::cos(angle)
            << " " << std::sin(angle) << " 2\n";
    }
    out << "v 0 0 0\nv 0 0 2\nusemtl tube\n";
    for (int side = 0; side < 12; ++side) {
        const int low = 2 * side + 1, nextLow = 2 * ((side + 1) % 12) + 1;
        if (side < turned) {
            out << "f " << low << " " << nextLow << " " << nextLow + 1 << " " << low + 1 << "\n";
        } else {
            out << "f " << low + 1 << " " << nextLow + 1 << " " << nextLow << " " << low << "\n";
        }
        out << "f 26 " << low + 1 << " " << nextLow + 1 << "\n";
        if (!isOpen) {
            out << "f 25 " << nextLow << " " << low << "\n";
        }
    }
    std::filesystem::path codes = file;
    codes.replace_extension(".codes.json");
    std::ofstream(codes) << R"({"format": "smat-codes", "version": 1, "rules":
        [{"material": "tube", "temperatureIndex": 1, "materialIndex": 1}]})";
}

TEST(SmatBatch, ConvertClosesShellsThatBecomeZonesOfGas) {
    const TemporaryFolder folder;
    writeTube(folder / "closed.obj", false);
    writeTube(folder / "open.obj", true);
    writeTube(folder / "turned.obj", true, 11);
    irsg::SignatureDatabase database;
    database.temperatures[1].name = "gas";
    database.temperatures[1].terms.base_K = 800.0;
    database.materials[1].name = "exhaust";
    database.materials[1].gasPressure_atm = 1.0;
    database.materials[1].gasCO2 = database.materials[1].gasH2O = 0.05;
    irsg::saveSignatureFile(database, folder / "gas.sigdb");
    const auto seen = [&](const std::string& model) {
        return smatBatch(
            {"polar",        model,      "--database",  "gas.sigdb", "--band",       "4.4-4.6",
             "--from",       "60",       "--to",        "180",       "--step",       "60",
             "--range",      "50",       "--elevation", "30",        "--background", "none",
             "--atmosphere", "none",     "--bounces",   "0",         "--sun",        "off",
             "--out",        "polar.csv"},
            folder.path());
    };
    EXPECT_THAT(seen("open.obj").err, HasSubstr("12 edges of an open mesh"));
    const Ran ran =
        smatBatch({"convert", "open.obj", "zone.osgb", "--zones", "gas.sigdb"}, folder.path());
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("material 1 and temperature 1, with 12 faces"));
    const auto intensities = [&](const std::string& model) {
        const Ran polar = seen(model);
        EXPECT_EQ(polar.exitCode, 0) << polar.err;
        return ResultTable::load(folder / "polar.csv").find("intensity")->values;
    };
    const auto whole = intensities("closed.obj"), zone = intensities("zone.osgb");
    ASSERT_EQ(zone.size(), whole.size());
    for (std::size_t i = 0; i < whole.size(); ++i) {
        EXPECT_GT(whole[i], 0.0);
        EXPECT_NEAR(zone[i] / whole[i], 1.0, 1e-3) << "its end is a flat cone";
    }
    // What cannot be closed, and a database that has no gas.
    const Ran turned =
        smatBatch({"convert", "turned.obj", "none.osgb", "--zones", "gas.sigdb"}, folder.path());
    EXPECT_EQ(turned.exitCode, 2);
    EXPECT_THAT(turned.err, HasSubstr("turned to opposite sides"));
    EXPECT_FALSE(std::filesystem::exists(folder / "none.osgb"));
    database.materials[1].gasPressure_atm = 0.0;
    irsg::saveSignatureFile(database, folder / "solid.sigdb");
    const Ran solid =
        smatBatch({"convert", "open.obj", "no.osgb", "--zones", "solid.sigdb"}, folder.path());
    EXPECT_EQ(solid.exitCode, 2);
    EXPECT_THAT(solid.err, HasSubstr("no gas"));
    EXPECT_FALSE(std::filesystem::exists(folder / "no.osgb"));
}

TEST(SmatBatch, DatabasesGoThroughJsonUnchanged) {
    const TemporaryFolder folder;
    const Ran exported =
        smatBatch({"db", "export", sample("ship/ship.sigdb"), folder / "ship.json"});
    EXPECT_EQ(exported.exitCode, 0) << exported.err;
    EXPECT_EQ(smatBatch({"db", "import", folder / "ship.json", folder / "ship.sigdb"}).exitCode, 0);
    EXPECT_EQ(smatBatch({"db", "export", folder / "ship.sigdb"}).out,
              contentOf(folder / "ship.json"));
}

TEST(SmatBatch, CreatesADatabaseForTheCodesOfAModel) {
    const TemporaryFolder folder;
    const std::string model = sample("ship/ship.flt");
    EXPECT_EQ(smatBatch({"db", "create", folder / "new.sigdb", "--model", model}).exitCode, 0);
    const Ran lint = smatBatch({"db", "lint", folder / "new.sigdb", "--model", model});
    EXPECT_NE(lint.exitCode, 2) << lint.out;
    const auto info =
        nlohmann::json::parse(smatBatch({"db", "info", folder / "new.sigdb", "--json"}).out);
    EXPECT_EQ(info["temperatures"].size(), 5u);
    EXPECT_EQ(info["materials"].size(), 4u);
}

TEST(SmatBatch, LintNamesTheCodesAModelCarriesWithoutAnEntry) {
    const Ran lint = smatBatch({"db", "lint", sample("sphere/sphere.sigdb"), "--model",
                                sample("chessboard/chessboard.flt")});
    EXPECT_EQ(lint.exitCode, 2);
    EXPECT_THAT(lint.out, HasSubstr("temperatures.2"));
    EXPECT_THAT(lint.out, HasSubstr("materials.3"));
    EXPECT_THAT(lint.out, HasSubstr("32 faces"));
}

TEST(SmatBatch, ImportsSpectraAndFactorsFromCsv) {
    const TemporaryFolder folder;
    std::filesystem::copy(sample("ship/ship.sigdb"), folder / "ship.sigdb");
    write(folder / "plume.csv", "um,CO2,H2O\n3,1,2\n4,2,2\n5,1,0\n");
    const Ran spectrum =
        smatBatch({"db", "import", folder / "plume.csv", folder / "ship.sigdb", "--unit",
                   "W m-2 sr-1 um-1", "--name", "funnel plume", "--reference-distance", "50"});
    EXPECT_EQ(spectrum.exitCode, 0) << spectrum.err;
    write(folder / "angle.csv", ",CO2,H2O\n0,1,1\n180,0.5,0.25\n");
    const Ran factors = smatBatch({"db", "import", folder / "angle.csv", folder / "ship.sigdb",
                                   "--as", "angle", "--temperature", "8"});
    EXPECT_EQ(factors.exitCode, 0) << factors.err;
    const std::string text = smatBatch({"db", "export", folder / "ship.sigdb"}).out;
    EXPECT_THAT(text, HasSubstr("0.25"));
    const auto info =
        nlohmann::json::parse(smatBatch({"db", "info", folder / "ship.sigdb", "--json"}).out);
    EXPECT_EQ(info["spectra"][0]["reference_distance_m"], 50.0);
}

} // namespace
} // namespace smat::test
