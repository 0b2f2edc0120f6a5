#include "tests/support/FormatFeatures.h"

#include <cstdint>

namespace irsg::test {

namespace {

/// A plate of AC3D with words of its object and of its surface.
std::string ac(const std::string& inObject, const std::string& flags = "0x20",
               const std::string& before = "") {
    return "AC3Db\nMATERIAL \"paint\" rgb 1 0 0 amb 1 0 0 emis 0 0 0 spec 0 0 0 shi 1 trans 0\n"
           "OBJECT world\nkids " +
           std::string(before.empty() ? "1" : "2") + "\n" + before +
           "OBJECT poly\nname \"plate\"\n" + inObject +
           "numvert 4\n0 0 0\n2 0 0\n2 1 0\n0 1 0\nnumsurf 1\nSURF " + flags +
           "\nmat 0\nrefs 4\n0 0 0\n1 0 0\n2 0 0\n3 0 0\nkids 0\n";
}

template <typename Number>
std::string raw(Number value) {
    return {reinterpret_cast<const char*>(&value), sizeof value};
}
std::string chunk(std::uint16_t kind, const std::string& content) {
    return raw(kind) + raw(static_cast<std::uint32_t>(6 + content.size())) + content;
}
std::string numbers(const std::vector<float>& values) {
    std::string bytes;
    for (const float value : values) {
        bytes += raw(value);
    }
    return bytes;
}
/// A plate of 3D Studio, with chunks in its mesh, its object, its editor and its file.
std::string studio(const std::string& inMesh = "", const std::string& inObject = "",
                   const std::string& inEditor = "", const std::string& inFile = "",
                   const std::string& inFaces = "") {
    std::string faces = raw(std::uint16_t{2});
    for (const auto index : std::vector<std::uint16_t>{0, 1, 2, 7, 0, 2, 3, 7}) {
        faces += raw(index);
    }
    const std::string mesh =
        chunk(0x4110, raw(std::uint16_t{4}) + numbers({0, 0, 0, 2, 0, 0, 2, 1, 0, 0, 1, 0})) +
        chunk(0x4120, faces + inFaces) + inMesh;
    return chunk(0x4D4D, chunk(0x0002, raw(std::uint32_t{3})) +
                             chunk(0x3D3D, chunk(0x3D3E, raw(std::uint32_t{3})) + inEditor +
                                               chunk(0x4000, std::string("plate\0", 6) + inObject +
                                                                 chunk(0x4100, mesh))) +
                             inFile);
}
const std::string object(const std::string& name, const std::string& content) {
    return chunk(0x4000, name + std::string(1, '\0') + content);
}

} // namespace

std::vector<FormatFeature> sceneFeatures() {
    std::vector<FormatFeature> all;
    std::string format = "AC3D (.ac)", name = "a.ac";
    const auto add = [&](const std::string& feature, std::string text, Outcome outcome,
                         const std::string& says = "", double area_m2 = 2.0,
                         double diagonal_m = 2.23606797749978969641) {
        all.push_back({format, feature, name, std::move(text), outcome, says, area_m2, diagonal_m});
    };
    using enum Outcome;
    add("`OBJECT`: `poly`, `group`, `world`", ac(""), followed);
    add("`OBJECT light`", ac("", "0x20", "OBJECT light\nname \"sun\"\nloc 0 5 0\nkids 0\n"),
        remarked, "light");
    add("`loc`",
        ac("loc 5 0 0\n", "0x20",
           "OBJECT poly\nnumvert 4\n0 0 0\n2 0 0\n2 1 0\n0 1 0\nnumsurf 1\nSURF 0x20\nmat 0\nrefs "
           "4\n0 0 0\n1 0 0\n2 0 0\n3 0 0\nkids 0\n"),
        followed, "", 4.0, 7.07106781186547524);
    add("`rot`", ac("rot 0.70710678 0.70710678 0 -0.70710678 0.70710678 0 0 0 1\n"), followed, "",
        2.0, 3.0);
    add("`SURF`: polygons, one-sided, smooth or flat", ac("", "0x10"), followed);
    add("`SURF`: lines, closed or not", ac("", "0x20"), followed);
    all.back().bytes = with(all.back().bytes, "numsurf 1\n",
                            "numsurf 2\nSURF 0x22\nmat 0\nrefs 2\n0 0 0\n1 0 0\n");
    all.back().outcome = remarked;
    all.back().says = "lines and points have no area";
    add("`crease`", ac("crease 30\n"), followed);
    add("`subdiv`", ac("subdiv 2\n"), remarked, "subdiv");
    add("`hidden`", ac("hidden\n"), remarked, "hidden");
    add("`locked`, `folded`, `url`, `data`", ac("locked\nfolded\ndata 4\nabcd\nurl http://a\n"),
        looksOnly);
    add("`texture`, `texrep`, `texoff`", ac("texture \"none.png\"\n"), remarked, "none.png");
    add("`MATERIAL`, by names", ac(""), followed);
    add("`kids` that counts too many", with(ac(""), "kids 1", "kids 2"), remarked,
        "counts 1 more objects than it has");

    format = "3D Studio (.3ds)";
    name = "a.3ds";
    add("objects of triangles (`4100`)", studio(), followed);
    add("smoothing groups (`4150`)",
        studio("", "", "", "", chunk(0x4150, raw(std::uint32_t{1}) + raw(std::uint32_t{1}))),
        followed);
    add("texture coordinates (`4140`)",
        studio(chunk(0x4140, raw(std::uint16_t{4}) + numbers({0, 0, 1, 0, 1, 1, 0, 1}))),
        looksOnly);
    add("materials (`AFFF`, `4130`), by names",
        studio("", "", chunk(0xAFFF, chunk(0xA000, std::string("paint\0", 6))), "",
               chunk(0x4130, std::string("paint\0", 6) + raw(std::uint16_t{2}) +
                                 raw(std::uint16_t{0}) + raw(std::uint16_t{1}))),
        followed);
    add("axes of a mesh (`4160`), in which its vertices do not lie",
        studio(chunk(0x4160, numbers({1, 0, 0, 0, 1, 0, 0, 0, 1, 5, 0, 0}))), followed);
    add("the scale of the scene (`0100`)", studio("", "", chunk(0x0100, numbers({2}))), remarked,
        "0100");
    add("objects that are hidden (`4010`)", studio("", chunk(0x4010, "")), remarked, "4010");
    add("lights (`4600`)", studio("", "", object("sun", chunk(0x4600, numbers({0, 0, 0})))),
        remarked, "4600");
    add("cameras (`4700`)",
        studio("", "", object("eye", chunk(0x4700, numbers({0, 0, 0, 0, 0, 1, 0, 35})))), remarked,
        "4700");
    add("keyframes (`B000`)", studio("", "", "", chunk(0xB000, "")), remarked, "B000");
    add("backgrounds, fog, shadows, views",
        studio("", "", chunk(0x1200, chunk(0x0010, numbers({0, 0, 0})))), looksOnly);
    add("files cut short", studio().substr(0, 100), refused, "bytes");
    return all;
}

} // namespace irsg::test
