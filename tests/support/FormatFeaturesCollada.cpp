#include "tests/support/FormatFeatures.h"

#include "tests/support/ForeignModels.h"

namespace irsg::test {

namespace {

std::string plate() {
    ColladaWriter writer;
    writer.unit = "<unit name=\"metre\" meter=\"1\"/>";
    writer.corners = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}};
    writer.polygons = {{0, 1, 2, 3}};
    return writer.text();
}
/// In place of the list of polygons.
std::string plateOf(const std::string& list) {
    std::string text = plate();
    const std::size_t begin = text.find("<polylist"), end = text.find("</mesh>");
    return text.replace(begin, end - begin, list);
}
const std::string input = "<input semantic=\"VERTEX\" source=\"#vertices\" offset=\"0\"/>";
/// A library before that of scenes.
std::string plateWith(const std::string& library) {
    return with(plate(), "<library_visual_scenes>", library + "<library_visual_scenes>");
}
/// In the node, before its mesh.
std::string placedBy(const std::string& transformation) {
    return with(plate(), "<translate>0 0 0</translate>", transformation);
}

/// By one bone, which moves nothing.
std::string skinned() {
    const auto source = [](const std::string& id, const std::string& array,
                           const std::string& content, const std::string& stride,
                           const std::string& type) {
        const std::string count = array == "Name_array" ? "1" : stride;
        return "<source id=\"" + id + "\"><" + array + " id=\"" + id + "-a\" count=\"" + count +
               "\">" + content + "</" + array + "><technique_common><accessor source=\"#" + id +
               "-a\" count=\"1\" stride=\"" + stride + "\"><param name=\"A\" type=\"" + type +
               "\"/></accessor></technique_common></source>";
    };
    const std::string unit = "1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1";
    const std::string skin =
        "<library_controllers><controller id=\"skinned\"><skin source=\"#mesh\">"
        "<bind_shape_matrix>" +
        unit + "</bind_shape_matrix>" + source("js", "Name_array", "bone", "1", "name") +
        source("bs", "float_array", unit, "16", "float4x4") +
        source("ws", "float_array", "1", "1", "float") +
        "<joints><input semantic=\"JOINT\" source=\"#js\"/><input semantic=\"INV_BIND_MATRIX\" "
        "source=\"#bs\"/></joints><vertex_weights count=\"4\"><input semantic=\"JOINT\" "
        "source=\"#js\" offset=\"0\"/><input semantic=\"WEIGHT\" source=\"#ws\" offset=\"1\"/>"
        "<vcount>1 1 1 1</vcount><v>0 0 0 0 0 0 0 0</v></vertex_weights></skin></controller>"
        "</library_controllers>";
    return with(with(plateWith(skin), "<instance_geometry url=\"#mesh\">",
                     "<instance_controller url=\"#skinned\">"),
                "</instance_geometry>", "</instance_controller>");
}

} // namespace

std::vector<FormatFeature> colladaFeatures() {
    std::vector<FormatFeature> all;
    const auto add = [&](const std::string& feature, std::string text, Outcome outcome,
                         const std::string& says = "", double area_m2 = 2.0,
                         double diagonal_m = 2.23606797749978969641) {
        all.push_back({"COLLADA 1.4 (.dae)", feature, "a.dae", std::move(text), outcome, says,
                       area_m2, diagonal_m});
    };
    using enum Outcome;
    add("`unit` and `up_axis` of the asset", with(plate(), "meter=\"1\"", "meter=\"2\""), followed,
        "", 8.0, 4.47213595499957939282);
    add("polylists", plate(), followed);
    add("triangles", plateOf("<triangles count=\"2\">" + input + "<p>0 1 2 0 2 3</p></triangles>"),
        followed);
    add("polygons", plateOf("<polygons count=\"1\">" + input + "<p>0 1 2 3</p></polygons>"),
        followed);
    add("polygons with holes (`ph`)",
        plateOf("<polygons count=\"1\">" + input +
                "<ph><p>0 1 2 3</p><h>0 1 2</h></ph></polygons>"),
        refused, "holes");
    add("tristrips", plateOf("<tristrips count=\"1\">" + input + "<p>0 1 3 2</p></tristrips>"),
        followed);
    add("trifans", plateOf("<trifans count=\"1\">" + input + "<p>0 1 2 3</p></trifans>"), followed);
    add("lines and linestrips",
        withBehind(plate(), "</polylist>", "<lines count=\"1\">" + input + "<p>0 1</p></lines>"),
        remarked, "lines and points have no area");
    add("`spline`",
        withBehind(plate(), "<library_geometries>",
                   "<geometry id=\"curve\"><spline closed=\"0\"><source id=\"cp\"/></spline>"
                   "</geometry>"),
        remarked, "spline");
    add("`convex_mesh`",
        withBehind(plate(), "<library_geometries>",
                   "<geometry id=\"hull\"><convex_mesh convex_hull_of=\"#mesh\"/></geometry>"),
        remarked, "convex_mesh");
    add("`translate`",
        with(plate(), "</node>",
             "</node><node><translate>5 0 0</translate><instance_geometry "
             "url=\"#mesh\"/></node>"),
        followed, "", 4.0, 7.07106781186547524);
    add("`rotate`", placedBy("<rotate>0 0 1 45</rotate>"), followed, "", 2.0, 3.0);
    add("`scale`", placedBy("<scale>2 1 1</scale>"), followed, "", 4.0, 4.12310562561766055);
    add("`matrix`", placedBy("<matrix>2 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1</matrix>"), followed, "", 4.0,
        4.12310562561766055);
    add("`lookat`", placedBy("<lookat>0 0 0 0 0 1 1 1 0</lookat>"), followed, "", 2.0, 3.0);
    add("`skew`", placedBy("<skew>45 1 0 0 0 1 0</skew>"), refused, "skew");
    add("`instance_node`, nodes of a library",
        with(plateWith("<library_nodes><node id=\"part\"><instance_geometry url=\"#mesh\"/></node>"
                       "</library_nodes>"),
             "<instance_geometry url=\"#mesh\"><bind_material>",
             "<instance_node url=\"#part\"/><instance_geometry url=\"#mesh\"><bind_material>"),
        followed, "", 4.0);
    add("references to other files",
        with(plate(), "<instance_geometry url=\"#mesh\">",
             "<instance_node url=\"b.dae#part\"/><instance_geometry url=\"#mesh\">"),
        refused, "a reference to another file");
    add("skins", skinned(), remarked, "1 controller are not followed");
    add("morphs",
        with(with(plateWith("<library_controllers><controller id=\"shaped\"><morph "
                            "source=\"#mesh\"><targets/></morph></controller>"
                            "</library_controllers>"),
                  "<instance_geometry url=\"#mesh\">", "<instance_controller url=\"#shaped\">"),
             "</instance_geometry>", "</instance_controller>"),
        refused, "1 controller are not followed");
    add("animations", plateWith("<library_animations><animation id=\"a\"/></library_animations>"),
        remarked, "animation");
    add("cameras",
        plateWith("<library_cameras><camera id=\"c\"><optics><technique_common><perspective>"
                  "<xfov>40</xfov><znear>1</znear><zfar>9</zfar></perspective></technique_common>"
                  "</optics></camera></library_cameras>"),
        remarked, "camera");
    add("lights",
        plateWith("<library_lights><light id=\"l\"><technique_common><ambient><color>1 1 1"
                  "</color></ambient></technique_common></light></library_lights>"),
        remarked, "light");
    add("physics",
        plateWith("<library_physics_scenes><physics_scene id=\"p\"/></library_physics_scenes>"),
        remarked, "physics_scene");
    add("kinematics (1.5)",
        plateWith("<library_kinematics_models><kinematics_model id=\"k\"/>"
                  "</library_kinematics_models>"),
        remarked, "kinematics_model");
    add("`lambert`, `phong`, `blinn`, `constant` of `profile_COMMON`", plate(), looksOnly);
    add("other profiles of effects",
        with(plate(), "</profile_COMMON>", "</profile_COMMON><profile_GLSL/>"), looksOnly);
    add("`extra`", withBehind(plate(), "</polylist>", "<extra><technique profile=\"X\"/></extra>"),
        looksOnly);
    add("no scene", with(plate(), "<scene><instance_visual_scene url=\"#scene\"/></scene>", ""),
        refused, "File came out empty");
    return all;
}

} // namespace irsg::test
