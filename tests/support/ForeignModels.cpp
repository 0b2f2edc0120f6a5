#include "tests/support/ForeignModels.h"

#include <cstring>
#include <sstream>

namespace irsg::test {

namespace {

template <typename Number>
std::string raw(Number value) {
    return {reinterpret_cast<const char*>(&value), sizeof value};
}

std::string number(double value) {
    std::ostringstream text;
    text.precision(17);
    text << value;
    return text.str();
}

} // namespace

std::string base64(const std::string& bytes) {
    static const char* const digits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        unsigned int held = 0;
        for (std::size_t j = 0; j < 3; ++j) {
            held =
                held << 8 | (i + j < bytes.size() ? static_cast<unsigned char>(bytes[i + j]) : 0u);
        }
        for (std::size_t j = 0; j < 4; ++j) {
            text += i + j > bytes.size() ? '=' : digits[held >> (18 - 6 * j) & 63];
        }
    }
    return text;
}

GltfWriter::GltfWriter()
    : json({{"asset", {{"version", "2.0"}}},
            {"scene", 0},
            {"scenes", {{{"nodes", nlohmann::json::array()}}}}}) {}

std::size_t GltfWriter::accessor(const std::string& bytes, int type, const char* shape,
                                 std::size_t count) {
    while (buffer_.size() % 4 != 0) {
        buffer_ += '\0';
    }
    json["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", buffer_.size()}, {"byteLength", bytes.size()}});
    buffer_ += bytes;
    json["accessors"].push_back({{"bufferView", json["bufferViews"].size() - 1},
                                 {"componentType", type},
                                 {"count", count},
                                 {"type", shape}});
    return json["accessors"].size() - 1;
}

std::size_t GltfWriter::positions(const std::vector<osg::Vec3d>& places) {
    std::string bytes;
    osg::Vec3d least = places.front(), most = least;
    for (const auto& place : places) {
        for (int axis = 0; axis < 3; ++axis) {
            bytes += raw(static_cast<float>(place[axis]));
            least[axis] = std::min(least[axis], place[axis]);
            most[axis] = std::max(most[axis], place[axis]);
        }
    }
    const std::size_t made = accessor(bytes, 5126, "VEC3", places.size());
    json["accessors"][made]["min"] = {least.x(), least.y(), least.z()};
    json["accessors"][made]["max"] = {most.x(), most.y(), most.z()};
    return made;
}

std::size_t GltfWriter::indices(const std::vector<unsigned int>& numbers, int bytes) {
    std::string packed;
    for (const unsigned int each : numbers) {
        packed += raw(each).substr(0, static_cast<std::size_t>(bytes));
    }
    return accessor(packed, bytes == 1 ? 5121 : bytes == 2 ? 5123 : 5125, "SCALAR", numbers.size());
}

std::size_t GltfWriter::mesh(const std::string& name, nlohmann::json primitive) {
    json["meshes"].push_back({{"name", name}, {"primitives", {std::move(primitive)}}});
    return json["meshes"].size() - 1;
}

std::size_t GltfWriter::node(nlohmann::json node, int below) {
    json["nodes"].push_back(std::move(node));
    const std::size_t made = json["nodes"].size() - 1;
    if (below < 0) {
        json["scenes"][0]["nodes"].push_back(made);
    } else {
        json["nodes"][static_cast<std::size_t>(below)]["children"].push_back(made);
    }
    return made;
}

std::size_t GltfWriter::material(nlohmann::json material) {
    json["materials"].push_back(std::move(material));
    return json["materials"].size() - 1;
}

std::string GltfWriter::text(const std::string& name) const {
    auto whole = json;
    whole["buffers"] = {
        {{"byteLength", buffer_.size()},
         {"uri", name.empty() ? "data:application/octet-stream;base64," + base64(buffer_) : name}}};
    return whole.dump(1);
}

std::string GltfWriter::binary() const {
    auto whole = json;
    whole["buffers"] = {{{"byteLength", buffer_.size()}}};
    std::string text = whole.dump(), chunk = buffer_;
    text.resize((text.size() + 3) / 4 * 4, ' ');
    chunk.resize((chunk.size() + 3) / 4 * 4, '\0');
    const auto size = [](std::size_t bytes) { return raw(static_cast<std::uint32_t>(bytes)); };
    return "glTF" + size(2) + size(28 + text.size() + chunk.size()) + size(text.size()) + "JSON" +
           text + size(chunk.size()) + std::string("BIN\0", 4) + chunk;
}

std::vector<osg::Vec3d> boxCorners(double x, double y, double z) {
    return {{0, 0, 0}, {x, 0, 0}, {x, y, 0}, {0, y, 0}, {0, 0, z}, {x, 0, z}, {x, y, z}, {0, y, z}};
}

const std::vector<unsigned int>& boxTriangles() {
    static const std::vector<unsigned int> triangles = {0, 2, 1, 0, 3, 2, 4, 5, 6, 4, 6, 7,
                                                        0, 1, 5, 0, 5, 4, 1, 2, 6, 1, 6, 5,
                                                        2, 3, 7, 2, 7, 6, 3, 0, 4, 3, 4, 7};
    return triangles;
}

GltfWriter smallAircraft() {
    GltfWriter gltf;
    const auto red =
        gltf.material({{"name", "red paint"},
                       {"doubleSided", true},
                       {"pbrMetallicRoughness", {{"baseColorFactor", {1.0, 0.25, 0.0, 1.0}}}}});
    const auto blue = gltf.material({{"name", "blue"}});
    const auto hull =
        gltf.mesh("hull mesh", {{"attributes", {{"POSITION", gltf.positions(boxCorners(1, 2, 3))}}},
                                {"indices", gltf.indices(boxTriangles())},
                                {"material", red}});
    const auto engine = gltf.mesh(
        "engine mesh", {{"attributes", {{"POSITION", gltf.positions(boxCorners(1, 1, 1))}}},
                        {"indices", gltf.indices(boxTriangles(), 4)},
                        {"material", blue}});
    gltf.node({{"name", "hull"}, {"mesh", hull}});
    const auto wing = gltf.node({{"name", "wing"},
                                 {"rotation", {0.0, 0.0, 0.70710678118654752, 0.70710678118654752}},
                                 {"translation", {0.0, 10.0, 0.0}}});
    const int below = static_cast<int>(wing);
    gltf.node({{"name", "engine 1"}, {"mesh", engine}, {"translation", {5.0, 0.0, 0.0}}}, below);
    gltf.node({{"name", "engine 2"}, {"mesh", engine}, {"translation", {-5.0, 0.0, 0.0}}}, below);
    return gltf;
}

namespace {

FbxRecord property(const std::string& name, const std::string& type, const std::string& label,
                   std::vector<FbxRecord::Value> values) {
    FbxRecord made{"P", {name, type, label, std::string("A")}, {}};
    made.values.insert(made.values.end(), values.begin(), values.end());
    return made;
}

std::string asText(const FbxRecord& record, const std::string& indent) {
    std::string text = indent + record.name + ":";
    const char* comma = " ";
    for (const auto& value : record.values) {
        text += comma;
        comma = ", ";
        if (const auto* a = std::get_if<std::int32_t>(&value)) {
            text += std::to_string(*a);
        } else if (const auto* b = std::get_if<std::int64_t>(&value)) {
            text += std::to_string(*b);
        } else if (const auto* c = std::get_if<double>(&value)) {
            text += number(*c);
        } else if (const auto* d = std::get_if<std::string>(&value)) {
            text += "\"" + *d + "\"";
        } else {
            std::string list;
            std::size_t count = 0;
            std::visit(
                [&](const auto& values) {
                    if constexpr (requires { values.begin(); }) {
                        if constexpr (!std::is_same_v<std::decay_t<decltype(values)>,
                                                      std::string>) {
                            count = values.size();
                            for (const auto each : values) {
                                list +=
                                    (list.empty() ? "" : ",") + number(static_cast<double>(each));
                            }
                        }
                    }
                },
                value);
            return text + "*" + std::to_string(count) + " {\n" + indent + "\ta: " + list + "\n" +
                   indent + "}\n";
        }
    }
    if (record.records.empty()) {
        return text + "\n";
    }
    text += " {\n";
    for (const auto& each : record.records) {
        text += asText(each, indent + "\t");
    }
    return text + indent + "}\n";
}

std::string asBytes(const FbxRecord& record, std::size_t offset) {
    std::string values;
    for (const auto& value : record.values) {
        const auto size = [](std::size_t count) { return raw(static_cast<std::uint32_t>(count)); };
        if (const auto* a = std::get_if<std::int32_t>(&value)) {
            values += "I" + raw(*a);
        } else if (const auto* b = std::get_if<std::int64_t>(&value)) {
            values += "L" + raw(*b);
        } else if (const auto* c = std::get_if<double>(&value)) {
            values += "D" + raw(*c);
        } else if (const auto* d = std::get_if<std::string>(&value)) {
            values += "S" + size(d->size()) + *d;
        } else if (const auto* e = std::get_if<std::vector<std::int32_t>>(&value)) {
            values += "i" + size(e->size()) + size(0) + size(4 * e->size());
            for (const auto each : *e) {
                values += raw(each);
            }
        } else if (const auto* f = std::get_if<std::vector<double>>(&value)) {
            values += "d" + size(f->size()) + size(0) + size(8 * f->size());
            for (const auto each : *f) {
                values += raw(each);
            }
        }
    }
    const std::size_t begin = offset + 13 + record.name.size() + values.size();
    std::string below;
    for (const auto& each : record.records) {
        below += asBytes(each, begin + below.size());
    }
    if (!record.records.empty()) {
        below += std::string(13, '\0');
    }
    const auto word = [](std::size_t n) { return raw(static_cast<std::uint32_t>(n)); };
    return word(begin + below.size()) + word(record.values.size()) + word(values.size()) +
           static_cast<char>(record.name.size()) + record.name + values + below;
}

} // namespace

std::vector<FbxRecord> FbxWriter::records(bool binary) const {
    const auto named = [&](const std::string& kind, const std::string& name) {
        return binary ? name + std::string("\0\1", 2) + kind : kind + "::" + name;
    };
    const auto id = [](std::int64_t number) { return FbxRecord::Value(number); };
    std::vector<double> places;
    for (const auto& corner : corners) {
        places.insert(places.end(), {corner.x(), corner.y(), corner.z()});
    }
    std::vector<std::int32_t> indices;
    for (const auto& polygon : polygons) {
        indices.insert(indices.end(), polygon.begin(), polygon.end());
        indices.back() = -indices.back() - 1;
    }
    const FbxRecord settings{"GlobalSettings",
                             {},
                             {{"Version", {1000}, {}},
                              {"Properties70",
                               {},
                               {property("UpAxis", "int", "Integer", {upAxis}),
                                property("UpAxisSign", "int", "Integer", {upSign}),
                                property("FrontAxis", "int", "Integer", {2}),
                                property("FrontAxisSign", "int", "Integer", {1}),
                                property("CoordAxis", "int", "Integer", {0}),
                                property("CoordAxisSign", "int", "Integer", {1}),
                                property("UnitScaleFactor", "double", "Number", {unit_cm})}}}};
    const FbxRecord geometry{
        "Geometry",
        {id(100), named("Geometry", "hull mesh"), std::string("Mesh")},
        {{"Vertices", {places}, {}},
         {"PolygonVertexIndex", {indices}, {}},
         {"GeometryVersion", {124}, {}},
         {"LayerElementMaterial",
          {0},
          {{"Version", {101}, {}},
           {"Name", {std::string()}, {}},
           {"MappingInformationType", {std::string("AllSame")}, {}},
           {"ReferenceInformationType", {std::string("IndexToDirect")}, {}},
           {"Materials", {std::vector<std::int32_t>{0}}, {}}}},
         {"Layer",
          {0},
          {{"Version", {100}, {}},
           {"LayerElement",
            {},
            {{"Type", {std::string("LayerElementMaterial")}, {}}, {"TypedIndex", {0}, {}}}}}}}};
    const FbxRecord model{"Model",
                          {id(200), named("Model", "hull"), std::string("Mesh")},
                          {{"Version", {232}, {}},
                           {"Properties70",
                            {},
                            {property("Lcl Translation", "Lcl Translation", "",
                                      {translation.x(), translation.y(), translation.z()})}}}};
    const FbxRecord material{
        "Material",
        {id(300), named("Material", "red paint"), std::string()},
        {{"Version", {102}, {}},
         {"ShadingModel", {std::string("phong")}, {}},
         {"Properties70", {}, {property("DiffuseColor", "Color", "", {1.0, 0.25, 0.0})}}}};
    const auto join = [&](std::int64_t child, std::int64_t parent) {
        return FbxRecord{"C", {std::string("OO"), id(child), id(parent)}, {}};
    };
    return {
        {"FBXHeaderExtension", {}, {{"FBXHeaderVersion", {1003}, {}}, {"FBXVersion", {7400}, {}}}},
        settings,
        {"Definitions", {}, {{"Version", {100}, {}}, {"Count", {3}, {}}}},
        {"Objects", {}, {geometry, model, material}},
        {"Connections", {}, {join(200, 0), join(100, 200), join(300, 200)}}};
}

std::string FbxWriter::text() const {
    std::string text = "; FBX 7.4.0 project file\n";
    for (const auto& record : records(false)) {
        text += asText(record, "");
    }
    return text;
}

std::string FbxWriter::binary() const {
    std::string bytes("Kaydara FBX Binary  \0\x1a\0", 23);
    bytes += raw(std::uint32_t{7400});
    for (const auto& record : records(true)) {
        bytes += asBytes(record, bytes.size());
    }
    return bytes + std::string(13 + 160, '\0');
}

std::string ColladaWriter::text() const {
    std::string places, counts, indices;
    for (const auto& corner : corners) {
        for (int axis = 0; axis < 3; ++axis) {
            places += number(corner[axis]) + " ";
        }
    }
    for (const auto& polygon : polygons) {
        counts += std::to_string(polygon.size()) + " ";
        for (const auto index : polygon) {
            indices += std::to_string(index) + " ";
        }
    }
    const auto length = [](std::size_t count) { return std::to_string(count); };
    std::string nodes;
    for (int i = 0; i < copies; ++i) {
        nodes +=
            "<node id=\"n" + std::to_string(i) + "\" name=\"hull " + std::to_string(i) +
            "\"><translate>" + std::to_string(10 * i) +
            " 0 0</translate><instance_geometry url=\"#mesh\"><bind_material><technique_common>"
            "<instance_material symbol=\"paint\" target=\"#red\"/></technique_common>"
            "</bind_material></instance_geometry></node>\n";
    }
    return "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n"
           "<COLLADA xmlns=\"http://www.collada.org/2005/11/COLLADASchema\" version=\"1.4.1\">\n"
           "<asset>" +
           unit + up +
           "</asset>\n<library_effects><effect id=\"red-fx\"><profile_COMMON><technique "
           "sid=\"common\"><lambert><diffuse><color>1 0.25 0 1</color></diffuse></lambert>"
           "</technique></profile_COMMON></effect></library_effects>\n"
           "<library_materials><material id=\"red\" name=\"red paint\"><instance_effect "
           "url=\"#red-fx\"/></material></library_materials>\n"
           "<library_geometries><geometry id=\"mesh\" name=\"hull mesh\"><mesh>\n"
           "<source id=\"places\"><float_array id=\"numbers\" count=\"" +
           length(3 * corners.size()) + "\">" + places +
           "</float_array><technique_common><accessor source=\"#numbers\" count=\"" +
           length(corners.size()) +
           "\" stride=\"3\"><param name=\"X\" type=\"float\"/><param name=\"Y\" type=\"float\"/>"
           "<param name=\"Z\" type=\"float\"/></accessor></technique_common></source>\n"
           "<vertices id=\"vertices\"><input semantic=\"POSITION\" "
           "source=\"#places\"/></vertices>\n"
           "<polylist material=\"paint\" count=\"" +
           length(polygons.size()) +
           "\"><input semantic=\"VERTEX\" source=\"#vertices\" offset=\"0\"/><vcount>" + counts +
           "</vcount><p>" + indices +
           "</p></polylist></mesh></geometry></library_geometries>\n"
           "<library_visual_scenes><visual_scene id=\"scene\">\n" +
           nodes +
           "</visual_scene></library_visual_scenes>\n"
           "<scene><instance_visual_scene url=\"#scene\"/></scene>\n</COLLADA>\n";
}

std::vector<osg::Vec3d> cornersOfL() {
    return {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}};
}

} // namespace irsg::test
