#pragma once

#include <osg/Matrixd>
#include <osg/Vec3>
#include <osg/Vec3d>

#include "irsg/geometry/mesh/Mesh.h"
#include "irsg/geometry/view/Matrix4.h"

namespace irsg {

inline osg::Vec3 toOsg(const Float3& v) {
    return {v[0], v[1], v[2]};
}
inline osg::Vec3d toOsg(const Vec3& v) {
    return {v.x, v.y, v.z};
}
inline osg::Matrixd toOsg(const Matrix4& m) {
    return osg::Matrixd(m.rows.front().data());
}
inline Vec3 fromOsg(const osg::Vec3d& v) {
    return {v.x(), v.y(), v.z()};
}

} // namespace irsg
