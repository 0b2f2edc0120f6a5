#include "irsg/geometry/reading/text/FaceDrawable.h"

#include <cstdint>

#include "irsg/geometry/reading/Triangulation.h"

namespace irsg {

namespace {

std::vector<PolygonCorner> polygonOf(const FaceShape& shape, const std::vector<FaceCorner>& face) {
    std::vector<PolygonCorner> corners(face.size());
    for (std::size_t i = 0; i < face.size(); ++i)
        corners[i].position = shape.vertices[static_cast<std::size_t>(face[i].vertex)];
    return corners;
}

/// The sum of the cross products of its edges, not of unit length.
osg::Vec3d newellNormal(const FaceShape& shape, const std::vector<FaceCorner>& face) {
    const auto at = [&](std::size_t i) {
        return shape.vertices[static_cast<std::size_t>(face[i].vertex)];
    };
    osg::Vec3d sum;
    for (std::size_t i = 1; i + 1 < face.size(); ++i)
        sum += (at(i) - at(0)) ^ (at(i + 1) - at(0));
    return sum;
}

} // namespace

std::size_t FaceDrawable::Hash::operator()(const FaceCorner& corner) const {
    std::uint64_t mixed = 0;
    for (const int number : {corner.vertex, corner.place, corner.normal}) {
        mixed = (mixed ^ static_cast<std::uint32_t>(number)) * 0x9E3779B97F4A7C15u;
        mixed ^= mixed >> 32;
    }
    return mixed;
}

unsigned int FaceDrawable::index(const FaceCorner& corner, const osg::Vec3f& faceNormal) {
    anyPlace_ = anyPlace_ || corner.place >= 0;
    const auto number = static_cast<unsigned int>(corners_.size());
    if (corner.normal >= 0) {
        const auto [at, added] = known_.try_emplace(corner, number);
        if (!added)
            return at->second;
    }
    corners_.push_back(corner);
    normals_.push_back(corner.normal < 0
                           ? faceNormal
                           : osg::Vec3f(shape_->normals[static_cast<std::size_t>(corner.normal)]));
    return number;
}

void FaceDrawable::add(const std::vector<FaceCorner>& face) {
    bool stated = true;
    for (const FaceCorner& corner : face)
        stated = stated && corner.normal >= 0;
    osg::Vec3d normal;
    if (!stated) {
        normal = newellNormal(*shape_, face);
        normal.normalize();
    }
    const osg::Vec3f own(normal);
    std::vector<unsigned int> indices;
    for (FaceCorner corner : face) {
        if (!stated)
            corner.normal = -1;
        indices.push_back(index(corner, own));
    }
    if (face.size() == 3) {
        triangles_.insert(triangles_.end(), indices.begin(), indices.end());
    } else if (face.size() == 4) {
        quads_.insert(quads_.end(), indices.begin(), indices.end());
    } else {
        for (const auto& triangle : triangulate(polygonOf(*shape_, face)).triangles)
            for (const auto corner : triangle)
                triangles_.push_back(indices[corner]);
    }
}

osg::ref_ptr<osg::Vec4Array> FaceDrawable::colours() const {
    osg::ref_ptr<osg::Vec4Array> colours = new osg::Vec4Array(osg::Array::BIND_PER_VERTEX);
    for (const FaceCorner& corner : corners_)
        if (const auto vertex = static_cast<std::size_t>(corner.vertex);
            vertex < shape_->colours.size())
            colours->push_back(shape_->colours[vertex]);
    if (colours->size() != corners_.size() || corners_.empty()) {
        colours = new osg::Vec4Array(osg::Array::BIND_OVERALL, 1);
        colours->front() = osg::Vec4(1, 1, 1, 1);
    }
    return colours;
}

osg::ref_ptr<osg::Geometry> FaceDrawable::make(const osg::Vec3d& origin) const {
    osg::ref_ptr<osg::Vec3Array> vertices = new osg::Vec3Array(osg::Array::BIND_PER_VERTEX);
    osg::ref_ptr<osg::Vec2Array> places = new osg::Vec2Array(osg::Array::BIND_PER_VERTEX);
    vertices->reserve(corners_.size());
    for (const FaceCorner& corner : corners_) {
        vertices->push_back(
            osg::Vec3(shape_->vertices[static_cast<std::size_t>(corner.vertex)] - origin));
        if (anyPlace_)
            places->push_back(
                corner.place < 0
                    ? osg::Vec2()
                    : osg::Vec2(shape_->places[static_cast<std::size_t>(corner.place)]));
    }
    osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    geometry->setUseVertexBufferObjects(true);
    geometry->setVertexArray(vertices);
    geometry->setNormalArray(new osg::Vec3Array(normals_.begin(), normals_.end()),
                             osg::Array::BIND_PER_VERTEX);
    geometry->setColorArray(colours());
    if (anyPlace_)
        geometry->setTexCoordArray(0, places);
    if (!triangles_.empty())
        geometry->addPrimitiveSet(
            new osg::DrawElementsUInt(GL_TRIANGLES, triangles_.begin(), triangles_.end()));
    if (!quads_.empty())
        geometry->addPrimitiveSet(
            new osg::DrawElementsUInt(GL_QUADS, quads_.begin(), quads_.end()));
    return geometry;
}

} // namespace irsg
