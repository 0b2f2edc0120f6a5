#include "tests/support/FormatFeatures.h"

namespace irsg::test {

namespace {

const std::string face =
    "0\n3DFACE\n8\nhull\n10\n0\n20\n0\n30\n0\n11\n2\n21\n0\n31\n0\n12\n2\n22\n1\n"
    "32\n0\n13\n0\n23\n1\n33\n0\n";
std::string section(const std::string& name, const std::string& body) {
    return "0\nSECTION\n2\n" + name + "\n" + body + "0\nENDSEC\n";
}
std::string drawing(const std::string& entities, const std::string& before = "") {
    return before + section("ENTITIES", entities) + "0\nEOF\n";
}
std::string header(const std::string& variable, const std::string& value) {
    return section("HEADER", "9\n" + variable + "\n70\n" + value + "\n");
}
std::string layer(const std::string& flags, const std::string& colour) {
    return section("TABLES", "0\nTABLE\n2\nLAYER\n70\n1\n0\nLAYER\n2\nhull\n70\n" + flags +
                                 "\n62\n" + colour + "\n0\nENDTAB\n");
}
std::string vertex(const std::string& x, const std::string& y, const std::string& flags) {
    return "0\nVERTEX\n8\nhull\n10\n" + x + "\n20\n" + y + "\n30\n0\n70\n" + flags + "\n";
}
std::string block(const std::string& entities, const std::string& more = "") {
    return section("BLOCKS", "0\nBLOCK\n2\npart\n70\n0\n10\n0\n20\n0\n30\n0\n" + more + entities +
                                 "0\nENDBLK\n");
}
const std::string insert = "0\nINSERT\n8\nhull\n2\npart\n10\n0\n20\n0\n30\n0\n";

const std::string mesh = "Mesh plate {\n4;\n0;0;0;,\n2;0;0;,\n2;1;0;,\n0;1;0;;\n1;\n4;0,1,2,3;;\n";
std::string x(const std::string& inMesh, const std::string& before = "",
              const std::string& behind = "") {
    return "xof 0303txt 0032\n" + before + mesh + inMesh + "}\n" + behind;
}

} // namespace

std::vector<FormatFeature> drawingFeatures() {
    std::vector<FormatFeature> all;
    std::string format = "AutoCAD (.dxf)", name = "a.dxf";
    const auto add = [&](const std::string& feature, std::string text, Outcome outcome,
                         const std::string& says = "", double area_m2 = 2.0,
                         double diagonal_m = 2.23606797749978969641) {
        all.push_back({format, feature, name, std::move(text), outcome, says, area_m2, diagonal_m});
    };
    using enum Outcome;
    add("as text", drawing(face), followed);
    add("as binary", "AutoCAD Binary DXF\r\n\x1A" + std::string(1, '\0') + drawing(face), refused,
        "text");
    add("`$INSUNITS`", drawing(face, header("$INSUNITS", "5")), followed, "", 2e-4,
        0.02236067977499789696);
    add("`3DFACE`, whatever edges are hidden", drawing(face + "70\n15\n"), followed);
    add("`SOLID`, `TRACE`",
        drawing("0\nSOLID\n8\nhull\n10\n0\n20\n0\n11\n2\n21\n0\n12\n0\n22\n1\n13\n2\n23\n1\n"),
        followed);
    add("thickness of `SOLID` and `TRACE`",
        drawing(
            "0\nSOLID\n8\nhull\n39\n1\n10\n0\n20\n0\n11\n2\n21\n0\n12\n0\n22\n1\n13\n2\n23\n1\n"),
        remarked, "have a thickness and are read as flat");
    add("`POLYLINE`: meshes",
        drawing("0\nPOLYLINE\n8\nhull\n66\n1\n70\n16\n71\n2\n72\n2\n" + vertex("0", "0", "64") +
                vertex("2", "0", "64") + vertex("0", "1", "64") + vertex("2", "1", "64") +
                "0\nSEQEND\n"),
        followed);
    add("`POLYLINE`: faces",
        drawing("0\nPOLYLINE\n8\nhull\n66\n1\n70\n64\n71\n4\n72\n1\n" + vertex("0", "0", "192") +
                vertex("2", "0", "192") + vertex("2", "1", "192") + vertex("0", "1", "192") +
                "0\nVERTEX\n8\nhull\n10\n0\n20\n0\n30\n0\n70\n128\n71\n1\n72\n2\n73\n3\n74\n4\n"
                "0\nSEQEND\n"),
        followed);
    add("`INSERT` of blocks, scaled, turned, in rows and columns",
        drawing(insert + "41\n2\n", block(face)), followed, "", 4.0, 4.12310562561766055);
    add("blocks of other files (`XREF`)", drawing(face + insert, block("", "1\nother.dwg\n")),
        remarked, "other.dwg");
    add("`LINE`, `ARC`, `CIRCLE`, `LWPOLYLINE`, `TEXT`, ...",
        drawing(face + "0\nLINE\n8\n0\n10\n0\n11\n1\n"), remarked, "1 LINE have no faces");
    add("`3DSOLID`, `REGION`, `BODY`, `MESH`, surfaces, `HATCH`",
        drawing(face + "0\n3DSOLID\n8\n0\n"), remarked, "1 3DSOLID are left out");
    add("entities on a sheet of paper", drawing(face + face + "67\n1\n"), remarked,
        "1 entities lie on a sheet of paper");
    add("invisible entities", drawing(face + face + "60\n1\n"), remarked, "1 invisible entities");
    add("layers that are frozen or off", drawing(face, layer("1", "7")), remarked,
        "layers that the drawing does not show");
    add("colours, line types, handles, extended data", drawing(face + "62\n1\n"), looksOnly);

    format = "DirectX (.x)";
    name = "a.x";
    add("as text", x(""), followed);
    add("as binary (`bin `, `tzip`, `bzip`), of whole files",
        "xof 0303bin 0032" + std::string(8, '\0'), refused, "Assimp");
    add("`Mesh`: faces of any number of corners", x(""), followed);
    add("`Frame`, `FrameTransformMatrix`",
        "xof 0303txt 0032\nFrame a {\nFrameTransformMatrix "
        "{\n2,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1;;\n}\n" +
            mesh + "}\n}\n",
        followed, "", 4.0, 4.12310562561766055);
    add("`MeshNormals`", x("MeshNormals {\n1;\n0;0;1;;\n1;\n4;0,0,0,0;;\n}\n"), followed);
    add("`MeshTextureCoords`, `MeshVertexColors`",
        x("MeshTextureCoords {\n4;\n0;0;,\n1;0;,\n1;1;,\n0;1;;\n}\n"), looksOnly);
    add("`MeshMaterialList`, `Material`, `TextureFilename`",
        x("MeshMaterialList {\n1;\n1;\n0;\nMaterial paint "
          "{\n1;1;1;1;;\n1;\n0;0;0;;\n0;0;0;;\n}\n}\n"),
        followed);
    add("`AnimationSet`",
        x("", "",
          "AnimationSet take {\nAnimation {\n{ plate }\nAnimationKey "
          "{\n0;\n1;\n0;4;1,0,0,0;;;\n}\n}\n}\n"),
        remarked, "animations are not played");
    add("`SkinWeights`, `XSkinMeshHeader`",
        x("XSkinMeshHeader {\n1;\n1;\n1;\n}\nSkinWeights "
          "{\n\"bone\";\n1;\n0;\n1.0;\n1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1;;\n}\n"),
        remarked, "SkinWeights");
    add("`DeclData`, `FVFData`, `PMInfo`, `MeshFaceWraps`, `VertexDuplicationIndices`",
        x("VertexDuplicationIndices {\n4;\n4;\n0,1,2,3;\n}\n"), remarked,
        "VertexDuplicationIndices");
    add("templates, other objects",
        x("", "template Other {\n<10000000-0000-0000-0000-000000000000>\nDWORD a;\n}\n"),
        looksOnly);
    return all;
}

} // namespace irsg::test
