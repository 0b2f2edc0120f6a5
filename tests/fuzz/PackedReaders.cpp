#include <cstring>
#include <fstream>

#include <osg/Geode>
#include <osg/Geometry>
#include <osg/LOD>
#include <osg/MatrixTransform>
#include <osg/Switch>
#include <osgSim/DOFTransform>
#include <osgSim/MultiSwitch>
#include <unistd.h>
#include <zlib.h>

#include "irsg/atmosphere/engine/GasTable.h"
#include "irsg/atmosphere/engine/Profile.h"
#include "irsg/core/Errors.h"
#include "irsg/core/FileReading.h"
#include "irsg/gas/NarrowBandTable.h"
#include "irsg/gas/PlumePoints.h"
#include "irsg/gas/PlumeTable.h"
#include "irsg/geometry/model/Model.h"
#include "irsg/geometry/reading/IrCodes.h"
#include "irsg/geometry/reading/ModelCodes.h"
#include "irsg/geometry/reading/sandbox/AxesCoding.h"
#include "irsg/geometry/reading/sandbox/CompletenessCheck.h"
#include "irsg/geometry/reading/sandbox/DeclaredContents.h"
#include "irsg/geometry/reading/sandbox/GltfFile.h"
#include "irsg/geometry/reading/sandbox/GraphCoding.h"
#include "irsg/geometry/reading/sandbox/ReaderMessages.h"
#include "irsg/geometry/reading/text/ObjReader.h"
#include "irsg/scene/scattering/SceneScattering.h"
#include "tests/fuzz/Readers.h"
#include "tests/support/MadeGraphs.h"
#include "tools/atmosphere-tables/lines/LineListFile.h"

// Readers of binary files and messages, and of what other files name.

namespace smat::test {

namespace {

namespace fs = std::filesystem;
using File = const fs::path&;

/// What a file of two nodes and one gas is; without its checksum it is easily read.
std::string gasTableBytes() {
    const irsg::GasTable::Grid grid{
        {1100.0, 600.0, 300.0, 100.0, 30.0, 1.0}, {180.0, 220.0, 260.0, 300.0, 340.0}, 0.04, 4};
    const std::vector<float> block(30, -50.0f);
    const auto bins = [](double width_per_cm) {
        return irsg::BinSet{width_per_cm, {{1000.0, 1005.0, 0, 2}}, {0, 1}, {0.25f, 0.75f}};
    };
    const irsg::GasTable table(grid, {1001.0, 1004.0},
                               {{0, irsg::Gas::CO2, block}, {1, irsg::Gas::CO2, block}},
                               {bins(1.0), bins(5.0), bins(15.0)}, "a recipe");
    const fs::path file =
        fs::temp_directory_path() / ("smat-fuzz-gases-" + std::to_string(getpid()));
    table.write(file);
    const std::string bytes = irsg::readFile(file);
    fs::remove(file);
    return bytes;
}

/// A checksum would keep all that is made up from going any further.
void readGasTable(File file) {
    std::string bytes = irsg::readFile(file);
    if (bytes.size() >= 4) {
        const auto sum = static_cast<std::uint32_t>(
            crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size() - 4));
        std::memcpy(bytes.data() + bytes.size() - 4, &sum, sizeof sum);
        std::ofstream(file, std::ios::binary) << bytes;
    }
    irsg::GasTable::read(file);
}

/// What a reading process hands over of every kind of node.
std::string graphBytes() {
    osg::ref_ptr<osg::Geometry> square = new osg::Geometry;
    const osg::ref_ptr<osg::Vec3Array> vertices = new osg::Vec3Array(4);
    (*vertices)[1] = {1, 0, 0};
    (*vertices)[2] = {1, 1, 0};
    (*vertices)[3] = {0, 1, 0};
    square->setVertexArray(vertices);
    square->setNormalArray(new osg::Vec3Array(4), osg::Array::BIND_PER_VERTEX);
    square->addPrimitiveSet(new osg::DrawArrays(GL_QUADS, 0, 4));
    square->addPrimitiveSet(new osg::DrawElementsUShort(GL_TRIANGLES, 3));
    irsg::setCodes(*square, {1, 2});
    osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    geode->addDrawable(square);
    geode->getOrCreateStateSet()->setMode(GL_CULL_FACE, osg::StateAttribute::ON);
    osg::ref_ptr<osg::Group> root = new osg::Group;
    osg::ref_ptr<osg::MatrixTransform> moved = new osg::MatrixTransform;
    osg::ref_ptr<osgSim::DOFTransform> joint = new osgSim::DOFTransform;
    osg::ref_ptr<osgSim::MultiSwitch> sets = new osgSim::MultiSwitch;
    sets->setValue(0, 0, true);
    osg::ref_ptr<osg::Switch> choice = new osg::Switch;
    osg::ref_ptr<osg::LOD> lod = new osg::LOD;
    for (osg::Group* group : std::initializer_list<osg::Group*>{moved, joint, sets, choice, lod}) {
        group->addChild(geode);
        root->addChild(group);
    }
    lod->setRange(0, 0.0f, 100.0f);
    irsg::ByteSink sink;
    std::vector<std::string> remarks;
    irsg::putGraph(sink, *root, "a", remarks);
    return sink.take();
}

void readGraph(File file) {
    const std::string bytes = irsg::readFile(file);
    irsg::ByteSource source(bytes);
    std::vector<std::string> remarks;
    try {
        const auto graph = irsg::getGraph(source, "a", remarks);
        irsg::test::modelOfGraph(graph.get(), "a");
    } catch (const irsg::DamagedBytes&) {
        // Its own word for a message that is refused.
    }
}

void readRefusal(File file) {
    const std::string bytes = irsg::readFile(file);
    try {
        irsg::throwRefusal(bytes);
    } catch (const irsg::DamagedBytes&) {
    }
}

/// A library of materials, as an object names it.
void readMaterials(File file) {
    static const fs::path object = [&] {
        fs::path made = file.parent_path() / "b.obj";
        std::ofstream(made) << "mtllib " << file.filename().string()
                            << "\nv 0 0 0\nv 1 0 0\nv 1 1 0\nusemtl m\nf 1 2 3\n";
        return made;
    }();
    // Pictures are read in a process of their own.
    irsg::readObj(object, [](File) { return osg::ref_ptr<osg::Image>(new osg::Image); });
}

/// The looks at other programs' models before their plug-ins: the bytes as each kind of them.
void readWhole(File file) {
    for (const char* name : {"a.osg", "a.osgx", "a.3ds", "a.lwo", "a.ac"}) {
        try {
            irsg::checkCompleteness(file, name);
        } catch (const irsg::InputError&) {
        }
    }
}

std::string studioBytes() {
    using namespace std::string_literals;
    // A main piece of 12 bytes with the version in it.
    return "\x4d\x4d\x10\0\0\0\2\0\x0a\0\0\0\3\0\0\0"s;
}

void readAxes(File file) {
    const std::string bytes = irsg::readFile(file);
    irsg::ByteSource source(bytes);
    try {
        irsg::getAxes(source);
    } catch (const irsg::DamagedBytes&) {
    }
}

std::string axesBytes() {
    irsg::ByteSink sink;
    irsg::putAxes(sink, {0.01, irsg::ModelAxis::plusZ, irsg::ModelAxis::minusX, "a file"});
    return sink.take();
}

const char* const objectOfAc = "AC3Db\nOBJECT world\nkids 1\nOBJECT poly\nnumvert 3\n0 0 0\n"
                               "1 0 0\n0 1 0\nnumsurf 1\nSURF 0x0\nrefs 3\n0 0 0\n1 0 0\n"
                               "2 0 0\nkids 0\n";

/// A triangle, its corners in base64.
const std::string gltf =
    R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],
"nodes":[{"name":"a","mesh":0,"rotation":[0,0,0,1],"children":[1]},{"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]}],
"materials":[{"name":"m"}],
"meshes":[{"name":"t","primitives":[{"attributes":{"POSITION":0},"mode":4,"material":0}]}],
"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}],
"bufferViews":[{"buffer":0,"byteLength":36,"byteOffset":0}],
"buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,)" +
    std::string(48, 'A') + "\"}]}\n";

std::string glbBytes() {
    const auto word = [](std::size_t value) {
        const auto number = static_cast<std::uint32_t>(value);
        return std::string(reinterpret_cast<const char*>(&number), 4);
    };
    std::string text = gltf;
    text.replace(text.find(",\"uri\""), text.rfind("\"}]}") - text.find(",\"uri\"") + 1, "");
    text.resize((text.size() + 3) / 4 * 4, ' ');
    return "glTF" + word(2) + word(28 + text.size() + 36) + word(text.size()) + "JSON" + text +
           word(36) + std::string("BIN\0", 4) + std::string(36, '\0');
}

const char* const fbx =
    "; FBX 7.4.0\nGlobalSettings: {\n\tProperties70: {\n\t\tP: \"UpAxis\", \"int\", \"Integer\", "
    "\"\",1\n\t\tP: \"UnitScaleFactor\", \"double\", \"Number\", \"\",2.54\n\t}\n}\nObjects: {\n"
    "\tGeometry: 1, \"Geometry::a\", \"Mesh\" {\n\t\tPolygonVertexIndex: *3 {\n\t\t\ta: 0,1,-3\n"
    "\t\t}\n\t}\n}\nConnections: {\n}\n";

/// A record of settings in three levels, and the record of zeros that ends the file.
std::string fbxBytes() {
    const auto word = [](std::size_t value) {
        const auto number = static_cast<std::uint32_t>(value);
        return std::string(reinterpret_cast<const char*>(&number), 4);
    };
    const auto text = [&](const std::string& value) { return "S" + word(value.size()) + value; };
    const std::string zeros(13, '\0');
    const std::string values =
        text("UpAxis") + text("int") + text("Integer") + text("") + "I" + word(2);
    const std::size_t first = 27 + 13 + 14, second = first + 13 + 12,
                      end = second + 13 + 1 + values.size();
    return std::string("Kaydara FBX Binary  \0\x1a\0", 23) + word(7400) + word(end + 26) + word(0) +
           word(0) + "\x0eGlobalSettings" + word(end + 13) + word(0) + word(0) +
           "\x0cProperties70" + word(end) + word(5) + word(values.size()) + "\x01P" + values +
           zeros + zeros + zeros;
}

const char* const collada =
    "<COLLADA><asset><unit meter=\"0.01\"/><up_axis>Z_UP</up_axis></asset><library_geometries>"
    "<geometry id=\"g\"><mesh><polylist count=\"1\"><input semantic=\"VERTEX\" offset=\"0\"/>"
    "<vcount>4</vcount><p>0 1 2 3</p></polylist></mesh></geometry></library_geometries>"
    "<library_visual_scenes><visual_scene id=\"s\"><node id=\"n\"><instance_geometry url=\"#g\"/>"
    "</node></visual_scene></library_visual_scenes><scene><instance_visual_scene url=\"#s\"/>"
    "</scene></COLLADA>\n";

const char* const directX = "xof 0303txt 0032\nMaterial a "
                            "{\n1;1;1;1;;\n1;\n0,0,0;;\n0;0;0;;\n}\n// units = mm\nFrame f {\nMesh "
                            "m {\n3;\n0;0;0;,\n1;0;0;,\n0;1;0;;\n1;\n3;0,1,2;;\nMeshMaterialList "
                            "{\n1;\n1;\n0;\n{ a }\n}\n}\n}\n";

const char* const line =
    " 21  667.661000 3.000E-19 1.523E+00.07890.099  100.25000.74-.000510       0 1 1 01\n";
const char* const ascent = "altitude [m],pressure [hPa],temperature [K],relative_humidity [%]\n"
                           "0,1013,290,50\n1000,900,284,40\n2000,800,278,30\n";
const char* const materials = "newmtl m\nKd 0.5 0.5 0.5\nKa 1 1 1\nNs 10\nd 0.5\nmap_Kd a.png\n";

const char* const plumePoints = "x [m],y [m],z [m],T [K],CO2,soot [ppmv]\n"
                                "0,0,0,900,0.1,0\n0,0.5,0.25,700,0.05,1\n1,0,1,800,0.1,0\n"
                                "1,1,0.5,500,0.02,2\n0.5,0.5,0.5,600,0.1,0\n0.25,1,0,400,0,0\n"
                                "2,0,0,500,0.1,0\n2,1,1,400,0.1,0\n1.5,0.5,0,450,0.1,0\n";
const char* const plumeGrid = "x [m],y [m],z [m],T [K],H2O\n0,0,0,900,0.1\n0,0,1,700,0.1\n"
                              "0,1,0,600,0.1\n0,1,1,500,0.1\n1,0,0,800,0.1\n1,0,1,600,0.1\n"
                              "1,1,0,500,0.1\n1,1,1,400,0.1\n";
const char* const plume = "x [m],r [m],T [K],p [atm],CO2,H2O,soot [ppmv]\n"
                          "0,0,1200,1,0.1,0.1,0.5\n0,0.5,900,1,0.05,0.1,0.2\n0,1,300,1,0,0.01,0\n"
                          "2,0,900,1,0.1,0.1,0.5\n2,0.5,600,1,0.05,0.1,0.2\n2,1,290,1,0,0.01,0\n";
const char* const narrowBands =
    "# gas: CO2\n# law: goody\n# between temperatures: straight\n# temperatures: 300 600\n"
    "# source: invented\n"
    "wavenumber [cm-1],k_300 [cm-1 atm-1],k_600 [cm-1 atm-1],inverse_spacing_300 [cm],"
    "inverse_spacing_600 [cm]\n2000,0.1,0.2,1,2\n2005,0.1,0.2,1,2\n2010,0.2,0.3,1,2\n";

std::string codesText() {
    irsg::ModelCodes codes;
    codes.rules = {{irsg::CodeRule::Of::object, "wing*", {2, 1}},
                   {irsg::CodeRule::Of::material, "p?int", {{}, 3}}};
    codes.painted = {{{1, {}}, {{0, 0, 0, 1, 0, 0, 0, 1, 0}}}};
    return irsg::modelCodesToJson(codes);
}

} // namespace

std::vector<FuzzedReader> packedReaders() {
    return {
        {"line-list",
         ".par",
         [](File f) { irsg::lbl::readLineList(irsg::Gas::CO2, f); },
         {},
         {line}},
        {"gas-table", ".gastable", readGasTable, {}, {gasTableBytes()}},
        {"radiosonde",
         ".csv",
         [](File f) {
             static const irsg::Profile background =
                 irsg::Profile::model(irsg::ModelAtmosphere::usStandard1976);
             irsg::Profile::fromRadiosonde(f, background);
         },
         {},
         {ascent}},
        {"plume-table",
         ".csv",
         [](File f) { irsg::plumeZones(irsg::PlumeTable::read(f), 4); },
         {},
         {plume}},
        {"plume-points",
         ".csv",
         [](File f) { irsg::readPlumePoints(irsg::CsvTable::read(f)).parts(); },
         {},
         {plumePoints, plumeGrid}},
        {"narrow-band", ".csv", [](File f) { irsg::NarrowBandTable::read(f); }, {}, {narrowBands}},
        {"model-codes",
         ".codes.json",
         [](File f) { irsg::modelCodesFromJson(irsg::readFile(f), "a"); },
         {},
         {codesText()}},
        {"mtf",
         ".mtf",
         [](File f) { irsg::describeMtf(f); },
         {"resources/scattering/droplets-100um-mwir.mtf"},
         {},
         16384},
        {"graph", ".graph", readGraph, {}, {graphBytes()}},
        {"refusal", ".refusal", readRefusal, {}, {std::string(8, '\0')}},
        {"mtl", ".mtl", readMaterials, {}, {materials}},
        {"whole",
         ".whole",
         readWhole,
         {},
         {"a { \"b}\" { } }\n", "<a><b/></a>\n", studioBytes(), objectOfAc}},
        {"gltf", ".gltf", [](File f) { irsg::readGltfFile(f, f); }, {}, {gltf, glbBytes()}},
        {"fbx", ".fbx", [](File f) { irsg::readFbxFile(f, f); }, {}, {fbx, fbxBytes()}},
        {"collada", ".dae", [](File f) { irsg::readColladaFile(f, f); }, {}, {collada}},
        {"x", ".x", [](File f) { irsg::readXFile(f, f); }, {}, {directX}},
        {"axes", ".axes", readAxes, {}, {axesBytes()}},
    };
}

} // namespace smat::test
