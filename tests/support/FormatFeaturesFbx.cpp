#include "tests/support/FormatFeatures.h"

#include "tests/support/ForeignModels.h"

namespace irsg::test {

namespace {

std::string plate(bool isBinary = false) {
    FbxWriter writer;
    writer.unit_cm = 100.0;
    writer.corners = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}};
    writer.polygons = {{0, 1, 2, 3}};
    return isBinary ? writer.binary() : writer.text();
}
/// With a property of the model.
std::string modelWith(const std::string& property) {
    return with(plate(), "\t\t\tP: \"Lcl Translation\"", property + "\t\t\tP: \"Lcl Translation\"");
}
std::string vectorOf(const std::string& name, const std::string& type, const std::string& values) {
    return "\t\t\tP: \"" + name + "\", \"" + type + "\", \"\", \"A\"," + values + "\n";
}
/// With an object more, joined to the mesh or its model.
std::string plateWith(const std::string& object, int parent = 100) {
    return with(with(plate(), "\tMaterial: 300", object + "\tMaterial: 300"), "\tC: \"OO\", 200, 0",
                "\tC: \"OO\", 900, " + std::to_string(parent) + "\n\tC: \"OO\", 200, 0");
}
std::string layerElement(const std::string& name, const std::string& more) {
    return withBehind(plate(), "\t\tGeometryVersion: 124\n",
                      "\t\t" + name + ": 0 {\n\t\t\tVersion: 101\n\t\t\tName: \"\"\n" + more +
                          "\t\t}\n");
}

} // namespace

std::vector<FormatFeature> fbxFeatures() {
    std::vector<FormatFeature> all;
    const auto add = [&](const std::string& feature, std::string text, Outcome outcome,
                         const std::string& says = "", double area_m2 = 2.0,
                         double diagonal_m = 2.23606797749978969641) {
        all.push_back({"FBX 7 (.fbx)", feature, "a.fbx", std::move(text), outcome, says, area_m2,
                       diagonal_m});
    };
    using enum Outcome;
    add("as text", plate(), followed);
    add("as binary, versions 7.1 to 7.7", plate(true), followed);
    {
        std::string old = plate(true);
        old[23] = static_cast<char>(6100 % 256);
        old[24] = static_cast<char>(6100 / 256);
        add("other versions", old, refused, "version 6100");
    }
    add("`UnitScaleFactor`", with(plate(), "\"Number\", \"A\", 100", "\"Number\", \"A\", 200"),
        followed, "", 8.0, 4.47213595499957939282);
    add("`UpAxis` and its sign",
        with(plate(), "\"UpAxis\", \"int\", \"Integer\", \"A\", 1",
             "\"UpAxis\", \"int\", \"Integer\", \"A\", 2"),
        followed);
    add("polygons of any number of corners", plate(), followed);
    add("normals, smoothing groups",
        layerElement("LayerElementSmoothing",
                     "\t\t\tMappingInformationType: \"ByPolygon\"\n\t\t\tReferenceInformationType: "
                     "\"Direct\"\n\t\t\tSmoothing: *1 {\n\t\t\t\ta: 1\n\t\t\t}\n"),
        followed);
    add("texture coordinates, colours of vertices",
        layerElement("LayerElementColor",
                     "\t\t\tMappingInformationType: \"ByPolygonVertex\"\n"
                     "\t\t\tReferenceInformationType: \"Direct\"\n\t\t\tColors: *16 {\n\t\t\t\ta: "
                     "1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1\n\t\t\t}\n"),
        looksOnly);
    add("holes and hidden polygons (`LayerElementHole`, `LayerElementVisibility`)",
        layerElement("LayerElementHole",
                     "\t\t\tMappingInformationType: \"ByPolygon\"\n\t\t\tReferenceInformationType: "
                     "\"Direct\"\n\t\t\tHole: *1 {\n\t\t\t\ta: 1\n\t\t\t}\n"),
        remarked, "LayerElementHole");
    add("subdivision, creases (`PreviewDivisionLevels`, `LayerElementEdgeCrease`)",
        layerElement("LayerElementEdgeCrease",
                     "\t\t\tMappingInformationType: \"ByEdge\"\n\t\t\tReferenceInformationType: "
                     "\"Direct\"\n"),
        remarked, "LayerElementEdgeCrease");
    add("`Lcl Translation`, `Rotation`, `Scaling`",
        modelWith(vectorOf("Lcl Scaling", "Lcl Scaling", "2,1,1")), followed, "", 4.0,
        4.12310562561766055);
    add("rotation orders, pre- and post-rotation, pivots",
        modelWith(vectorOf("PreRotation", "Vector3D", "0,0,45") +
                  vectorOf("RotationActive", "bool", "1")),
        followed, "", 2.0, 3.0);
    add("geometric transformations", modelWith(vectorOf("GeometricScaling", "Vector3D", "2,1,1")),
        followed, "", 4.0, 4.12310562561766055);
    add("`Visibility` and `Show` of a model", modelWith(vectorOf("Visibility", "Visibility", "0")),
        remarked, "Visibility");
    add("skins and shapes (`Deformer`)",
        plateWith("\tDeformer: 900, \"Deformer::skin\", \"Skin\" {\n\t\tVersion: 101\n\t}\n"),
        remarked, "Deformer");
    add("animations",
        with(plate(), "\tMaterial: 300",
             "\tAnimationCurve: 900, \"AnimCurve::x\", \"\" {\n\t}\n\tMaterial: 300"),
        remarked, "AnimationCurve");
    add("curves, NURBS and patches",
        plateWith("\tGeometry: 900, \"Geometry::curve\", \"NurbsSurface\" {\n\t}\n", 200), remarked,
        "NurbsSurface");
    add("cameras and lights",
        plateWith("\tNodeAttribute: 900, \"NodeAttribute::sun\", \"Light\" {\n\t\tTypeFlags: "
                  "\"Light\"\n\t}\n",
                  200),
        remarked, "Light");
    add("constraints", plateWith("\tConstraint: 900, \"Constraint::aim\", \"Aim\" {\n\t}\n", 0),
        remarked, "Constraint");
    add("phong and lambert materials", plate(), looksOnly);
    return all;
}

} // namespace irsg::test
