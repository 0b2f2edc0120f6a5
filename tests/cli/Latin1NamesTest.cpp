#include <fstream>
#include <ostream>

#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "irsg/core/Utf8.h"
#include "irsg/signature/SignatureFile.h"
#include "tests/cli/Program.h"
#include "tests/support/TemporaryFolder.h"

namespace smat::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// A triangle whose name is Tuer with an u umlaut, in Latin-1.
struct Latin1 {
    const char *extension, *text;
};

void PrintTo(const Latin1& row, std::ostream* out) {
    *out << row.extension;
}

class Latin1Name : public testing::TestWithParam<Latin1> {};

TEST_P(Latin1Name, IsReadAsSuchByEveryCommand) {
    const TemporaryFolder folder;
    const std::string model = std::string("m.") + GetParam().extension;
    write(folder / model, GetParam().text);
    const Ran info = smatBatch({"model", "info", model, "--json"}, folder.path());
    EXPECT_EQ(info.exitCode, 0) << info.err;
    const Ran codes = smatBatch({"model", "codes", model, "--json"}, folder.path());
    ASSERT_EQ(codes.exitCode, 0) << codes.err;
    EXPECT_TRUE(irsg::isUtf8(codes.out));
    EXPECT_THAT(codes.out, HasSubstr("T\xc3\xbcr"));
    const Ran suggested =
        smatBatch({"model", "codes", model, "--suggest", "--database", "m.sigdb"}, folder.path());
    EXPECT_EQ(suggested.exitCode, 0) << suggested.err;
    EXPECT_NO_THROW(irsg::loadSignatureFile(folder / "m.sigdb"));
    EXPECT_TRUE(irsg::isUtf8(contentOf(folder / (model + ".codes.json"))));
    const Ran ran = smatBatch({"polar", model, "--database", "m.sigdb", "--step", "180", "--width",
                               "16", "--height", "16", "--bounces", "0", "--out", "r.csv"},
                              folder.path());
    EXPECT_EQ(ran.exitCode, 0) << ran.err;
}

INSTANTIATE_TEST_SUITE_P(
    All, Latin1Name,
    testing::Values(
        Latin1{"obj", "o T\xfcr\ng T\xfcr\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl T\xfcr\n"
                      "f 1 2 3\n"},
        Latin1{"stl", "solid T\xfcr\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n"
                      "vertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid\n"},
        Latin1{"ac", "AC3Db\nMATERIAL \"T\xfcr\" rgb 1 1 1  amb 0 0 0  emis 0 0 0  "
                     "spec 0 0 0  shi 0  trans 0\nOBJECT world\nkids 1\nOBJECT poly\n"
                     "name \"T\xfcr\"\nnumvert 3\n0 0 0\n1 0 0\n0 1 0\nnumsurf 1\n"
                     "SURF 0x20\nmat 0\nrefs 3\n0 0 0\n1 0 0\n2 0 0\nkids 0\n"},
        Latin1{"dxf", "0\nSECTION\n2\nENTITIES\n0\n3DFACE\n8\nT\xfcr\n10\n0\n20\n0\n30\n0\n"
                      "11\n1\n21\n0\n31\n0\n12\n1\n22\n1\n32\n0\n13\n1\n23\n1\n33\n0\n0\n"
                      "ENDSEC\n0\nEOF\n"},
        Latin1{"x", "xof 0303txt 0032\nMaterial T\xfcr {\n1;1;1;1;;\n1;\n0,0,0;;\n0;0;0;;\n}\n"
                    "Frame T\xfcr {\nMesh T\xfcr {\n3;\n0;0;0;,\n1;0;0;,\n0;1;0;;\n1;\n"
                    "3;0,1,2;;\nMeshMaterialList {\n1;\n1;\n0;\n{ T\xfcr }\n}\n}\n}\n"},
        Latin1{"gltf", R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],)"
                       R"("nodes":[{"mesh":0}],"materials":[{"name":")"
                       "T\xfcr"
                       R"("}],"meshes":[{"primitives":[{"attributes":{"POSITION":0},)"
                       R"("material":0}]}],"accessors":[{"bufferView":0,"componentType":5126,)"
                       R"("count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}],)"
                       R"("bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[)"
                       R"({"byteLength":36,"uri":"data:application/octet-stream;base64,)"
                       R"(AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})"},
        Latin1{"dae", R"(<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/)"
                      R"(COLLADASchema" version="1.4.1"><asset><unit meter="1"/><up_axis>Z_UP)"
                      R"(</up_axis></asset><library_materials><material id="m" name=")"
                      "T\xfcr"
                      R"("><instance_effect url="#e"/></material></library_materials>)"
                      R"(<library_effects><effect id="e"><profile_COMMON><technique sid="t">)"
                      R"(<lambert/></technique></profile_COMMON></effect></library_effects>)"
                      R"(<library_geometries><geometry id="g"><mesh><source id="p">)"
                      R"(<float_array id="pa" count="9">0 0 0 1 0 0 0 1 0</float_array>)"
                      R"(<technique_common><accessor source="#pa" count="3" stride="3">)"
                      R"(<param name="X" type="float"/><param name="Y" type="float"/>)"
                      R"(<param name="Z" type="float"/></accessor></technique_common>)"
                      R"(</source><vertices id="v"><input semantic="POSITION" source="#p"/>)"
                      R"(</vertices><triangles count="1" material="mm"><input semantic=)"
                      R"("VERTEX" source="#v" offset="0"/><p>0 1 2</p></triangles></mesh>)"
                      R"(</geometry></library_geometries><library_visual_scenes>)"
                      R"(<visual_scene id="s"><node id="n"><instance_geometry url="#g">)"
                      R"(<bind_material><technique_common><instance_material symbol="mm" )"
                      R"(target="#m"/></technique_common></bind_material>)"
                      R"(</instance_geometry></node></visual_scene></library_visual_scenes>)"
                      R"(<scene><instance_visual_scene url="#s"/></scene></COLLADA>)"}),
    [](const auto& info) { return std::string(info.param.extension); });

TEST(Latin1Names, InADatabaseAreRefusedInWordsAndShownToWhoeverRepairsThem) {
    const TemporaryFolder folder;
    fs::copy(sample("box/box.sigdb"), folder / "a.sigdb");
    fs::permissions(folder / "a.sigdb", fs::perms::owner_write, fs::perm_options::add);
    {
        SQLite::Database file((folder / "a.sigdb").string(), SQLite::OPEN_READWRITE);
        ASSERT_GT(file.exec("UPDATE material SET name = CAST(x'54fc72' AS TEXT)"), 0);
    }
    for (const char* command : {"info", "lint", "export"}) {
        Ran ran = smatBatch({"db", command, "a.sigdb"}, folder.path());
        EXPECT_NE(ran.exitCode, 3) << command << ran.err;
    }
    // As the window opens it.
    const irsg::LoadedSignature loaded = irsg::loadSignatureFile(
        folder / "a.sigdb", irsg::OutsideChanges::accept, irsg::LintErrors::accept);
    EXPECT_FALSE(loaded.changedOutside.empty());
    EXPECT_TRUE(irsg::isUtf8(irsg::draftToJson(loaded.database)));
}

} // namespace
} // namespace smat::test
