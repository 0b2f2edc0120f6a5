#include "irsg/scene/model/SurfaceMesh.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <string_view>

#include <osg/CullFace>
#include <osg/PolygonOffset>

#include "irsg/scene/model/IrCodes.h"
#include "irsg/scene/model/Triangulation.h"

namespace irsg {
namespace {

Vec3 asVec3(const osg::Vec3& v) {
    return {v.x(), v.y(), v.z()};
}

void extend(BoundingBox& box, const Vec3& p) {
    if (!box.valid())
        box = {p, p};
    box.min = {std::min(box.min.x, p.x), std::min(box.min.y, p.y), std::min(box.min.z, p.z)};
    box.max = {std::max(box.max.x, p.x), std::max(box.max.y, p.y), std::max(box.max.z, p.z)};
}

template <typename Array, typename Values>
osg::ref_ptr<Array> perVertex(const Values& values) {
    osg::ref_ptr<Array> array = new Array(values.begin(), values.end());
    array->setBinding(osg::Array::BIND_PER_VERTEX);
    return array;
}

} // namespace

bool SurfaceMesh::Vertex::operator==(const Vertex& o) const {
    return std::memcmp(values, o.values, sizeof values) == 0;
}
std::size_t SurfaceMesh::Hash::operator()(const Vertex& v) const {
    return std::hash<std::string_view>{}(
        {reinterpret_cast<const char*>(v.values), sizeof v.values});
}

unsigned int SurfaceMesh::index(const Key& key, Part& part, const PolygonCorner& corner) {
    // A zero has one sign, so that equal places are one vertex.
    const osg::Vec3 p(corner.position), n(corner.normal);
    const auto& c = corner.colour;
    const Vertex vertex{{p.x() + 0.0f, p.y() + 0.0f, p.z() + 0.0f, n.x() + 0.0f, n.y() + 0.0f,
                         n.z() + 0.0f, c[0], c[1], c[2], c[3]}};
    const auto [place, added] =
        known_[key].emplace(vertex, static_cast<unsigned int>(part.vertices.size()));
    if (added) {
        part.vertices.push_back(p);
        part.normals.push_back(n);
        part.colours.push_back(c);
        extend(part.bounds, asVec3(p));
    }
    return place->second;
}

void SurfaceMesh::add(const Key& key, std::vector<PolygonCorner>& corners) {
    const auto cut = triangulate(corners);
    if (cut.triangles.empty()) {
        ++degenerate_;
        return;
    }
    folded_ += cut.folded;

    // Each corner gets a unit normal; together they must face as the polygon does.
    osg::Vec3d sum;
    bool made = false;
    for (auto& corner : corners) {
        const double size = corner.normal.length();
        const bool usable = std::isfinite(size) && size > 1e-12;
        corner.normal = usable ? corner.normal / size : cut.normal;
        made = made || !usable;
        sum += corner.normal;
    }
    normalsMade_ += made;
    if (sum * cut.normal < 0.0) {
        ++normalsTurned_;
        for (auto& corner : corners)
            corner.normal = -corner.normal;
    }

    auto& part = parts_[key];
    ++part.polygons;
    part.area_m2 += cut.area;
    for (const auto& triangle : cut.triangles)
        for (const auto corner : triangle)
            part.triangles.push_back(index(key, part, corners[corner]));
}

osg::ref_ptr<osg::Geometry> SurfaceMesh::drawable(const Key& key, const Part& part) {
    osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    geometry->setDataVariance(osg::Object::STATIC);
    geometry->setUseDisplayList(false);
    geometry->setUseVertexBufferObjects(true);
    geometry->setVertexArray(perVertex<osg::Vec3Array>(part.vertices));
    geometry->setNormalArray(perVertex<osg::Vec3Array>(part.normals));
    geometry->setColorArray(perVertex<osg::Vec4Array>(part.colours));
    geometry->addPrimitiveSet(
        new osg::DrawElementsUInt(GL_TRIANGLES, part.triangles.begin(), part.triangles.end()));

    auto* state = geometry->getOrCreateStateSet();
    state->setDataVariance(osg::Object::STATIC);
    if (key.culled)
        state->setAttributeAndModes(new osg::CullFace(osg::CullFace::BACK));
    else
        state->setMode(GL_CULL_FACE, osg::StateAttribute::OFF);
    if (key.layer > 0) {
        const auto layer = static_cast<float>(-key.layer);
        state->setAttributeAndModes(new osg::PolygonOffset(layer, layer));
    }
    setCodes(*geometry, key.codes);
    return geometry;
}

} // namespace irsg
