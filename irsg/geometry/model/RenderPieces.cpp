#include "irsg/geometry/model/RenderPieces.h"

#include <algorithm>
#include <array>
#include <span>

#include <osg/BoundingBox>
#include <osg/PrimitiveSet>
#include <osg/TriangleIndexFunctor>

namespace irsg {

namespace {

struct Triangle {
    std::array<unsigned, 3> corners;
    osg::Vec3 middle;
};

struct PieceTriangles {
    std::vector<std::array<unsigned, 3>> corners;
    void operator()(unsigned a, unsigned b, unsigned c) { corners.push_back({a, b, c}); }
};

/// Says the box of a piece, whose vertex array holds all pieces.
class KnownBox : public osg::Drawable::ComputeBoundingBoxCallback {
  public:
    explicit KnownBox(const osg::BoundingBox& box) : box_(box) {}
    osg::BoundingBox computeBound(const osg::Drawable&) const override { return box_; }

  private:
    osg::BoundingBox box_;
};

bool isPerVertex(const osg::Array* array) {
    return !array || array->getBinding() == osg::Array::BIND_PER_VERTEX ||
           array->getBinding() == osg::Array::BIND_OVERALL;
}

osg::ref_ptr<osg::Geometry> pieceOf(osg::Geometry& whole, const osg::Vec3Array& vertices,
                                    std::span<const Triangle> triangles) {
    osg::ref_ptr<osg::Geometry> piece = new osg::Geometry;
    piece->setUseDisplayList(false);
    piece->setUseVertexBufferObjects(true);
    piece->setUseVertexArrayObject(true);
    piece->setVertexArray(whole.getVertexArray());
    if (whole.getNormalArray())
        piece->setNormalArray(whole.getNormalArray());
    osg::ref_ptr<osg::DrawElementsUInt> elements = new osg::DrawElementsUInt(GL_TRIANGLES);
    osg::BoundingBox box;
    for (const Triangle& triangle : triangles)
        for (const unsigned corner : triangle.corners) {
            elements->push_back(corner);
            box.expandBy(vertices[corner]);
        }
    piece->addPrimitiveSet(elements);
    piece->setComputeBoundingBoxCallback(new KnownBox(box));
    return piece;
}

/// Halves the triangles along the longest side of their middles until there are few enough.
template <typename Take>
void halve(std::span<Triangle> triangles, std::size_t most, Take take) {
    if (triangles.size() <= most)
        return take(triangles);
    osg::BoundingBox middles;
    for (const Triangle& triangle : triangles)
        middles.expandBy(triangle.middle);
    const osg::Vec3 side = middles._max - middles._min;
    const int axis = side.x() >= side.y() && side.x() >= side.z() ? 0
                     : side.y() >= side.z()                       ? 1
                                                                  : 2;
    const auto half = static_cast<std::ptrdiff_t>(triangles.size() / 2);
    std::ranges::stable_sort(triangles, {},
                             [axis](const Triangle& triangle) { return triangle.middle[axis]; });
    halve(triangles.first(static_cast<std::size_t>(half)), most, take);
    halve(triangles.subspan(static_cast<std::size_t>(half)), most, take);
}

} // namespace

std::vector<RenderItem> inRenderPieces(const std::vector<RenderItem>& items) {
    std::vector<RenderItem> pieces;
    for (const RenderItem& item : items) {
        osg::Geometry& whole = *item.geometry;
        const auto* vertices = dynamic_cast<const osg::Vec3Array*>(whole.getVertexArray());
        osg::TriangleIndexFunctor<PieceTriangles> found;
        if (vertices && isPerVertex(whole.getNormalArray()))
            whole.accept(found);
        if (found.corners.size() <= mostTriangles) {
            pieces.push_back(item);
            continue;
        }
        std::vector<Triangle> triangles;
        for (const auto& c : found.corners)
            triangles.push_back(
                {c, ((*vertices)[c[0]] + (*vertices)[c[1]] + (*vertices)[c[2]]) / 3.0f});
        // A drawing minds each piece, so that of a large geometry there are not ever more.
        constexpr std::size_t mostPieces = 128;
        const std::size_t most = std::max(mostTriangles, triangles.size() / mostPieces);
        halve(std::span<Triangle>(triangles), most, [&](std::span<const Triangle> near) {
            RenderItem& piece = pieces.emplace_back(item);
            piece.geometry = pieceOf(whole, *vertices, near);
        });
    }
    return pieces;
}

} // namespace irsg
