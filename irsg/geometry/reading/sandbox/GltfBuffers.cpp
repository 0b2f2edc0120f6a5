#include "irsg/geometry/reading/sandbox/GltfBuffers.h"

#include <algorithm>
#include <filesystem>
#include <string_view>

#include "irsg/core/WrittenPath.h"
#include "irsg/geometry/reading/OpenableFiles.h"
#include "irsg/geometry/reading/sandbox/GltfFile.h"

namespace irsg {

using nlohmann::json;

namespace {

/// Bytes that a text in base64 stands for.
std::size_t decodedSize(std::string_view text) {
    while (!text.empty() && text.back() == '=')
        text.remove_suffix(1);
    return text.size() * 3 / 4;
}

/// Bytes of a number of a component type; 0 for one that there is not.
std::size_t sizeOfType(std::size_t type) {
    return type == 5120 || type == 5121   ? 1
           : type == 5122 || type == 5123 ? 2
           : type == 5125 || type == 5126 ? 4
                                          : 0;
}

} // namespace

GltfBuffers::GltfBuffers(const GltfJson& json, std::vector<std::string>& remarks) : json_(json) {
    readViews();
    readAccessors(remarks);
    json_.forEach(json_.list("images"), "images", [&](const auto& image, const std::string& path) {
        if (const auto view = json_.index(image, path, "bufferView", views_.size()))
            views_[*view].used_B = views_[*view].length_B;
    });
}

std::size_t GltfBuffers::sizeOfUri(const std::string& uri, const std::string& path) const {
    if (uri.starts_with("data:")) {
        const auto comma = uri.find(',');
        const auto mark = uri.find(";base64");
        if (comma == uri.npos || mark == uri.npos || mark > comma)
            json_.refuse(path, "data in another form", "data in base64");
        return decodedSize(std::string_view(uri).substr(comma + 1));
    }
    const std::string name = decodedUri(uri);
    if (const auto refusal = refusalOf(name, FileKind::buffers))
        json_.refuse(path, *refusal, expectationOf(FileKind::buffers));
    std::error_code failure;
    for (const std::string& written : {uri, name}) {
        const auto beside = findWritten(json_.file().parent_path(), written).file;
        if (std::filesystem::is_regular_file(beside, failure))
            return static_cast<std::size_t>(std::filesystem::file_size(beside, failure));
    }
    json_.refuse(path, name + ", which is missing", "a file beside the model");
}

void GltfBuffers::readViews() {
    std::vector<std::size_t> sizes;
    json_.forEach(
        json_.list("buffers"), "buffers", [&](const json& buffer, const std::string& path) {
            const std::size_t size = json_.needed(buffer, path, "byteLength");
            const std::string uri = json_.text(buffer, path, "uri");
            const std::size_t there = !uri.empty() ? sizeOfUri(uri, joinedKeyPath(path, "uri"))
                                                   : json_.chunk_B().value_or(0);
            if (size > there)
                json_.refuse(joinedKeyPath(path, "byteLength"), std::to_string(size),
                             "at most " + std::to_string(there) + " bytes, which there are");
            sizes.push_back(size);
        });
    json_.forEach(
        json_.list("bufferViews"), "bufferViews", [&](const json& view, const std::string& path) {
            const auto buffer = json_.index(view, path, "buffer", sizes.size());
            if (!buffer)
                json_.refuse(joinedKeyPath(path, "buffer"), "nothing", "a buffer");
            const std::size_t begin = json_.number(view, path, "byteOffset").value_or(0);
            const std::size_t size = json_.needed(view, path, "byteLength");
            if (begin > sizes[*buffer] || size > sizes[*buffer] - begin)
                json_.refuse(joinedKeyPath(path, "byteLength"), std::to_string(size),
                             "at most " +
                                 std::to_string(sizes[*buffer] - std::min(begin, sizes[*buffer])) +
                                 ", what is left of its buffer");
            const std::size_t stride = json_.number(view, path, "byteStride").value_or(0);
            if (stride > 252)
                json_.refuse(joinedKeyPath(path, "byteStride"), std::to_string(stride), "4 to 252");
            views_.push_back({size, stride, 0});
        });
}

// `count` elements of `size_B` bytes from an offset in a view.
void GltfBuffers::useStretch(const json& object, const std::string& path, View& view,
                             std::size_t count, std::size_t size_B) const {
    if (count == 0)
        return;
    const std::size_t begin = json_.number(object, path, "byteOffset").value_or(0);
    const std::size_t step = view.stride_B > 0 ? std::max(view.stride_B, size_B) : size_B;
    if (begin > view.length_B || view.length_B - begin < size_B ||
        count - 1 > (view.length_B - begin - size_B) / step)
        json_.refuse(joinedKeyPath(path, "count"),
                     std::to_string(count) + " times " + std::to_string(step) + " bytes",
                     "at most " + std::to_string(view.length_B) + " bytes, which its view has");
    view.used_B = std::max(view.used_B, begin + (count - 1) * step + size_B);
}

void GltfBuffers::readAccessors(std::vector<std::string>& remarks) {
    static const std::pair<std::string_view, std::size_t> shapes[] = {
        {"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4},
        {"MAT2", 4},   {"MAT3", 9}, {"MAT4", 16}};
    json_.forEach(
        json_.list("accessors"), "accessors", [&](const json& given, const std::string& path) {
            remarkOtherWords(given, path,
                             {"bufferView", "byteOffset", "componentType", "normalized", "count",
                              "type", "max", "min", "sparse"},
                             remarks);
            Accessor accessor;
            accessor.count = json_.needed(given, path, "count");
            accessor.type = json_.needed(given, path, "componentType");
            const std::string shape = json_.text(given, path, "type");
            const auto* found =
                std::ranges::find(shapes, shape, &std::pair<std::string_view, std::size_t>::first);
            if (found == std::end(shapes) || sizeOfType(accessor.type) == 0)
                json_.refuse(path,
                             "numbers of type " + std::to_string(accessor.type) + ", " + shape,
                             "5120 to 5126, and SCALAR to MAT4");
            accessor.components = found->second;
            const std::size_t size = accessor.components * sizeOfType(accessor.type);
            if (const auto view = json_.index(given, path, "bufferView", views_.size())) {
                useStretch(given, path, views_[*view], accessor.count, size);
                accessor.stands = true;
            }
            if (GltfJson::find(given, "sparse"))
                accessor.stands = false;
            double values[3];
            if (accessor.components == 3 && accessor.type == 5126) {
                if (json_.numbers(given, path, "min", values, 3))
                    accessor.least = osg::Vec3d(values[0], values[1], values[2]);
                if (json_.numbers(given, path, "max", values, 3))
                    accessor.most = osg::Vec3d(values[0], values[1], values[2]);
            }
            accessors_.push_back(accessor);
        });
}

std::size_t GltfBuffers::unused_B() const {
    std::size_t bytes = 0;
    for (const View& view : views_)
        if (view.length_B - view.used_B > std::max<std::size_t>(3, view.stride_B))
            bytes += view.length_B - view.used_B;
    return bytes;
}

void remarkOtherWords(const json& object, const std::string& path,
                      std::initializer_list<std::string_view> known,
                      std::vector<std::string>& remarks) {
    for (const auto& [key, value] : object.items())
        if (std::ranges::find(known, key) == known.end() && key != "name" && key != "extensions" &&
            key != "extras")
            remarks.push_back(joinedKeyPath(path, key) + " is no word of the format");
}

} // namespace irsg
