#include "tests/support/FormatFeatures.h"

#include <cstdint>

namespace irsg::test {

namespace {

const std::string obj = "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\n";
const std::string face = "f 1 2 3 4\n";

std::string solid(const std::string& facets) {
    return "solid plate\n" + facets + "endsolid plate\n";
}
std::string facet(const std::string& a, const std::string& b, const std::string& c) {
    return "facet normal 0 0 1\nouter loop\nvertex " + a + "\nvertex " + b + "\nvertex " + c +
           "\nendloop\nendfacet\n";
}
const std::string facets = facet("0 0 0", "2 0 0", "2 1 0") + facet("0 0 0", "2 1 0", "0 1 0");

std::string raw(const void* value, std::size_t size) {
    return {static_cast<const char*>(value), size};
}
/// The two facets as bytes, with what an attribute of each says.
std::string binary(std::uint16_t attribute, const std::string& more) {
    std::string bytes = "made by a test";
    bytes.resize(80, ' ');
    const std::uint32_t count = 2;
    bytes += raw(&count, 4);
    for (const auto& values : {std::vector<float>{0, 0, 1, 0, 0, 0, 2, 0, 0, 2, 1, 0},
                               std::vector<float>{0, 0, 1, 0, 0, 0, 2, 1, 0, 0, 1, 0}}) {
        bytes += raw(values.data(), 48) + raw(&attribute, 2);
    }
    return bytes + more;
}

std::string ply(const std::string& head, const std::string& body) {
    return "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
           "property float z\n" +
           head + "end_header\n0 0 0\n2 0 0\n2 1 0\n0 1 0\n" + body;
}
const std::string faces = "element face 1\nproperty list uchar int vertex_indices\n";

} // namespace

std::vector<FormatFeature> textFeatures() {
    std::vector<FormatFeature> all;
    std::string format = "Wavefront (.obj, .mtl)", name = "a.obj";
    const auto add = [&](const std::string& feature, std::string text, Outcome outcome,
                         const std::string& says = "", double area_m2 = 2.0,
                         double diagonal_m = 2.23606797749978969641) {
        all.push_back({format, feature, name, std::move(text), outcome, says, area_m2, diagonal_m});
    };
    using enum Outcome;
    add("`v`, `f` of any number of corners, numbers from the end", obj + "f -4 -3 -2 -1\n",
        followed);
    add("`vn`", obj + "vn 0 0 1\nf 1//1 2//1 3//1 4//1\n", followed);
    add("`vt`", obj + "vt 0 0\nf 1/1 2/1 3/1 4/1\n", looksOnly);
    add("a fourth number of `v`, which only free forms use, and colours behind",
        with(obj, "v 0 0 0", "v 0 0 0 1") + face, looksOnly);
    add("`fo`, as older versions have it", obj + "fo 1 2 3 4\n", followed);
    add("`o`, `g`, `usemtl`", obj + "o a\ng b\nusemtl c\n" + face, followed);
    add("`s`, `mg`", obj + "s 1\nmg 0\n" + face, looksOnly);
    add("`p`, `l`", obj + face + "p 1\nl 1 2\n", remarked, "lines, points and free forms");
    add("curves and surfaces (`vp`, `cstype`, `curv`, `curv2`, `surf`, ...)",
        obj + face + "cstype bezier\ndeg 1 1\nsurf 0 1 0 1 1 2 4 3\nparm u 0 1\nparm v 0 1\nend\n",
        remarked, "lines, points and free forms");
    add("patches of older versions (`bzp`, `bsp`, `cdc`)", obj + face + "bzp 1 2 3 4\n", remarked,
        "lines, points and free forms");
    add("`lod`", obj + "lod 1\n" + face, remarked, "lod");
    add("`bevel`, `c_interp`, `d_interp`, `shadow_obj`, `trace_obj`", obj + "c_interp on\n" + face,
        remarked, "free forms");
    add("`call`, `csh`", obj + "call other.obj\n" + face, remarked, "free forms");
    add("`maplib`, `usemap`", obj + "maplib a.mlb\n" + face, remarked, "free forms");
    add("a `\\` that continues a line", obj + "f 1 2 \\\n3 4\n", followed);
    add("other words", obj + "prism 1\n" + face, remarked, "which the format does not have");
    add("`mtllib`: a file that is missing", obj + "mtllib none.mtl\n" + face, remarked,
        "none.mtl, which is missing");
    add("`Ka`, `Kd`, `Ks`, `Ke`, `Ns`, `d`, `Tr`, `map_Kd` of a .mtl", obj + face, looksOnly);
    add("other words of a .mtl (`illum`, `Ni`, `bump`, `refl`, ...)", obj + face, looksOnly);
    all.back().bytes = "mtllib a.mtl\nusemtl paint\n" + obj + face;
    all.back().beside = {{"a.mtl", "newmtl paint\nillum 2\nNi 1.5\n"}};

    format = "Stereolithography (.stl)";
    name = "a.stl";
    add("as text", solid(facets), followed);
    add("as binary", binary(0, ""), followed);
    add("several solids", solid(facets) + solid(facet("0 0 1", "2 0 1", "2 1 1")), followed, "",
        3.0, 2.44948974278317809820);
    add("normals; those of zeros are made from the corners",
        with(solid(facets), "normal 0 0 1", "normal 0 0 0"), followed);
    add("attributes of facets, by which some programs mean colours", binary(0x7FFF, ""), looksOnly);
    add("bytes behind the last facet", binary(0, "more"), remarked,
        "4 bytes behind the last facet");
    add("fewer facets than the head counts", binary(0, "").substr(0, 150), refused, "2 facets");
    add("a unit in the name of a solid", with(solid(facets), "plate", "plate UNITS=mm"), remarked,
        "mentions a unit");

    format = "Polygon file (.ply)";
    name = "a.ply";
    add("as text, as binary in either byte order", ply(faces, "4 0 1 2 3\n"), followed);
    add("`vertex_indices` and `vertex_index`",
        ply(with(faces, "vertex_indices", "vertex_index"), "4 0 1 2 3\n"), followed);
    add("all types of numbers", ply(with(faces, "uchar int", "int8 uint32"), "4 0 1 2 3\n"),
        followed);
    add("normals of vertices",
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
        "property float z\nproperty float nx\nproperty float ny\nproperty float nz\n" +
            faces + "end_header\n0 0 0 0 0 1\n2 0 0 0 0 1\n2 1 0 0 0 1\n0 1 0 0 0 1\n4 0 1 2 3\n",
        followed);
    add("colours and texture coordinates of vertices",
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
        "property float z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n" +
            faces + "end_header\n0 0 0 9 9 9\n2 0 0 9 9 9\n2 1 0 9 9 9\n0 1 0 9 9 9\n4 0 1 2 3\n",
        looksOnly);
    add("`tristrips`",
        ply("element tristrips 1\nproperty list int int vertex_indices\n", "4 0 1 3 2\n"),
        followed);
    add("`edge`",
        ply(faces + "element edge 1\nproperty int vertex1\nproperty int vertex2\n",
            "4 0 1 2 3\n0 1\n"),
        remarked, "edge");
    add("other elements and properties",
        ply(with(faces, "property list", "property float quality\nproperty list"), "1 4 0 1 2 3\n"),
        remarked, "quality");
    add("`comment`, `obj_info`",
        with(ply(faces, "4 0 1 2 3\n"), "element vertex",
             "comment a plate\nobj_info x\nelement vertex"),
        looksOnly);
    add("no faces: a cloud of points", ply("", ""), refused, "face");
    add("versions other than 1.0", with(ply(faces, "4 0 1 2 3\n"), "ascii 1.0", "ascii 2.0"),
        refused, "format ascii 2.0");
    return all;
}

} // namespace irsg::test
