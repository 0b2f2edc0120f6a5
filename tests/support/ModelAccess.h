#pragma once

#include <functional>
#include <string>
#include <vector>

#include <osg/Geode>
#include <osg/Geometry>

#include "irsg/core/Errors.h"
#include "irsg/geometry/conversion/OsgValues.h"
#include "irsg/geometry/reading/IrCodes.h"
#include "tests/support/MadeGraphs.h"

namespace irsg::test {

constexpr double single = 1e-6; ///< what single precision leaves of a number near 1

inline const Mesh::Part& partOf(const Model& model, std::size_t i) {
    return model.mesh()->parts.at(i);
}

inline std::size_t parts(const Model& model) {
    return model.mesh()->parts.size();
}

/// A polygon with ShapeAttributes, as a graph made in memory has it.
inline osg::ref_ptr<osg::Geode> polygon(const std::vector<osg::Vec3>& corners, IrCodes codes,
                                        GLenum mode = GL_POLYGON) {
    osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    geometry->setVertexArray(new osg::Vec3Array(corners.begin(), corners.end()));
    geometry->addPrimitiveSet(new osg::DrawArrays(mode, 0, static_cast<GLsizei>(corners.size())));
    setCodes(*geometry, codes);
    osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    geode->addDrawable(geometry);
    return geode;
}

inline const std::vector<osg::Vec3> square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};

inline osg::Vec3 faceNormal(const Mesh::Part& part, std::size_t triangle) {
    const auto corner = [&](std::size_t k) {
        return toOsg(part.vertices.at(part.triangles.at(3 * triangle + k)));
    };
    auto normal = (corner(1) - corner(0)) ^ (corner(2) - corner(0));
    normal.normalize();
    return normal;
}

inline std::string refusal(const std::function<void()>& act) {
    try {
        act();
    } catch (const InputError& error) {
        return error.what();
    }
    return "accepted";
}

} // namespace irsg::test
