#include <cmath>
#include <cstdlib>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/geometry/model/Model.h"
#include "tests/scene/PlacedPolygons.h"
#include "tests/support/FlightBytes.h"
#include "tests/support/Refusal.h"

using namespace irsg;
using namespace irsg::test;
using smat::test::refusalOf;
using testing::HasSubstr;

namespace {

struct Sample {
    std::string name, bytes;
    double area;
    int polygons;
};

std::vector<Sample> samples() {
    return {{"a.gltf", smallAircraft().text(), 34.0, 36},
            {"a.glb", smallAircraft().binary(), 34.0, 36},
            {"a.fbx", fbxBox().text(), 22.0, 6},
            {"b.fbx", fbxBox().binary(), 22.0, 6},
            {"a.dae", colladaBox().text(), 22.0, 6}};
}

} // namespace

TEST(DamagedFormats, RefuseAGltfThatDoesNotHoldTogether) {
    const TemporaryFolder folder;
    using Change = void (*)(nlohmann::json&);
    const struct {
        const char* name;
        Change change;
        const char* position;
    } rows[] = {
        {"version 1", [](auto& g) { g["asset"]["version"] = "1.0"; }, "asset.version"},
        {"a count beyond its view", [](auto& g) { g["accessors"][0]["count"] = 9; },
         "accessors.0.count"},
        {"a count below", [](auto& g) { g["accessors"][1]["count"] = 35; },
         "meshes.0.primitives.0"},
        {"a view beyond its buffer", [](auto& g) { g["bufferViews"][1]["byteLength"] = 4000; },
         "bufferViews.1.byteLength"},
        {"a node below itself", [](auto& g) { g["nodes"][2]["children"] = {1}; }, "nodes."},
        {"a mesh that is not there", [](auto& g) { g["nodes"][0]["mesh"] = 7; }, "nodes.0.mesh"},
        {"positions of another type", [](auto& g) { g["accessors"][0]["componentType"] = 5123; },
         "POSITION"},
        {"an extension", [](auto& g) { g["extensionsRequired"] = {"KHR_draco_mesh_compression"}; },
         "extensionsRequired.0"},
        {"perspective",
         [](auto& g) {
             g["nodes"][0]["matrix"] = {1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
         },
         "nodes.0.matrix"},
        {"no scene", [](auto& g) { g.erase("scenes"); }, "scenes"},
    };
    for (const auto& row : rows) {
        GltfWriter gltf = smallAircraft();
        row.change(gltf.json);
        EXPECT_THAT(refusalOf([&] { load(folder.write("a.gltf", gltf.text())); }),
                    HasSubstr(row.position))
            << row.name;
    }
    // An index that leads to no vertex.
    GltfWriter gltf;
    gltf.node({{"mesh",
                gltf.mesh("m", {{"attributes", {{"POSITION", gltf.positions(boxCorners(1, 1, 1))}}},
                                {"indices", gltf.indices({0, 1, 8})}})}});
    EXPECT_NE(refusalOf([&] { load(folder.write("a.gltf", gltf.text())); }), "nothing was refused");
}

TEST(DamagedFormats, RefuseFilesOfWhichLessWasRead) {
    const TemporaryFolder folder;
    auto collada = colladaBox().text();
    const auto replaced = [](std::string text, const std::string& what, const std::string& by) {
        const auto at = text.find(what);
        EXPECT_NE(at, text.npos) << what;
        return text.replace(at, what.size(), by);
    };
    for (const std::string& text :
         {replaced(collada, "<vcount>4 4", "<vcount>4 "), replaced(collada, "3 0 4 7 </p>", "</p>"),
          replaced(collada, "url=\"#mesh\"", "url=\"#mash\""),
          replaced(collada, "url=\"#mesh\"", "url=\"other.dae#mesh\"")}) {
        EXPECT_NE(refusalOf([&] { load(folder.write("a.dae", text)); }), "nothing was refused");
    }
    // A mesh that no node places, alone and beside another.
    EXPECT_THAT(refusalOf([&] {
                    load(folder.write("a.fbx", replaced(fbxBox().text(), "C: \"OO\", 100, 200",
                                                        "C: \"OO\", 101, 200")));
                }),
                HasSubstr("without any visible face"));
    GltfWriter gltf = smallAircraft();
    gltf.json["nodes"][0].erase("mesh");
    gltf.json["nodes"][1]["children"] = {2};
    EXPECT_THAT(load(folder.write("a.gltf", gltf.text())).remarks,
                testing::ElementsAre("1 meshes are placed nowhere",
                                     "1 nodes belong to no scene that is shown"));
    gltf = smallAircraft();
    gltf.json["accessors"][1]["count"] = 30;
    gltf.json["nodes"][3]["meqh"] = 1;
    gltf.json["nodes"][3].erase("mesh");
    EXPECT_THAT(
        load(folder.write("a.gltf", gltf.text())).remarks,
        testing::UnorderedElementsAre("12 bytes of its buffers belong to nothing in the file",
                                      "nodes.3.meqh is no word of the format"));
}

TEST(DamagedFormats, RefuseCutFiles) {
    const TemporaryFolder folder;
    for (const auto& sample : samples()) {
        ASSERT_NEAR(Placed(*load(folder.write(sample.name, sample.bytes)).node).area, sample.area,
                    1e-4)
            << sample.name;
        // The foot of a binary .fbx holds nothing.
        const std::size_t size = sample.bytes.size() - (sample.name == "b.fbx" ? 173 : 2);
        for (std::size_t i = 1; i <= 12; ++i) {
            const auto cut = folder.write(sample.name, sample.bytes.substr(0, i * size / 13));
            EXPECT_NE(refusalOf([&] { load(cut); }), "nothing was refused")
                << sample.name << " cut at " << i << "/13";
        }
        const auto most = folder.write(sample.name, sample.bytes.substr(0, size * 4 / 5));
        EXPECT_NE(refusalOf([&] { load(most); }), "nothing was refused") << sample.name;
    }
    const GltfWriter gltf = smallAircraft();
    folder.write("a.bin", gltf.buffer().substr(0, gltf.buffer().size() * 4 / 5));
    EXPECT_THAT(refusalOf([&] { load(folder.write("c.gltf", gltf.text("a.bin"))); }),
                HasSubstr("buffers.0.byteLength"));
}

TEST(DamagedFormats, LoseNothingInSilenceOfDamagedFiles) {
    const TemporaryFolder folder;
    const char* given = std::getenv("SMAT_MUTANTS");
    const int count = given ? std::atoi(given) : 20;
    std::mt19937 random(7);
    std::map<std::string, std::map<std::string, int>> results;
    for (const auto& sample : samples()) {
        for (int i = 0; i < count; ++i) {
            std::string bytes = sample.bytes;
            const auto at = random() % bytes.size();
            switch (random() % 4) {
            case 0:
                bytes[at] = static_cast<char>(random());
                break;
            case 1:
                bytes.erase(at, 1 + random() % 40);
                break;
            case 2:
                bytes.insert(at, bytes.substr(random() % bytes.size(), 1 + random() % 40));
                break;
            default:
                bytes[at] = static_cast<char>(bytes[at] ^ (1 << random() % 8));
            }
            const auto file = folder.write(sample.name, bytes);
            auto& result = results[sample.name];
            try {
                const auto loaded = load(file);
                const Placed placed(*loaded.node);
                const bool whole = std::isfinite(placed.area) && placed.polygons >= sample.polygons;
                ++result[whole ? "read" : loaded.remarks.empty() ? "silent" : "remarked"];
                EXPECT_TRUE(whole || !loaded.remarks.empty())
                    << sample.name << ", mutant " << i << ": " << placed.polygons << " polygons";
            } catch (const InputError& error) {
                const std::string said = error.what();
                ++result[said.find("crashes") != said.npos      ? "crashed"
                         : said.find("takes more") != said.npos ? "too much"
                                                                : "refused"];
            }
        }
    }
    for (const auto& [name, result] : results) {
        std::string line = name + ":";
        for (const auto& [what, number] : result) {
            line += " " + std::to_string(number) + " " + what;
        }
        RecordProperty(name, line);
        if (given) {
            std::printf("%s\n", line.c_str());
        }
    }
}
