#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <pugixml.hpp>

#include "irsg/core/CsvTable.h"
#include "irsg/core/Errors.h"
#include "irsg/geometry/reading/sandbox/DeclaredContents.h"
#include "irsg/geometry/reading/text/ModelText.h"

namespace irsg {

namespace {

namespace fs = std::filesystem;
using XmlNode = pugi::xml_node;

constexpr int mostXmlLevels = 500;
constexpr double mostPolygons = 1e9;

/// Calls each(word) with what stands between blanks.
template <typename Each>
void forEachWord(std::string_view text, const Each& each) {
    constexpr std::string_view blanks = " \t\r\n";
    for (auto at = text.find_first_not_of(blanks); at != text.npos;
         at = text.find_first_not_of(blanks, at)) {
        const auto end = std::min(text.find_first_of(blanks, at), text.size());
        each(text.substr(at, end - at));
        at = end;
    }
}

class ColladaText {
  public:
    explicit ColladaText(const fs::path& file) : file_(file) {}

    DeclaredContents read(const std::string& text) {
        pugi::xml_document document;
        // Blanks around words and lists mean nothing in the format.
        const auto result = document.load_buffer(text.data(), text.size(),
                                                 pugi::parse_default | pugi::parse_trim_pcdata |
                                                     pugi::parse_wnorm_attribute);
        if (!result)
            refuse(lineOf(text, result.offset), result.description(), "a whole file of COLLADA");
        const XmlNode root = document.document_element();
        if (std::string_view(root.name()) != "COLLADA")
            refuse("", "\"" + std::string(root.name()) + "\"", "COLLADA");
        learn(root, 0);
        for (const XmlNode& library : root.children("library_geometries"))
            for (const XmlNode& geometry : library.children("geometry"))
                unfoldFans(geometry.child("mesh"));
        DeclaredContents stated;
        stated.text = textOf(document);
        stated.axes = axesOf(root.child("asset"));
        const XmlNode scene = referred(root.child("scene").child("instance_visual_scene"), "url");
        double polygons = 0.0;
        for (const XmlNode& node : scene.children("node"))
            polygons += placed(node, 0);
        stated.placedPolygons = polygons;
        for (const XmlNode& library : root.children("library_geometries"))
            for (const XmlNode& geometry : library.children("geometry"))
                if (!nodes_.contains(geometry.child("mesh")))
                    stated.remarks.push_back("geometry " +
                                             std::string(geometry.attribute("id").value()) +
                                             " is placed nowhere");
        remarkOthers(root, stated.remarks);
        return stated;
    }

  private:
    [[noreturn]] void refuse(std::string position, std::string value, std::string expected) const {
        throw InputError(
            {file_.string(), std::move(position), std::move(value), std::move(expected)});
    }
    static std::string lineOf(const std::string& text, std::ptrdiff_t offset) {
        const auto end = text.begin() + std::clamp<std::ptrdiff_t>(
                                            offset, 0, static_cast<std::ptrdiff_t>(text.size()));
        return "line " + std::to_string(1 + std::count(text.begin(), end, '\n'));
    }

    static std::string textOf(const pugi::xml_document& document) {
        struct Writer : pugi::xml_writer {
            std::string text;
            void write(const void* data, std::size_t size) override {
                text.append(static_cast<const char*>(data), size);
            }
        } writer;
        document.save(writer, "", pugi::format_raw, pugi::encoding_utf8);
        return std::move(writer.text);
    }

    /// A list that comments or sections of characters divide becomes one.
    static void joinTexts(XmlNode element) {
        XmlNode first = element.first_child();
        if (!first || first == element.last_child())
            return;
        std::string text;
        for (const XmlNode& child : element.children()) {
            if (child.type() != pugi::node_pcdata && child.type() != pugi::node_cdata)
                return;
            text += (text.empty() ? "" : " ") + std::string(child.value());
        }
        while (element.remove_child(element.first_child())) {
        }
        element.append_child(pugi::node_pcdata).set_value(text.c_str());
    }

    /// Fans become triangles: Assimp takes each for one polygon.
    static void unfoldFans(XmlNode mesh) {
        for (XmlNode list : mesh.children("trifans")) {
            const auto width = static_cast<std::size_t>(stride(list));
            std::string text;
            std::size_t triangles = 0;
            for (const XmlNode& fan : list.children("p")) {
                std::vector<std::string_view> words;
                forEachWord(fan.child_value(),
                            [&](std::string_view word) { words.push_back(word); });
                for (std::size_t last = 2; (last + 1) * width <= words.size(); ++last, ++triangles)
                    for (const std::size_t corner : {std::size_t{0}, last - 1, last})
                        for (std::size_t i = 0; i < width; ++i)
                            text += std::string(words[corner * width + i]) + " ";
            }
            while (list.remove_child("p")) {
            }
            list.append_child("p").append_child(pugi::node_pcdata).set_value(text.c_str());
            list.set_name("triangles");
            list.remove_attribute("count");
            list.append_attribute("count").set_value(std::to_string(triangles).c_str());
        }
    }

    void learn(const XmlNode& element, int level) {
        if (level > mostXmlLevels)
            refuse("", "elements in " + std::to_string(mostXmlLevels) + " others", "fewer levels");
        joinTexts(element);
        if (const auto id = element.attribute("id"))
            elements_.emplace(id.value(), element);
        for (const XmlNode& child : element.children())
            learn(child, level + 1);
    }

    FileAxes axesOf(const XmlNode& asset) const {
        FileAxes axes;
        std::string said;
        const XmlNode unit = asset.child("unit");
        if (const auto length = parseNumber(unit.attribute("meter").value());
            length && *length > 0.0) {
            axes.unit_m = *length;
            said = "a unit of " + numberText(*length) + " m";
        }
        const std::string_view up = asset.child_value("up_axis");
        for (const auto& [name, axis] : {std::pair{"X_UP", ModelAxis::plusX},
                                         {"Y_UP", ModelAxis::plusY},
                                         {"Z_UP", ModelAxis::plusZ}})
            if (up == name) {
                axes.up = axis;
                said += (said.empty() ? "" : ", ") + std::string(name);
            }
        if (!said.empty())
            axes.reason = "the file's asset: " + said;
        return axes;
    }

    /// What a "#id" leads to; nothing where there is no such reference.
    XmlNode referred(const XmlNode& element, const char* key) const {
        std::string_view name = element.attribute(key).value();
        if (name.empty())
            return {};
        if (!name.starts_with('#'))
            refuse(element.name(), "a reference to another file, " + std::string(name),
                   "a reference within the file");
        const auto found = elements_.find(std::string(name.substr(1)));
        if (found == elements_.end())
            refuse(element.name(), "a reference to " + std::string(name) + ", which is missing",
                   "what the file has");
        return found->second;
    }

    /// What libraries have that no surface comes of, or that would change some.
    static void remarkOthers(const XmlNode& root, std::vector<std::string>& remarks) {
        const auto say = [&](std::ptrdiff_t count, const char* name, const char* what) {
            if (count > 0)
                remarks.push_back(std::to_string(count) + " " + name + " " + what);
        };
        for (const auto& [name, what] :
             {std::pair{"animation", "are not played: parts are where the scene puts them"},
              {"controller", "are not followed: skins and morphs have the shape of their mesh"},
              {"camera", "are left out"},
              {"light", "are left out"},
              {"force_field", "are left out"},
              {"physics_scene", "are left out: parts are where the scene puts them"},
              {"kinematics_model", "are left out: parts are where the scene puts them"},
              {"articulated_system", "are left out: parts are where the scene puts them"}}) {
            std::ptrdiff_t count = 0;
            for (const XmlNode& library : root.children()) {
                const auto own = library.children(name);
                count += std::distance(own.begin(), own.end());
            }
            say(count, name, what);
        }
        for (const char* kind : {"spline", "convex_mesh", "brep"}) {
            std::ptrdiff_t count = 0;
            for (const XmlNode& library : root.children("library_geometries"))
                for (const XmlNode& geometry : library.children("geometry"))
                    count += geometry.child(kind) ? 1 : 0;
            say(count, kind, "have no polygons and are left out");
        }
    }

    double placed(const XmlNode& node, int level) {
        if (level > mostXmlLevels)
            refuse(node.attribute("id").value(), "nodes in a circle, or in too many levels",
                   "nodes in a tree");
        if (const auto known = nodes_.find(node); known != nodes_.end())
            return known->second;
        double sum = 0.0;
        for (const XmlNode& child : node.children()) {
            const std::string_view kind = child.name();
            if (kind == "skew")
                refuse(node.attribute("id").value(), "a transformation by skew",
                       "translate, rotate, scale, matrix or lookat");
            if (kind == "node")
                sum += placed(child, level + 1);
            else if (kind == "instance_node")
                sum += placed(referred(child, "url"), level + 1);
            else if (kind == "instance_geometry")
                sum += polygonsOf(referred(child, "url"));
            else if (kind == "instance_controller")
                sum += polygonsOf(skinned(referred(child, "url")));
            if (sum > mostPolygons)
                refuse(node.attribute("id").value(), "copies of more than 1e9 polygons", "fewer");
        }
        nodes_.emplace(node, sum);
        return sum;
    }

    XmlNode skinned(const XmlNode& controller) const {
        const XmlNode skin = controller.child("skin");
        return referred(skin ? skin : controller.child("morph"), "source");
    }

    double polygonsOf(const XmlNode& geometry) {
        const XmlNode mesh = geometry.child("mesh");
        if (const auto known = nodes_.find(mesh); known != nodes_.end())
            return known->second;
        double sum = 0.0;
        for (const XmlNode& list : mesh.children()) {
            const std::string_view kind = list.name();
            const std::string where =
                geometry.attribute("id").value() + std::string(", ") + list.name();
            const double count = list.attribute("count").as_double();
            if (kind == "triangles" || kind == "polylist") {
                sum += polygonsOf(list, kind == "triangles", count, where);
            } else if (kind == "polygons") {
                double found = 0.0;
                if (list.child("ph"))
                    refuse(where, "polygons with holes (ph)", "polygons without holes");
                for (const XmlNode& each : list.children())
                    found += each.name() == std::string_view("p");
                if (found < count)
                    refuse(where, numberText(found) + " polygons", numberText(count));
                sum += found;
            } else if (kind == "tristrips") {
                for (const XmlNode& each : list.children("p"))
                    sum += std::max(0.0, indices(each) / stride(list) - 2.0);
            }
        }
        nodes_.emplace(mesh, sum);
        return sum;
    }

    static double indices(const XmlNode& p) {
        double count = 0.0;
        forEachWord(p.child_value(), [&](std::string_view) { ++count; });
        return count;
    }
    static double stride(const XmlNode& list) {
        double most = 0.0;
        for (const XmlNode& input : list.children("input"))
            most = std::max(most, input.attribute("offset").as_double());
        return most + 1.0;
    }

    /// Those of three corners or more; their corners must be there.
    double polygonsOf(const XmlNode& list, bool triangles, double count, const std::string& where) {
        double polygons = count, corners = 3.0 * count;
        if (!triangles) {
            double lengths = 0.0;
            polygons = corners = 0.0;
            forEachWord(list.child_value("vcount"), [&](std::string_view word) {
                const double length = parseNumber(word).value_or(0.0);
                ++lengths;
                corners += length;
                polygons += length >= 3.0;
            });
            if (lengths < count)
                refuse(where, numberText(lengths) + " numbers of corners", numberText(count));
        }
        const double there = indices(list.child("p")) / stride(list);
        if (there != corners)
            refuse(where, numberText(there) + " corners of polygons", numberText(corners));
        return polygons;
    }

    const fs::path& file_;
    std::map<std::string, XmlNode> elements_;
    std::map<XmlNode, double> nodes_; ///< polygons of nodes and meshes that were counted
};

} // namespace

DeclaredContents readColladaFile(const fs::path& place, const fs::path& file) {
    return ColladaText(file).read(readModelBytes(place, file));
}

} // namespace irsg
