#include "irsg/scene/model/apart/GltfFile.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include <nlohmann/json.hpp>
#include <osg/Quat>

#include "irsg/radiometry/Errors.h"
#include "irsg/radiometry/FileReading.h"
#include "irsg/radiometry/JsonText.h"
#include "irsg/radiometry/NewLines.h"
#include "irsg/scene/model/OpenableFiles.h"

namespace irsg {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr std::string_view known[] = {"KHR_texture_transform", "KHR_lights_punctual"};
/// Extensions of these beginnings change what a surface looks like, not where it is.
constexpr std::string_view materials[] = {"KHR_materials_", "KHR_xmp", "KHR_texture_basisu",
                                          "EXT_texture_", "MSFT_texture_"};

std::uint32_t littleEndian(std::string_view bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 4; i-- > 0;)
        value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
    return value;
}

/// Bytes that a text in base64 stands for.
std::size_t decodedSize(std::string_view text) {
    while (!text.empty() && text.back() == '=')
        text.remove_suffix(1);
    return text.size() * 3 / 4;
}

class GltfText {
  public:
    GltfText(const fs::path& file, GltfFile& into) : file_(file), into_(into) {}

    void read(const fs::path& place) {
        std::string bytes = readFile(place, largestModel_B);
        if (bytes.starts_with("glTF"))
            bytes = textOfBinary(bytes);
        json_ = parseJson(bytes, file_.string(), {"a scene of glTF 2.0 (JSON)", 64, false});
        if (!json_.is_object())
            refuse("", shownJson(json_), "an object");
        readAsset();
        readBuffers();
        readAccessors();
        readMeshes();
        readNodes();
        remarkUnused();
        into_.materials = list("materials").size();
        for (const char* kind : {"animations", "skins"})
            if (const auto count = list(kind).size(); count > 0)
                into_.remarks.push_back(std::to_string(count) + " " + kind +
                                        " are not played: parts are where the file puts them");
    }

  private:
    [[noreturn]] void refuse(const std::string& path, std::string value,
                             std::string expected) const {
        throw InputError({file_.string(), path, std::move(value), std::move(expected)});
    }

    /// The text of a .glb, whose chunks must be there.
    std::string textOfBinary(const std::string& bytes) {
        const auto at = [](std::size_t byte) { return "byte " + std::to_string(byte); };
        if (bytes.size() < 20)
            refuse(at(bytes.size()), "the end of the file", "a head and a chunk of 20 bytes");
        if (const auto version = littleEndian(bytes, 4); version != 2)
            refuse(at(4), "version " + std::to_string(version), "glTF 2");
        const std::size_t length = littleEndian(bytes, 8);
        if (length > bytes.size())
            refuse(at(8), "a file of " + std::to_string(length) + " bytes",
                   "at most " + std::to_string(bytes.size()) + ", which there are");
        std::string text;
        for (std::size_t begin = 12; begin < length;) {
            const std::size_t left = length - begin;
            if (left < 8 || littleEndian(bytes, begin) > left - 8)
                refuse(at(begin),
                       left < 8
                           ? "a chunk of " + std::to_string(left) + " bytes"
                           : "a chunk of " + std::to_string(littleEndian(bytes, begin)) + " bytes",
                       "a head of 8 bytes and no more than is left");
            const std::size_t size = littleEndian(bytes, begin);
            const std::string_view kind = std::string_view(bytes).substr(begin + 4, 4);
            if (begin == 12 && kind == "JSON")
                text = bytes.substr(begin + 8, size);
            else if (kind == std::string_view("BIN\0", 4) && !chunk_)
                chunk_ = size;
            begin += 8 + size;
        }
        if (text.empty())
            refuse(at(12), "a chunk of another kind", "JSON");
        return text;
    }

    /// A list of the outermost object; an empty one where it is missing.
    const json& list(const char* key) const {
        static const json none = json::array();
        const auto found = json_.find(key);
        if (found == json_.end())
            return none;
        if (!found->is_array())
            refuse(key, shownJson(*found), "a list");
        return *found;
    }

    /// Calls each(object, path) with every object of a list.
    template <typename Each>
    void forEach(const json& values, const std::string& path, const Each& each) const {
        for (std::size_t i = 0; i < values.size(); ++i) {
            const std::string at = joinedKeyPath(path, std::to_string(i));
            if (!values[i].is_object())
                refuse(at, shownJson(values[i]), "an object");
            each(values[i], at);
        }
    }

    /// What another word would have said is lost.
    void remarkOtherWords(const json& object, const std::string& path,
                          std::initializer_list<std::string_view> known) {
        for (const auto& [key, value] : object.items())
            if (std::ranges::find(known, key) == known.end() && key != "name" &&
                key != "extensions" && key != "extras")
                into_.remarks.push_back(joinedKeyPath(path, key) + " is no word of the format");
    }

    const json* find(const json& object, const char* key) const {
        const auto found = object.find(key);
        return found == object.end() ? nullptr : &*found;
    }

    /// A whole number from 0 on, or nothing.
    std::optional<std::size_t> number(const json& object, const std::string& path,
                                      const char* key) const {
        const json* value = find(object, key);
        if (!value)
            return std::nullopt;
        constexpr double most = 1e15;
        const double read = value->is_number() ? value->get<double>() : -1.0;
        if (!(read >= 0.0 && read <= most) || read != std::floor(read))
            refuse(joinedKeyPath(path, key), shownJson(*value), "a whole number of 0 or more");
        return static_cast<std::size_t>(read);
    }
    std::size_t needed(const json& object, const std::string& path, const char* key) const {
        const auto value = number(object, path, key);
        if (!value)
            refuse(joinedKeyPath(path, key), "nothing", "a whole number of 0 or more");
        return *value;
    }
    std::optional<std::size_t> index(const json& object, const std::string& path, const char* key,
                                     std::size_t end) const {
        const auto value = number(object, path, key);
        if (value && *value >= end)
            refuse(joinedKeyPath(path, key), std::to_string(*value),
                   "a number below " + std::to_string(end) + ": there are no more");
        return value;
    }
    std::string text(const json& object, const std::string& path, const char* key) const {
        const json* value = find(object, key);
        if (value && !value->is_string())
            refuse(joinedKeyPath(path, key), shownJson(*value), "a text");
        return value ? value->get<std::string>() : "";
    }
    /// So many finite numbers; false where the key is missing.
    bool numbers(const json& object, const std::string& path, const char* key, double* into,
                 std::size_t count) const {
        const json* value = find(object, key);
        if (!value)
            return false;
        if (!value->is_array() || value->size() != count ||
            !std::ranges::all_of(*value, [](const json& each) { return each.is_number(); }))
            refuse(joinedKeyPath(path, key), shownJson(*value), std::to_string(count) + " numbers");
        for (std::size_t i = 0; i < count; ++i)
            into[i] = (*value)[i].get<double>();
        return true;
    }

    void readAsset() const {
        const json* asset = find(json_, "asset");
        const std::string version =
            asset && asset->is_object() ? text(*asset, "asset", "version") : "";
        if (!version.starts_with("2."))
            refuse("asset.version", version.empty() ? "nothing" : "\"" + version + "\"",
                   "glTF of version 2");
        const json& required = list("extensionsRequired");
        for (std::size_t i = 0; i < required.size(); ++i) {
            const std::string name =
                required[i].is_string() ? required[i].get<std::string>() : shownJson(required[i]);
            if (std::ranges::find(known, name) == std::end(known) &&
                std::ranges::none_of(
                    materials, [&](std::string_view begin) { return name.starts_with(begin); }))
                refuse("extensionsRequired." + std::to_string(i), name,
                       "a file that can be read without this extension");
        }
    }

    std::size_t sizeOfUri(const std::string& uri, const std::string& path) const {
        if (uri.starts_with("data:")) {
            const auto comma = uri.find(',');
            const auto mark = uri.find(";base64");
            if (comma == uri.npos || mark == uri.npos || mark > comma)
                refuse(path, "data in another form", "data in base64");
            return decodedSize(std::string_view(uri).substr(comma + 1));
        }
        const std::string name = decodedUri(uri);
        if (const auto refusal = refusalOf(name, FileKind::buffers))
            refuse(path, *refusal, expectationOf(FileKind::buffers));
        std::error_code failure;
        for (const std::string& written : {uri, name}) {
            const fs::path beside = file_.parent_path() / written;
            if (fs::is_regular_file(beside, failure))
                return static_cast<std::size_t>(fs::file_size(beside, failure));
        }
        refuse(path, name + ", which is missing", "a file beside the model");
    }

    void readBuffers() {
        std::vector<std::size_t> sizes;
        forEach(list("buffers"), "buffers", [&](const json& buffer, const std::string& path) {
            const std::size_t size = needed(buffer, path, "byteLength");
            const std::string uri = text(buffer, path, "uri");
            const std::size_t there =
                !uri.empty() ? sizeOfUri(uri, joinedKeyPath(path, "uri")) : chunk_.value_or(0);
            if (size > there)
                refuse(joinedKeyPath(path, "byteLength"), std::to_string(size),
                       "at most " + std::to_string(there) + " bytes, which there are");
            sizes.push_back(size);
        });
        forEach(list("bufferViews"), "bufferViews", [&](const json& view, const std::string& path) {
            const auto buffer = index(view, path, "buffer", sizes.size());
            if (!buffer)
                refuse(joinedKeyPath(path, "buffer"), "nothing", "a buffer");
            const std::size_t begin = number(view, path, "byteOffset").value_or(0);
            const std::size_t size = needed(view, path, "byteLength");
            if (begin > sizes[*buffer] || size > sizes[*buffer] - begin)
                refuse(joinedKeyPath(path, "byteLength"), std::to_string(size),
                       "at most " +
                           std::to_string(sizes[*buffer] - std::min(begin, sizes[*buffer])) +
                           ", what is left of its buffer");
            const std::size_t stride = number(view, path, "byteStride").value_or(0);
            if (stride > 252)
                refuse(joinedKeyPath(path, "byteStride"), std::to_string(stride), "4 to 252");
            views_.push_back({size, stride});
        });
    }

    struct Accessor {
        std::size_t count = 0, components = 0, type = 0;
        std::optional<osg::Vec3d> least, most;
        bool stands = false; ///< its numbers lie in a buffer, none replaced by others
    };

    static std::size_t sizeOfType(std::size_t type) {
        return type == 5120 || type == 5121   ? 1
               : type == 5122 || type == 5123 ? 2
               : type == 5125 || type == 5126 ? 4
                                              : 0;
    }

    /// `count` elements of `size` bytes from an offset in a view.
    void checkStretch(const json& object, const std::string& path, std::size_t view,
                      std::size_t count, std::size_t size) {
        const std::size_t begin = number(object, path, "byteOffset").value_or(0);
        const auto [length, stride] = views_[view];
        const std::size_t step = stride > 0 ? std::max(stride, size) : size;
        used_.resize(views_.size());
        if (count > 0 && (begin > length || length - begin < size ||
                          (count - 1) > (length - begin - size) / step))
            refuse(joinedKeyPath(path, "count"),
                   std::to_string(count) + " times " + std::to_string(step) + " bytes",
                   "at most " + std::to_string(length) + " bytes, which its view has");
        if (count > 0)
            used_[view] = std::max(used_[view], begin + (count - 1) * step + size);
    }

    /// A count that was damaged leaves bytes that belong to nothing, a reference a mesh or a node.
    void remarkUnused() {
        used_.resize(views_.size());
        forEach(list("images"), "images", [&](const json& image, const std::string& path) {
            if (const auto view = index(image, path, "bufferView", views_.size()))
                used_[*view] = views_[*view].first;
        });
        std::size_t bytes = 0;
        for (std::size_t i = 0; i < views_.size(); ++i)
            if (const auto [length, stride] = views_[i];
                length - used_[i] > std::max<std::size_t>(3, stride))
                bytes += length - used_[i];
        if (bytes > 0)
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

    void readAccessors() {
        static const std::pair<std::string_view, std::size_t> shapes[] = {
            {"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4},
            {"MAT2", 4},   {"MAT3", 9}, {"MAT4", 16}};
        forEach(list("accessors"), "accessors", [&](const json& given, const std::string& path) {
            remarkOtherWords(given, path,
                             {"bufferView", "byteOffset", "componentType", "normalized", "count",
                              "type", "max", "min", "sparse"});
            Accessor accessor;
            accessor.count = needed(given, path, "count");
            accessor.type = needed(given, path, "componentType");
            const std::string shape = text(given, path, "type");
            const auto* found =
                std::ranges::find(shapes, shape, &std::pair<std::string_view, std::size_t>::first);
            if (found == std::end(shapes) || sizeOfType(accessor.type) == 0)
                refuse(path, "numbers of type " + std::to_string(accessor.type) + ", " + shape,
                       "5120 to 5126, and SCALAR to MAT4");
            accessor.components = found->second;
            const std::size_t size = accessor.components * sizeOfType(accessor.type);
            if (const auto view = index(given, path, "bufferView", views_.size())) {
                checkStretch(given, path, *view, accessor.count, size);
                accessor.stands = true;
            }
            if (find(given, "sparse"))
                accessor.stands = false;
            double values[3];
            if (accessor.components == 3 && accessor.type == 5126) {
                if (numbers(given, path, "min", values, 3))
                    accessor.least = osg::Vec3d(values[0], values[1], values[2]);
                if (numbers(given, path, "max", values, 3))
                    accessor.most = osg::Vec3d(values[0], values[1], values[2]);
            }
            accessors_.push_back(accessor);
        });
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

    GltfFile::Primitive primitiveOf(const json& given, const std::string& path) {
        const json* attributes = find(given, "attributes");
        if (!attributes || !attributes->is_object())
            refuse(joinedKeyPath(path, "attributes"), "nothing", "an object");
        const std::string at = joinedKeyPath(path, "attributes");
        remarkOtherWords(given, path, {"attributes", "indices", "material", "mode", "targets"});
        GltfFile::Primitive primitive;
        for (const auto& [name, value] : attributes->items()) {
            const auto& accessor =
                accessors_[*index(*attributes, at, name.c_str(), accessors_.size())];
            if (name == "POSITION" || name == "NORMAL") {
                if (accessor.type != 5126 || accessor.components != 3 || !accessor.stands)
                    refuse(joinedKeyPath(at, name), "numbers in another form",
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
            if (const auto& accessor = accessors_[value.get<std::size_t>()];
                accessor.count != primitive.vertices)
                refuse(joinedKeyPath(at, name), std::to_string(accessor.count) + " elements",
                       std::to_string(primitive.vertices) + ", one for each position");
        std::size_t corners = primitive.vertices;
        if (const auto indices = index(given, path, "indices", accessors_.size())) {
            const auto& accessor = accessors_[*indices];
            if (accessor.components != 1 || !accessor.stands ||
                (accessor.type != 5121 && accessor.type != 5123 && accessor.type != 5125))
                refuse(joinedKeyPath(path, "indices"), "numbers in another form",
                       "whole numbers in a buffer");
            corners = accessor.count;
        }
        const std::size_t mode = number(given, path, "mode").value_or(4);
        if (mode > 6)
            refuse(joinedKeyPath(path, "mode"), std::to_string(mode), "0 to 6");
        if (mode == 4 && corners % 3 != 0)
            refuse(path, "triangles of " + std::to_string(corners) + " corners",
                   "a multiple of three");
        primitive.faces = primitive.vertices == 0 ? 0 : facesOf(mode, corners);
        index(given, path, "material", list("materials").size());
        if (find(given, "targets"))
            addNew(into_.remarks, "shapes between which meshes could change are left out");
        return primitive;
    }

    void readMeshes() {
        forEach(list("meshes"), "meshes", [&](const json& given, const std::string& path) {
            GltfFile::Mesh mesh;
            mesh.name = text(given, path, "name");
            const json* primitives = find(given, "primitives");
            const std::string at = joinedKeyPath(path, "primitives");
            if (!primitives || !primitives->is_array())
                refuse(at, "nothing", "a list");
            forEach(*primitives, at, [&](const json& primitive, const std::string& where) {
                mesh.primitives.push_back(primitiveOf(primitive, where));
            });
            into_.meshes.push_back(std::move(mesh));
        });
    }

    osg::Matrixd transformOf(const json& given, const std::string& path) const {
        double m[16], t[3] = {0, 0, 0}, r[4] = {0, 0, 0, 1}, s[3] = {1, 1, 1};
        if (numbers(given, path, "matrix", m, 16)) {
            if (m[3] != 0.0 || m[7] != 0.0 || m[11] != 0.0 || m[15] != 1.0)
                refuse(joinedKeyPath(path, "matrix"), "a matrix with perspective",
                       "0, 0, 0, 1 in its last row");
            return osg::Matrixd(m); // columns of theirs are rows of ours
        }
        numbers(given, path, "translation", t, 3);
        numbers(given, path, "rotation", r, 4);
        numbers(given, path, "scale", s, 3);
        return osg::Matrixd::scale(s[0], s[1], s[2]) *
               osg::Matrixd::rotate(osg::Quat(r[0], r[1], r[2], r[3])) *
               osg::Matrixd::translate(t[0], t[1], t[2]);
    }

    std::vector<std::size_t> indices(const json& object, const std::string& path, const char* key,
                                     std::size_t end) const {
        std::vector<std::size_t> found;
        const json* values = find(object, key);
        const std::string at = joinedKeyPath(path, key);
        if (values && !values->is_array())
            refuse(at, shownJson(*values), "a list");
        for (std::size_t i = 0; values && i < values->size(); ++i) {
            const json& value = (*values)[i];
            if (!value.is_number_unsigned() || value.get<std::size_t>() >= end)
                refuse(joinedKeyPath(at, std::to_string(i)), shownJson(value),
                       "a number below " + std::to_string(end));
            found.push_back(value.get<std::size_t>());
        }
        return found;
    }

    void readNodes() {
        const json& nodes = list("nodes");
        forEach(nodes, "nodes", [&](const json& given, const std::string& path) {
            remarkOtherWords(given, path,
                             {"camera", "children", "skin", "matrix", "mesh", "rotation", "scale",
                              "translation", "weights"});
            GltfFile::Node node;
            node.name = text(given, path, "name");
            node.transform = transformOf(given, path);
            node.mesh = index(given, path, "mesh", into_.meshes.size());
            node.children = indices(given, path, "children", nodes.size());
            into_.nodes.push_back(std::move(node));
        });
        const json& scenes = list("scenes");
        if (scenes.empty())
            refuse("scenes", "nothing", "a scene");
        const std::size_t shown = index(json_, "", "scene", scenes.size()).value_or(0);
        if (!scenes[shown].is_object())
            refuse("scenes." + std::to_string(shown), shownJson(scenes[shown]), "an object");
        into_.roots =
            indices(scenes[shown], "scenes." + std::to_string(shown), "nodes", nodes.size());
        checkTree();
        if (scenes.size() > 1)
            into_.remarks.push_back("of " + std::to_string(scenes.size()) +
                                    " scenes only one is shown");
    }

    /// Every node in one place: what holds itself would be read for ever.
    void checkTree() {
        std::vector<bool> placed(into_.nodes.size(), false);
        std::vector<std::size_t> open = into_.roots;
        while (!open.empty()) {
            const std::size_t node = open.back();
            open.pop_back();
            if (placed[node])
                refuse("nodes." + std::to_string(node), "a node in two places", "nodes in a tree");
            placed[node] = true;
            placed_.push_back(node);
            const auto& children = into_.nodes[node].children;
            open.insert(open.end(), children.begin(), children.end());
        }
    }

    const fs::path& file_;
    GltfFile& into_;
    json json_;
    std::optional<std::size_t> chunk_; ///< length of the binary chunk of a .glb
    std::vector<std::pair<std::size_t, std::size_t>> views_; ///< length, stride
    std::vector<std::size_t> used_;                          ///< bytes of each view
    std::vector<Accessor> accessors_;
    std::vector<std::size_t> placed_; ///< nodes of the scene that is shown
};

} // namespace

GltfFile readGltfFile(const fs::path& place, const fs::path& file) {
    GltfFile gltf;
    GltfText(file, gltf).read(place);
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
