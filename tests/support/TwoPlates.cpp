#include "tests/support/TwoPlates.h"

#include <osg/Geode>
#include <osg/Geometry>
#include <osgDB/Registry>
#include <sstream>

#include "tests/support/ForeignModels.h"

namespace irsg::test {

namespace {

const std::vector<osg::Vec3d> corners = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0},
                                         {0, 0, 1}, {3, 0, 1}, {3, 1, 1}, {0, 1, 1}};
const char* const objText =
    "mtllib none.mtl\nv 0 0 0\nv 2 0 0\nv 2 0 1\nv 0 0 1\nv 0 1 0\nv 3 1 0\n"
    "v 3 1 1\nv 0 1 1\no Hull\nusemtl PaintGrey\nf 1 2 3 4\no Exhaust\n"
    "usemtl HotPipe\nf 5 6 7 8\n";

std::string stlText() {
    std::string text;
    for (const auto& [name, first] : {std::pair{"Hull", 0u}, {"Exhaust", 4u}}) {
        text += std::string("solid ") + name + "\n";
        for (const auto& face : {std::vector{0u, 1u, 2u}, {0u, 2u, 3u}}) {
            text += "facet normal 0 0 1\nouter loop\n";
            for (const unsigned int corner : face) {
                const osg::Vec3d& place = corners[first + corner];
                std::ostringstream line;
                line << "vertex " << place.x() << " " << place.y() << " " << place.z() << "\n";
                text += line.str();
            }
            text += "endloop\nendfacet\n";
        }
        text += std::string("endsolid ") + name + "\n";
    }
    return text;
}

std::string plyText() {
    std::ostringstream text;
    text << "ply\nformat ascii 1.0\nelement vertex 8\nproperty float x\nproperty float y\nproperty "
            "float z\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n";
    for (const osg::Vec3d& place : corners) {
        text << place.x() << " " << place.y() << " " << place.z() << "\n";
    }
    text << "4 0 1 2 3\n4 4 5 6 7\n";
    return text.str();
}

std::string acText() {
    std::ostringstream text;
    text << "AC3Db\n";
    for (const char* name : {"PaintGrey", "HotPipe"}) {
        text << "MATERIAL \"" << name
             << "\" rgb 1 0 0 amb 1 0 0 emis 0 0 0 spec 0 0 0 shi 1 trans 0\n";
    }
    text << "OBJECT world\nkids 2\n";
    for (unsigned int part = 0; part < 2; ++part) {
        text << "OBJECT poly\nname \"" << (part == 0 ? "Hull" : "Exhaust") << "\"\nnumvert 4\n";
        for (unsigned int i = 0; i < 4; ++i) {
            const osg::Vec3d& place = corners[4 * part + i];
            text << place.x() << " " << place.y() << " " << place.z() << "\n";
        }
        text << "numsurf 1\nSURF 0x20\nmat " << part
             << "\nrefs 4\n0 0 0\n1 0 0\n2 0 0\n3 0 0\nkids 0\n";
    }
    return text.str();
}

std::string dxfText() {
    std::ostringstream text;
    text << "0\nSECTION\n2\nENTITIES\n";
    for (unsigned int part = 0; part < 2; ++part) {
        text << "0\n3DFACE\n8\n" << (part == 0 ? "Hull" : "Exhaust") << "\n";
        for (unsigned int i = 0; i < 4; ++i) {
            const osg::Vec3d& place = corners[4 * part + i];
            text << "1" << i << "\n"
                 << place.x() << "\n2" << i << "\n"
                 << place.y() << "\n3" << i << "\n"
                 << place.z() << "\n";
        }
    }
    text << "0\nENDSEC\n0\nEOF\n";
    return text.str();
}

const char* const xText =
    "xof 0303txt 0032\nMaterial PaintGrey {\n0.5;0.5;0.5;1.0;;\n10.0;\n0.1;0.1;0.1;;\n0;0;0;;\n}\n"
    "Material HotPipe {\n0.9;0.1;0.1;1.0;;\n10.0;\n0.1;0.1;0.1;;\n0;0;0;;\n}\n"
    "Frame Hull {\nMesh HullMesh {\n4;\n0;0;0;,\n2;0;0;,\n2;0;1;,\n0;0;1;;\n1;\n4;0,1,2,3;;\n"
    "MeshMaterialList {\n1;\n1;\n0;\n{ PaintGrey }\n}\n}\n}\n"
    "Frame Exhaust {\nMesh ExhaustMesh {\n4;\n0;1;0;,\n3;1;0;,\n3;1;1;,\n0;1;1;;\n1;\n4;0,1,2,3;;\n"
    "MeshMaterialList {\n1;\n1;\n0;\n{ HotPipe }\n}\n}\n}\n";

std::string sceneText(const char* extension, const char* type) {
    osg::ref_ptr<osg::Group> root = new osg::Group;
    for (unsigned int part = 0; part < 2; ++part) {
        osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
        osg::ref_ptr<osg::Vec3Array> places = new osg::Vec3Array(osg::Array::BIND_PER_VERTEX);
        for (unsigned int i = 0; i < 4; ++i) {
            places->push_back(osg::Vec3(corners[4 * part + i]));
        }
        geometry->setVertexArray(places);
        geometry->addPrimitiveSet(new osg::DrawArrays(GL_QUADS, 0, 4));
        osg::ref_ptr<osg::Geode> geode = new osg::Geode;
        geode->setName(part == 0 ? "Hull" : "Exhaust");
        osg::StateSet* state = geometry->getOrCreateStateSet();
        state->setName(part == 0 ? "PaintGrey" : "HotPipe");
        geode->addDrawable(geometry);
        root->addChild(geode);
    }
    osg::ref_ptr<osgDB::Options> options = new osgDB::Options;
    if (*type) {
        options->setPluginStringData("fileType", type);
    }
    std::ostringstream text;
    osgDB::Registry::instance()->getReaderWriterForExtension(extension)->writeNode(*root, text,
                                                                                   options);
    return text.str();
}

std::string colladaText() {
    ColladaWriter writer;
    writer.unit = "<unit name=\"metre\" meter=\"1\"/>";
    writer.corners = corners;
    writer.polygons = {{0, 1, 2, 3}, {4, 5, 6, 7}};
    return writer.text();
}

std::string fbxText() {
    FbxWriter writer;
    writer.unit_cm = 100.0;
    writer.corners = corners;
    writer.polygons = {{0, 1, 2, 3}, {4, 5, 6, 7}};
    return writer.text();
}

std::string gltfText() {
    GltfWriter writer;
    for (unsigned int part = 0; part < 2; ++part) {
        const std::vector<osg::Vec3d> places(corners.begin() + 4 * part,
                                             corners.begin() + 4 * part + 4);
        const auto material =
            writer.material({{"name", part == 0 ? "PaintGrey" : "HotPipe"}, {"doubleSided", true}});
        const auto positions = writer.positions(places);
        const auto mesh = writer.mesh(part == 0 ? "HullMesh" : "ExhaustMesh",
                                      {{"attributes", {{"POSITION", positions}}},
                                       {"indices", writer.indices({0, 1, 2, 0, 2, 3})},
                                       {"material", material}});
        writer.node({{"name", part == 0 ? "Hull" : "Exhaust"}, {"mesh", mesh}});
    }
    return writer.text();
}

} // namespace

const std::map<std::string, std::string>& twoPlates() {
    static const std::map<std::string, std::string> texts = {{"obj", objText},
                                                             {"stl", stlText()},
                                                             {"ply", plyText()},
                                                             {"ac", acText()},
                                                             {"dxf", dxfText()},
                                                             {"x", xText},
                                                             {"osg", sceneText("osg", "")},
                                                             {"osgt", sceneText("osgt", "Ascii")},
                                                             {"osgx", sceneText("osgx", "XML")},
                                                             {"dae", colladaText()},
                                                             {"fbx", fbxText()},
                                                             {"gltf", gltfText()}};
    return texts;
}

} // namespace irsg::test
