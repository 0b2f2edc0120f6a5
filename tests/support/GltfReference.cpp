#include "tests/support/GltfReference.h"

#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <vector>

#include <nlohmann/json.hpp>
#include <osg/Matrixd>
#include <osg/Quat>

namespace irsg::test {

namespace {

using nlohmann::json;

std::string bytesOf(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    if (!in) {
        throw std::runtime_error("no " + file.string());
    }
    return {std::istreambuf_iterator<char>(in), {}};
}

std::string decoded(const std::string& text) {
    static const std::string digits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    unsigned int held = 0;
    int bits = 0;
    for (const char c : text) {
        const auto value = digits.find(c);
        if (value == digits.npos) {
            break;
        }
        held = held << 6 | static_cast<unsigned int>(value);
        bits += 6;
        if (bits >= 8) {
            bits -= 8;
            bytes += static_cast<char>(held >> bits & 0xFF);
        }
    }
    return bytes;
}

class Reader {
  public:
    explicit Reader(const std::filesystem::path& file) {
        const std::string bytes = bytesOf(file);
        std::string text = bytes, chunk;
        if (bytes.substr(0, 4) == "glTF") {
            std::uint32_t length = 0;
            std::memcpy(&length, &bytes.at(12), 4);
            text = bytes.substr(20, length);
            if (bytes.size() > 28 + length) {
                chunk = bytes.substr(28 + length);
            }
        }
        model_ = json::parse(text);
        for (const auto& buffer : model_.value("buffers", json::array())) {
            const std::string uri = buffer.value("uri", "");
            buffers_.push_back(uri.empty() ? chunk
                               : uri.substr(0, 5) == "data:"
                                   ? decoded(uri.substr(uri.find(',') + 1))
                                   : bytesOf(file.parent_path() / uri));
        }
        const auto& scene = model_.at("scenes").at(model_.value("scene", 0u));
        for (const auto& node : scene.at("nodes")) {
            walk(model_.at("nodes").at(node.get<std::size_t>()), osg::Matrixd());
        }
    }
    GltfReference result;

  private:
    void walk(const json& node, const osg::Matrixd& above) {
        osg::Matrixd own;
        if (node.contains("matrix")) {
            double values[16];
            for (std::size_t i = 0; i < 16; ++i) {
                values[i] = node["matrix"][i];
            }
            own.set(values);
        } else {
            const auto t = node.value("translation", std::vector<double>{0, 0, 0});
            const auto r = node.value("rotation", std::vector<double>{0, 0, 0, 1});
            const auto s = node.value("scale", std::vector<double>{1, 1, 1});
            own = osg::Matrixd::scale(s[0], s[1], s[2]) *
                  osg::Matrixd::rotate(osg::Quat(r[0], r[1], r[2], r[3])) *
                  osg::Matrixd::translate(t[0], t[1], t[2]);
        }
        const osg::Matrixd matrix = own * above;
        if (node.contains("mesh")) {
            for (const auto& part :
                 model_["meshes"][node["mesh"].get<std::size_t>()]["primitives"]) {
                add(part, matrix);
            }
        }
        for (const auto& child : node.value("children", json::array())) {
            walk(model_["nodes"][child.get<std::size_t>()], matrix);
        }
    }

    double number(const json& accessor, std::size_t element, std::size_t component) const {
        const auto& view = model_["bufferViews"][accessor.at("bufferView").get<std::size_t>()];
        const int type = accessor["componentType"];
        const std::size_t size = type == 5121 ? 1 : type == 5123 ? 2 : 4;
        const std::size_t count = accessor["type"] == "SCALAR" ? 1 : 3;
        const std::size_t step = view.value("byteStride", size * count);
        const char* at = &buffers_.at(view["buffer"].get<std::size_t>())
                              .at(view.value("byteOffset", std::size_t{0}) +
                                  accessor.value("byteOffset", std::size_t{0}) + element * step +
                                  component * size);
        if (type == 5126) {
            float value = 0;
            std::memcpy(&value, at, 4);
            return static_cast<double>(value);
        }
        std::uint32_t value = 0;
        std::memcpy(&value, at, size);
        return value;
    }

    void add(const json& part, const osg::Matrixd& matrix) {
        const auto& positions =
            model_["accessors"][part["attributes"]["POSITION"].get<std::size_t>()];
        std::vector<std::size_t> order;
        if (part.contains("indices")) {
            const auto& indices = model_["accessors"][part["indices"].get<std::size_t>()];
            for (std::size_t i = 0; i < indices["count"].get<std::size_t>(); ++i) {
                order.push_back(static_cast<std::size_t>(number(indices, i, 0)));
            }
        } else {
            for (std::size_t i = 0; i < positions["count"].get<std::size_t>(); ++i) {
                order.push_back(i);
            }
        }
        const auto corner = [&](std::size_t i) {
            osg::Vec3d p;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                p[static_cast<int>(axis)] = number(positions, order.at(i), axis);
            }
            return p * matrix;
        };
        std::string material;
        if (part.contains("material")) {
            material = model_["materials"][part["material"].get<std::size_t>()].value("name", "");
        }
        const auto triangle = [&](std::size_t a, std::size_t b, std::size_t c) {
            const osg::Vec3d p = corner(a), q = corner(b), r = corner(c);
            const double area = 0.5 * ((q - p) ^ (r - p)).length();
            result.area += area;
            result.areaOfMaterials[material] += area;
            ++result.triangles;
            for (const auto& each : {p, q, r}) {
                result.bounds.expandBy(each);
            }
        };
        const int mode = part.value("mode", 4);
        if (mode == 4) {
            for (std::size_t i = 0; i + 2 < order.size(); i += 3) {
                triangle(i, i + 1, i + 2);
            }
        } else if (mode == 5 || mode == 6) {
            for (std::size_t i = 2; i < order.size(); ++i) {
                triangle(mode == 5 ? i - 2 : 0, i - 1, i);
            }
        }
    }

    json model_;
    std::vector<std::string> buffers_;
};

} // namespace

GltfReference readGltfReference(const std::filesystem::path& file) {
    return Reader(file).result;
}

} // namespace irsg::test
