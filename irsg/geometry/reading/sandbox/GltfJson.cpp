#include "irsg/geometry/reading/sandbox/GltfJson.h"
#include "irsg/geometry/reading/text/ModelText.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "irsg/core/Errors.h"
#include "irsg/core/Utf8.h"

namespace irsg {

using nlohmann::json;

namespace {

std::uint32_t littleEndian(std::string_view bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 4; i-- > 0;)
        value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
    return value;
}

} // namespace

GltfJson::GltfJson(const std::filesystem::path& place, const std::filesystem::path& file)
    : file_(file) {
    std::string bytes = readModelBytes(place, file);
    if (bytes.starts_with("glTF"))
        bytes = textOfBinary(bytes);
    if (!isUtf8(bytes)) // names in Latin-1; whoever makes the graph says so
        bytes = utf8Text(bytes);
    root_ = parseJson(bytes, file_.string(), {"a scene of glTF 2.0 (JSON)", 64, false});
    if (!root_.is_object())
        refuse("", shownJson(root_), "an object");
}

void GltfJson::refuse(const std::string& path, std::string value, std::string expected) const {
    throw InputError({file_.string(), path, std::move(value), std::move(expected)});
}

std::string GltfJson::textOfBinary(const std::string& bytes) {
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
                   left < 8 ? "a chunk of " + std::to_string(left) + " bytes"
                            : "a chunk of " + std::to_string(littleEndian(bytes, begin)) + " bytes",
                   "a head of 8 bytes and no more than is left");
        const std::size_t size = littleEndian(bytes, begin);
        const std::string_view kind = std::string_view(bytes).substr(begin + 4, 4);
        if (begin == 12 && kind == "JSON")
            text = bytes.substr(begin + 8, size);
        else if (kind == std::string_view("BIN\0", 4) && !chunk_B_)
            chunk_B_ = size;
        begin += 8 + size;
    }
    if (text.empty())
        refuse(at(12), "a chunk of another kind", "JSON");
    return text;
}

const json& GltfJson::list(const char* key) const {
    static const json none = json::array();
    const auto found = root_.find(key);
    if (found == root_.end())
        return none;
    if (!found->is_array())
        refuse(key, shownJson(*found), "a list");
    return *found;
}

const json* GltfJson::find(const json& object, const char* key) {
    const auto found = object.find(key);
    return found == object.end() ? nullptr : &*found;
}

std::optional<std::size_t> GltfJson::number(const json& object, const std::string& path,
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
std::size_t GltfJson::needed(const json& object, const std::string& path, const char* key) const {
    const auto value = number(object, path, key);
    if (!value)
        refuse(joinedKeyPath(path, key), "nothing", "a whole number of 0 or more");
    return *value;
}
std::optional<std::size_t> GltfJson::index(const json& object, const std::string& path,
                                           const char* key, std::size_t end) const {
    const auto value = number(object, path, key);
    if (value && *value >= end)
        refuse(joinedKeyPath(path, key), std::to_string(*value),
               "a number below " + std::to_string(end) + ": there are no more");
    return value;
}
std::string GltfJson::text(const json& object, const std::string& path, const char* key) const {
    const json* value = find(object, key);
    if (value && !value->is_string())
        refuse(joinedKeyPath(path, key), shownJson(*value), "a text");
    return value ? value->get<std::string>() : "";
}
bool GltfJson::numbers(const json& object, const std::string& path, const char* key, double* into,
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

std::vector<std::size_t> GltfJson::indices(const json& object, const std::string& path,
                                           const char* key, std::size_t end) const {
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

} // namespace irsg
