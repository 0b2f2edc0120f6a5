#pragma once

#include <functional>
#include <string>
#include <vector>

#include <osg/Geode>
#include <osg/Geometry>

#include "irsg/core/Errors.h"
#include "irsg/geometry/model/Model.h"
#include "irsg/geometry/reading/IrCodes.h"

namespace irsg::test {

constexpr double single = 1e-6; ///< what single precision leaves of a number near 1

/// The drawables of a loaded model, in their order.
inline const osg::Geometry& drawable(const Model& model, unsigned int i) {
    return *model.graph()->asGroup()->getChild(0)->asGeode()->getDrawable(i)->asGeometry();
}

inline unsigned int drawables(const Model& model) {
    return model.graph()->asGroup()->getChild(0)->asGeode()->getNumDrawables();
}

inline const osg::Vec3Array& array(const osg::Array* values) {
    return dynamic_cast<const osg::Vec3Array&>(*values);
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

inline osg::Vec3 faceNormal(const osg::Geometry& geometry, unsigned int triangle) {
    const auto& v = array(geometry.getVertexArray());
    const auto* set = geometry.getPrimitiveSet(0);
    const auto a = v[set->index(3 * triangle)], b = v[set->index(3 * triangle + 1)],
               c = v[set->index(3 * triangle + 2)];
    auto normal = (b - a) ^ (c - a);
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
