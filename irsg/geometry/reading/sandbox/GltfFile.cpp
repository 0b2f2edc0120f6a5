#include "irsg/geometry/reading/sandbox/GltfFile.h"

#include <algorithm>
#include <string_view>

#include <osg/Quat>

#include "irsg/core/AppendUnique.h"
#include "irsg/geometry/reading/sandbox/GltfBuffers.h"
#include "irsg/geometry/reading/sandbox/GltfJson.h"
#include "irsg/geometry/reading/sandbox/GraphExtent.h"

namespace irsg {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr std::string_view known[] = {"KHR_texture_transform", "KHR_lights_punctual"};
/// Extensions of these beginnings change what a surface looks like, not where it is.
constexpr std::string_view looks[] = {"KHR_materials_", "KHR_xmp", "KHR_texture_basisu",
                                      "EXT_texture_", "MSFT_texture_"};

/// The version, and extensions without which nothing can be read.
void checkAsset(const GltfJson& json) {
    const Json* asset = GltfJson::find(json.root(), "asset");
    const std::string version =
        asset && asset->is_object() ? json.text(*asset, "asset", "version") : "";
    if (!version.starts_with("2."))
        json.refuse("asset.version", version.empty() ? "nothing" : "\"" + version + "\"",
                    "glTF of version 2");
    const std::string least =
        asset->contains("minVersion") ? json.text(*asset, "asset", "minVersion") : "2.0";
    if (least != "2.0")
        json.refuse("asset.minVersion", "\"" + least + "\"", "a file that glTF 2.0 describes");
    const Json& required = json.list("extensionsRequired");
    for (std::size_t i = 0; i < required.size(); ++i) {
        const std::string name =
            required[i].is_string() ? required[i].get<std::string>() : shownJson(required[i]);
        if (std::ranges::find(known, name) == std::end(known) &&
            std::ranges::none_of(looks,
                                 [&](std::string_view begin) { return name.starts_with(begin); }))
            json.refuse("extensionsRequired." + std::to_string(i), name,
                        "a file that can be read without this extension");
    }
}

class GltfText {
  public:
    GltfText(const GltfJson& json, GltfFile& into)
        : json_(json), into_(into), buffers_(json, into.remarks) {}

    void read() {
        readMeshes();
        readNodes();
        remarkUnused();
        remarkExtensions();
        into_.materials = json_.list("materials").size();
        for (const char* kind : {"animations", "skins"})
            if (const auto count = json_.list(kind).size(); count > 0)
                into_.remarks.push_back(std::to_string(count) + " " + kind +
                                        " are not played: parts are where the file puts them");
        if (const auto count = json_.list("cameras").size(); count > 0)
            into_.remarks.push_back(std::to_string(count) + " cameras are left out");
    }

  private:
    /// What may change surfaces, or pictures that their alpha cuts; others do without it.
    void remarkExtensions() {
        const Json& used = json_.list("extensionsUsed");
        for (const Json& one : used) {
            const std::string name = one.is_string() ? one.get<std::string>() : shownJson(one);
            if (!name.starts_with("KHR_materials_") && !name.starts_with("KHR_xmp"))
                into_.remarks.push_back("the extension " + name +
                                        " is not followed: the file is read without it");
        }
    }

    /// A reference that was damaged leaves a mesh or a node, a count bytes, that belong to nothing.
    void remarkUnused() {
        if (const std::size_t bytes = buffers_.unused_B(); bytes > 0)
            into_.remarks.push_back(std::to_string(bytes) +
                                    " bytes of its buffers belong to nothing in the file");
        std::vector<bool> placed(into_.meshes.size(), false);
        for (const std::size_t node : placed_)
            if (const auto mesh = into_.nodes[node].mesh)
                placed[*mesh] = true;
        if (const auto meshes = std::ranges::count(placed, false); meshes > 0)
            into_.remarks.push_back(std::to_string(meshes) + " meshes are placed nowhere");
        if (const std::size_t nodes = into_.nodes.size() - placed_.size(); nodes > 0)
            into_.remarks.push_back(std::to_string(nodes) +
                                    " nodes belong to no scene that is shown");
    }

    static std::size_t facesOf(std::size_t mode, std::size_t corners) {
        switch (mode) {
        case 0: // points
        case 2: // a loop of lines
            return corners;
        case 1:
            return corners / 2;
        case 3:
            return corners < 2 ? 0 : corners - 1;
        case 4:
            return corners / 3;
        default:
            return corners < 3 ? 0 : corners - 2;
        }
    }

    GltfFile::Primitive primitiveOf(const Json& given, const std::string& path) {
        const Json* attributes = GltfJson::find(given, "attributes");
        if (!attributes || !attributes->is_object())
            json_.refuse(joinedKeyPath(path, "attributes"), "nothing", "an object");
        const std::string at = joinedKeyPath(path, "attributes");
        remarkOtherWords(given, path, {"attributes", "indices", "material", "mode", "targets"},
                         into_.remarks);
        GltfFile::Primitive primitive;
        for (const auto& [name, value] : attributes->items()) {
            const auto& accessor = buffers_.accessors()[*json_.index(*attributes, at, name.c_str(),
                                                                     buffers_.accessors().size())];
            if (name == "POSITION" || name == "NORMAL") {
                if (accessor.type != 5126 || accessor.components != 3 || !accessor.stands)
                    json_.refuse(joinedKeyPath(at, name), "numbers in another form",
                                 "three numbers of 32 bits in a buffer");
            } else if (name == "TEXCOORD_0" && accessor.type != 5126) {
                primitive.scaledPlaces = true;
            }
            if (name == "POSITION") {
                primitive.vertices = accessor.count;
                primitive.least = accessor.least;
                primitive.most = accessor.most;
            }
        }
        for (const auto& [name, value] : attributes->items())
            if (const auto& accessor = buffers_.accessors()[value.get<std::size_t>()];
                accessor.count != primitive.vertices)
                json_.refuse(joinedKeyPath(at, name), std::to_string(accessor.count) + " elements",
                             std::to_string(primitive.vertices) + ", one for each position");
        std::size_t corners = primitive.vertices;
        if (const auto indices = json_.index(given, path, "indices", buffers_.accessors().size())) {
            const auto& accessor = buffers_.accessors()[*indices];
            if (accessor.components != 1 || !accessor.stands ||
                (accessor.type != 5121 && accessor.type != 5123 && accessor.type != 5125))
                json_.refuse(joinedKeyPath(path, "indices"), "numbers in another form",
                             "whole numbers in a buffer");
            corners = accessor.count;
        }
        const std::size_t mode = json_.number(given, path, "mode").value_or(4);
        if (mode > 6)
            json_.refuse(joinedKeyPath(path, "mode"), std::to_string(mode), "0 to 6");
        if (mode == 4 && corners % 3 != 0)
            json_.refuse(path, "triangles of " + std::to_string(corners) + " corners",
                         "a multiple of three");
        primitive.faces = primitive.vertices == 0 ? 0 : facesOf(mode, corners);
        json_.index(given, path, "material", json_.list("materials").size());
        if (GltfJson::find(given, "targets"))
            appendUnique(into_.remarks, "shapes between which meshes could change are left out");
        return primitive;
    }

    void readMeshes() {
        json_.forEach(
            json_.list("meshes"), "meshes", [&](const Json& given, const std::string& path) {
                GltfFile::Mesh mesh;
                mesh.name = json_.text(given, path, "name");
                const Json* primitives = GltfJson::find(given, "primitives");
                const std::string at = joinedKeyPath(path, "primitives");
                if (!primitives || !primitives->is_array())
                    json_.refuse(at, "nothing", "a list");
                json_.forEach(*primitives, at,
                              [&](const Json& primitive, const std::string& where) {
                                  mesh.primitives.push_back(primitiveOf(primitive, where));
                              });
                into_.meshes.push_back(std::move(mesh));
            });
    }

    osg::Matrixd transformOf(const Json& given, const std::string& path) const {
        double m[16], t[3] = {0, 0, 0}, r[4] = {0, 0, 0, 1}, s[3] = {1, 1, 1};
        if (json_.numbers(given, path, "matrix", m, 16)) {
            if (m[3] != 0.0 || m[7] != 0.0 || m[11] != 0.0 || m[15] != 1.0)
                json_.refuse(joinedKeyPath(path, "matrix"), "a matrix with perspective",
                             "0, 0, 0, 1 in its last row");
            return osg::Matrixd(m); // columns of theirs are rows of ours
        }
        json_.numbers(given, path, "translation", t, 3);
        json_.numbers(given, path, "rotation", r, 4);
        json_.numbers(given, path, "scale", s, 3);
        return osg::Matrixd::scale(s[0], s[1], s[2]) *
               osg::Matrixd::rotate(osg::Quat(r[0], r[1], r[2], r[3])) *
               osg::Matrixd::translate(t[0], t[1], t[2]);
    }

    void readNodes() {
        const Json& nodes = json_.list("nodes");
        json_.forEach(nodes, "nodes", [&](const Json& given, const std::string& path) {
            remarkOtherWords(given, path,
                             {"camera", "children", "skin", "matrix", "mesh", "rotation", "scale",
                              "translation", "weights"},
                             into_.remarks);
            GltfFile::Node node;
            node.name = json_.text(given, path, "name");
            node.transform = transformOf(given, path);
            node.mesh = json_.index(given, path, "mesh", into_.meshes.size());
            node.children = json_.indices(given, path, "children", nodes.size());
            into_.nodes.push_back(std::move(node));
        });
        const Json& scenes = json_.list("scenes");
        if (scenes.empty())
            json_.refuse("scenes", "nothing", "a scene");
        const std::size_t shown = json_.index(json_.root(), "", "scene", scenes.size()).value_or(0);
        if (!scenes[shown].is_object())
            json_.refuse("scenes." + std::to_string(shown), shownJson(scenes[shown]), "an object");
        into_.roots =
            json_.indices(scenes[shown], "scenes." + std::to_string(shown), "nodes", nodes.size());
        checkTree();
        if (scenes.size() > 1)
            into_.remarks.push_back("of " + std::to_string(scenes.size()) +
                                    " scenes only one is shown");
    }

    /// Every node in one place: what holds itself would be read for ever.
    void checkTree() {
        std::vector<bool> placed(into_.nodes.size(), false);
        std::vector<std::pair<std::size_t, int>> open; // with their levels
        for (const std::size_t root : into_.roots)
            open.emplace_back(root, 1);
        while (!open.empty()) {
            const auto [node, level] = open.back();
            open.pop_back();
            if (level > mostLevels)
                json_.refuse("nodes." + std::to_string(node),
                             "a node in more than " + std::to_string(mostLevels) + " levels",
                             "a model in fewer levels");
            if (placed[node])
                json_.refuse("nodes." + std::to_string(node), "a node in two places",
                             "nodes in a tree");
            placed[node] = true;
            placed_.push_back(node);
            for (const std::size_t child : into_.nodes[node].children)
                open.emplace_back(child, level + 1);
        }
    }

    const GltfJson& json_;
    GltfFile& into_;
    GltfBuffers buffers_;
    std::vector<std::size_t> placed_; ///< nodes of the scene that is shown
};

} // namespace

GltfFile readGltfFile(const fs::path& place, const fs::path& file) {
    const GltfJson json(place, file);
    checkAsset(json);
    GltfFile gltf;
    GltfText(json, gltf).read();
    return gltf;
}

std::string decodedUri(const std::string& uri) {
    std::string text;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        const auto digits = std::string_view(uri).substr(std::min(i + 1, uri.size()), 2);
        constexpr std::string_view hexadecimal = "0123456789ABCDEFabcdef";
        if (uri[i] == '%' && digits.size() == 2 &&
            digits.find_first_not_of(hexadecimal) == digits.npos) {
            text += static_cast<char>(std::stoi(std::string(digits), nullptr, 16));
            i += 2;
        } else {
            text += uri[i];
        }
    }
    return text;
}

} // namespace irsg
