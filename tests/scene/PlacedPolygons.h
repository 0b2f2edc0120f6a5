#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>

#include <gtest/gtest.h>
#include <osg/Geometry>
#include <osg/NodeVisitor>

#include "irsg/geometry/conversion/ModelLoader.h"
#include "irsg/geometry/reading/MaterialNames.h"
#include "tests/support/ForeignModels.h"

namespace irsg::test {

/// Every placed polygon of a loaded graph in the axes of the file.
class Placed : public osg::NodeVisitor {
  public:
    explicit Placed(osg::Node& graph) : osg::NodeVisitor(TRAVERSE_ALL_CHILDREN) {
        graph.accept(*this);
    }
    void apply(osg::Drawable& drawable) override {
        auto* geometry = drawable.asGeometry();
        ASSERT_TRUE(geometry);
        const auto matrix = osg::computeLocalToWorld(getNodePath());
        drawables.insert(geometry);
        std::string name;
        for (const auto* node : getNodePath()) {
            if (!node->getName().empty() && !node->asDrawable()) {
                name += "/" + node->getName();
            }
        }
        names.insert(name);
        const auto* state = geometry->getStateSet();
        const std::string material = state ? materialNameOf(*state) : "";
        const auto& places = dynamic_cast<const osg::Vec3Array&>(*geometry->getVertexArray());
        for (unsigned int i = 0; i < geometry->getNumPrimitiveSets(); ++i) {
            const auto& set = *geometry->getPrimitiveSet(i);
            const unsigned int count = set.getMode() == GL_QUADS ? 4 : 3;
            for (unsigned int j = 0; j + count <= set.getNumIndices(); j += count) {
                ++polygons;
                for (unsigned int k = 2; k < count; ++k) {
                    const auto corner = [&](unsigned int at) {
                        return osg::Vec3d(places[set.index(j + at)]) * matrix;
                    };
                    const auto a = corner(0), b = corner(k - 1), c = corner(k);
                    area += 0.5 * ((b - a) ^ (c - a)).length();
                    areaOfMaterials[material] += 0.5 * ((b - a) ^ (c - a)).length();
                    for (const auto& each : {a, b, c}) {
                        bounds.expandBy(each);
                    }
                }
            }
        }
    }

    double area = 0.0;
    int polygons = 0;
    std::map<std::string, double> areaOfMaterials;
    osg::BoundingBoxd bounds;
    std::set<const osg::Geometry*> drawables;
    std::set<std::string> names;
};

inline LoadedGraph load(const std::filesystem::path& file) {
    return loadGraph(file, LoadPurpose::visible);
}

inline FbxWriter fbxBox() {
    FbxWriter fbx;
    fbx.corners = boxCorners(1, 2, 3);
    fbx.polygons = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                    {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
    return fbx;
}

inline ColladaWriter colladaBox() {
    const FbxWriter box = fbxBox();
    ColladaWriter collada;
    collada.corners = box.corners;
    collada.polygons = box.polygons;
    return collada;
}

} // namespace irsg::test
