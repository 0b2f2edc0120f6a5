#include "tests/support/FormatFeatures.h"

#include <stdexcept>

#include "tests/support/ForeignModels.h"

namespace irsg::test {

std::string with(std::string text, std::string_view from, std::string_view to) {
    const std::size_t at = text.find(from);
    if (at == text.npos) {
        throw std::logic_error("no \"" + std::string(from) + "\" in a text that has a feature");
    }
    return text.replace(at, from.size(), to);
}

std::string withBehind(std::string text, std::string_view from, std::string_view more) {
    return with(std::move(text), from, std::string(from) + std::string(more));
}

namespace {

const std::vector<osg::Vec3d> corners = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}};

/// A plate whose parts are changed before it becomes a text.
struct Plate {
    GltfWriter writer;
    nlohmann::json primitive, node = {{"name", "plate"}};

    Plate() {
        primitive = {{"attributes", {{"POSITION", writer.positions(corners)}}},
                     {"indices", writer.indices({0, 1, 2, 0, 2, 3})}};
    }
    std::string text() {
        primitive["material"] = writer.material(material);
        node["mesh"] = writer.mesh("plate", primitive);
        writer.node(node);
        return writer.text();
    }
    nlohmann::json material = {{"name", "paint"}, {"doubleSided", true}};
};

template <typename Change>
std::string plate(Change change) {
    Plate one;
    change(one);
    return one.text();
}
/// With an entry of the outermost object.
std::string plateWith(const char* key, const nlohmann::json& value) {
    return plate([&](Plate& p) { p.writer.json[key] = value; });
}

} // namespace

std::vector<FormatFeature> gltfFeatures() {
    std::vector<FormatFeature> all;
    const auto add = [&](const std::string& feature, std::string text, Outcome outcome,
                         const std::string& says = "") {
        all.push_back(
            {"glTF 2.0 (.gltf, .glb)", feature, "a.gltf", std::move(text), outcome, says});
    };
    using enum Outcome;
    using Json = nlohmann::json;
    add("buffers in the text, beside the file, in the chunk of a .glb", plateWith("extras", 1),
        followed);
    add("a version other than 2", plateWith("asset", {{"version", "1.0"}}), refused,
        "glTF of version 2");
    add("`asset.minVersion` above 2.0",
        plateWith("asset", {{"version", "2.1"}, {"minVersion", "2.1"}}), refused, "minVersion");
    add("triangles, strips, fans (modes 4 to 6)", plate([](Plate& p) {
            p.primitive["mode"] = 6;
            p.primitive["indices"] = p.writer.indices({0, 1, 2, 3});
        }),
        followed);
    add("points and lines (modes 0 to 3)", plate([](Plate& p) {
            Json line = p.primitive;
            line["mode"] = 1;
            line["indices"] = p.writer.indices({0, 1});
            p.writer.node({{"mesh", p.writer.mesh("line", line)}});
        }),
        remarked, "lines and points have no area");
    add("indices of 8, 16 and 32 bits", plate([](Plate& p) {
            p.primitive["indices"] = p.writer.indices({0, 1, 2, 0, 2, 3}, 1);
        }),
        followed);
    add("primitives without indices", plate([](Plate& p) {
            p.primitive.erase("indices");
            p.primitive["mode"] = 6;
        }),
        followed);
    add("sparse accessors", plate([](Plate& p) {
            p.writer.json["accessors"][0]["sparse"] = {
                {"count", 1},
                {"indices", {{"bufferView", 1}, {"componentType", 5123}}},
                {"values", {{"bufferView", 0}}}};
        }),
        refused, "three numbers of 32 bits in a buffer");
    add("accessors without a buffer view, which are zeros",
        plate([](Plate& p) { p.writer.json["accessors"][0].erase("bufferView"); }), refused,
        "three numbers of 32 bits in a buffer");
    add("positions in whole numbers (`KHR_mesh_quantization`)",
        plate([](Plate& p) { p.writer.json["accessors"][0]["componentType"] = 5122; }), refused,
        "three numbers of 32 bits in a buffer");
    add("no normals: those of the faces", plate([](Plate&) {}), followed);
    add("tangents, colours of vertices, other sets of texture coordinates",
        plate([](Plate& p) { p.primitive["attributes"]["COLOR_0"] = p.writer.positions(corners); }),
        looksOnly);
    add("morph targets and their weights", plate([](Plate& p) {
            p.primitive["targets"] = {{{"POSITION", 0}}};
        }),
        remarked, "shapes between which meshes could change are left out");
    add("skins", plateWith("skins", {{{"joints", {0}}}}), remarked, "1 skins are not played");
    add("animations",
        plateWith("animations", {{{"channels", Json::array()}, {"samplers", Json::array()}}}),
        remarked, "1 animations are not played");
    add("nodes with translation, rotation and scale", plate([](Plate& p) {
            p.node["scale"] = {2.0, 1.0, 1.0};
        }),
        followed);
    all.back().area_m2 = 4.0;
    all.back().diagonal_m = 4.12310562561766055;
    add("nodes with a matrix", plate([](Plate& p) {
            p.node["matrix"] = {1, 0, 0, 0, 0, 2, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
        }),
        followed);
    all.back().area_m2 = 4.0;
    all.back().diagonal_m = 2.82842712474619010;
    add("matrices with perspective", plate([](Plate& p) {
            p.node["matrix"] = {1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
        }),
        refused, "a matrix with perspective");
    add("several scenes", plate([](Plate& p) {
            p.writer.json["scenes"].push_back({{"name", "b"}});
        }),
        remarked, "of 2 scenes only one is shown");
    add("nodes and meshes in no scene", plate([](Plate& p) {
            p.writer.json["nodes"].push_back({{"name", "lost"}});
        }),
        remarked, "1 nodes belong to no scene that is shown");
    add("cameras", plateWith("cameras", {{{"type", "perspective"}}}), remarked, "1 cameras");
    add("lights (`KHR_lights_punctual`)",
        plate([](Plate& p) { p.writer.json["extensionsUsed"] = {"KHR_lights_punctual"}; }),
        remarked, "KHR_lights_punctual");
    add("`doubleSided` false: backs are not there",
        plate([](Plate& p) { p.material["doubleSided"] = false; }), followed);
    add("base colour, metal, roughness, emission, normal and occlusion maps", plate([](Plate& p) {
            p.material["pbrMetallicRoughness"] = {{"metallicFactor", 0.5}};
        }),
        looksOnly);
    add("`alphaMode` and `alphaCutoff`, where textures cut faces out",
        plate([](Plate& p) { p.material["alphaMode"] = "MASK"; }), followed);
    add("`KHR_texture_transform`",
        plate([](Plate& p) { p.writer.json["extensionsUsed"] = {"KHR_texture_transform"}; }),
        remarked, "KHR_texture_transform");
    for (const char* name :
         {"KHR_materials_unlit", "KHR_materials_transmission", "KHR_materials_variants"}) {
        add(std::string("`") + name + "`",
            plate([&](Plate& p) { p.writer.json["extensionsUsed"] = {name}; }), looksOnly);
    }
    for (const char* name :
         {"KHR_draco_mesh_compression", "EXT_meshopt_compression", "EXT_mesh_gpu_instancing",
          "KHR_node_visibility", "KHR_animation_pointer"}) {
        add(std::string("`") + name + "`, used",
            plate([&](Plate& p) { p.writer.json["extensionsUsed"] = {name}; }), remarked, name);
        add(std::string("`") + name + "`, required", plate([&](Plate& p) {
                p.writer.json["extensionsUsed"] = {name};
                p.writer.json["extensionsRequired"] = {name};
            }),
            refused, name);
    }
    add("pictures as .ktx2 or .webp (`KHR_texture_basisu`, `EXT_texture_webp`)",
        plate([](Plate& p) { p.writer.json["extensionsUsed"] = {"KHR_texture_basisu"}; }), remarked,
        "KHR_texture_basisu");
    add("`extras`, `KHR_xmp_json_ld`", plate([](Plate& p) {
            p.node["extras"] = {{"a", 1}};
        }),
        looksOnly);
    add("words that the format does not have", plate([](Plate& p) { p.node["visible"] = false; }),
        remarked, "visible is no word of the format");
    return all;
}

} // namespace irsg::test
