#include "tools/samples/GltfWriter.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include <nlohmann/json.hpp>

#include "irsg/core/FileReplacement.h"

namespace smat {
namespace {

using Json = nlohmann::ordered_json;

constexpr int arrayBuffer = 34962, elementBuffer = 34963, floats = 5126, integers = 5125;

std::string base64(const std::string& bytes) {
    static constexpr char digits[] =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t three = 0;
        for (std::size_t k = 0; k < 3; ++k)
            three =
                three << 8 | (i + k < bytes.size() ? static_cast<std::uint8_t>(bytes[i + k]) : 0U);
        for (std::size_t k = 0; k < 4; ++k)
            text += i + k <= bytes.size() ? digits[three >> (18 - 6 * k) & 63] : '=';
    }
    return text;
}

/// Buffer, views and accessors of a file.
class Buffer {
  public:
    template <typename Value>
    std::size_t add(const std::vector<Value>& values, int target) {
        const bool isIndex = target == elementBuffer;
        const std::size_t count = isIndex ? values.size() : values.size() / 3;
        Json accessor{{"bufferView", views_.size()},
                      {"componentType", isIndex ? integers : floats},
                      {"count", count},
                      {"type", isIndex ? "SCALAR" : "VEC3"}};
        if (!isIndex) {
            std::vector<double> low(3, HUGE_VAL), high(3, -HUGE_VAL);
            for (std::size_t i = 0; i < values.size(); ++i) {
                low[i % 3] = std::min(low[i % 3], static_cast<double>(values[i]));
                high[i % 3] = std::max(high[i % 3], static_cast<double>(values[i]));
            }
            accessor["min"] = low;
            accessor["max"] = high;
        }
        const std::size_t size = values.size() * sizeof(Value);
        views_.push_back({{"buffer", 0},
                          {"byteOffset", bytes_.size()},
                          {"byteLength", size},
                          {"target", target}});
        bytes_.append(reinterpret_cast<const char*>(values.data()), size);
        accessors_.push_back(std::move(accessor));
        return accessors_.size() - 1;
    }
    void moveTo(Json& root) {
        root["accessors"] = std::move(accessors_);
        root["bufferViews"] = std::move(views_);
        root["buffers"] = {{{"byteLength", bytes_.size()},
                            {"uri", "data:application/octet-stream;base64," + base64(bytes_)}}};
    }

  private:
    std::string bytes_;
    Json views_ = Json::array(), accessors_ = Json::array();
};

} // namespace

GltfWriter::GltfWriter(std::string generator, double unit_m)
    : generator_(std::move(generator)), unit_m_(unit_m) {}

void GltfWriter::addMesh(const FlightSurface& surface, std::span<const FlightVertex> vertices,
                         std::span<const FlightPrimitive> primitives) {
    auto material = static_cast<std::size_t>(
        std::ranges::find(materials_, surface.name, &FlightSurface::name) - materials_.begin());
    if (material == materials_.size())
        materials_.push_back(surface);
    if (std::ranges::find(objects_, object_) == objects_.end())
        objects_.push_back(object_);
    Part& part = parts_[{object_, material}];
    const auto first = static_cast<std::uint32_t>(part.positions.size() / 3);
    for (const FlightVertex& vertex : vertices) {
        // x starboard, y nose, z up become -x, z, y.
        const auto put = [](std::vector<float>& values, const irsg::Vec3& v, double scale) {
            for (const double value : {-v.x, v.z, v.y})
                values.push_back(static_cast<float>(value * scale));
        };
        put(part.positions, vertex.position, 1.0 / unit_m_);
        put(part.normals, vertex.normal, 1.0);
    }
    for (const FlightPrimitive& primitive : primitives) {
        const auto& at = primitive.indices;
        for (std::size_t i = 0; i + 2 < at.size(); ++i) {
            const bool isFan = primitive.kind == FlightPrimitive::Kind::fan;
            std::uint32_t corners[] = {isFan ? at[0] : at[i], at[i + 1], at[i + 2]};
            if (!isFan && i % 2 == 1)
                std::swap(corners[0], corners[1]);
            for (const std::uint32_t corner : corners)
                part.triangles.push_back(first + corner);
        }
    }
}

std::string GltfWriter::text() const {
    Json root{{"asset", {{"version", "2.0"}, {"generator", generator_}}}, {"scene", 0}};
    Json nodes = Json::array(), meshes = Json::array(), children = Json::array();
    Buffer buffer;
    for (const std::string& object : objects_) {
        Json primitives = Json::array();
        for (const auto& [key, part] : parts_)
            if (key.first == object) {
                const std::size_t positions = buffer.add(part.positions, arrayBuffer),
                                  normals = buffer.add(part.normals, arrayBuffer),
                                  indices = buffer.add(part.triangles, elementBuffer);
                primitives.push_back(
                    {{"attributes", {{"POSITION", positions}, {"NORMAL", normals}}},
                     {"indices", indices},
                     {"material", key.second}});
            }
        nodes.push_back({{"name", object}, {"mesh", meshes.size()}});
        meshes.push_back({{"name", object}, {"primitives", std::move(primitives)}});
        children.push_back(nodes.size() - 1);
    }
    root["scenes"] = {{{"nodes", std::move(children)}}};
    root["nodes"] = std::move(nodes);
    root["meshes"] = std::move(meshes);
    for (const FlightSurface& material : materials_) {
        const auto part = [](std::uint8_t value) { return std::round(value / 2.55) / 100.0; };
        Json one{{"name", material.name},
                 {"pbrMetallicRoughness",
                  {{"baseColorFactor",
                    {part(material.look.red), part(material.look.green), part(material.look.blue),
                     1.0 - material.look.clear}},
                   {"metallicFactor", 0.0}}}};
        if (material.twoSided)
            one["doubleSided"] = true;
        if (material.look.clear > 0.0)
            one["alphaMode"] = "BLEND";
        root["materials"].push_back(std::move(one));
    }
    buffer.moveTo(root);
    return root.dump(1) + "\n";
}

void GltfWriter::save(const std::filesystem::path& file) const {
    irsg::writeFileDurably(file, text());
}

} // namespace smat
