#include "irsg/geometry/model/RenderList.h"

#include <algorithm>
#include <cmath>

#include <osg/CullFace>
#include <osg/NodeVisitor>
#include <osg/PolygonOffset>
#include <osg/Transform>

#include "irsg/geometry/reading/IrCodes.h"

namespace irsg {

namespace {

/// The loader gives subfaces of level n a polygon offset of -n.
int layerOf(const osg::Drawable& drawable) {
    const auto* state = drawable.getStateSet();
    const auto* offset = state ? dynamic_cast<const osg::PolygonOffset*>(
                                     state->getAttribute(osg::StateAttribute::POLYGONOFFSET))
                               : nullptr;
    return offset ? static_cast<int>(std::lround(-offset->getFactor())) : 0;
}

class Collector : public osg::NodeVisitor {
  public:
    Collector() : osg::NodeVisitor(TRAVERSE_ACTIVE_CHILDREN) {}

    void apply(osg::Drawable& drawable) override {
        osg::Geometry* geometry = drawable.asGeometry();
        if (!geometry)
            return;
        // Array state per geometry: OSG's shared array state compares addresses of arrays, and
        // those of a model that is gone come back with the next one.
        geometry->setUseDisplayList(false);
        geometry->setUseVertexBufferObjects(true);
        geometry->setUseVertexArrayObject(true);
        const osg::Matrixd modelFromLocal = osg::computeLocalToWorld(getNodePath());
        items.push_back({geometry, modelFromLocal, codesOf(drawable, getNodePath()),
                         cullsBackFaces(drawable), layerOf(drawable)});
    }

    std::vector<RenderItem> items;

  private:
    /// The culling mode nearest to the drawable decides.
    bool cullsBackFaces(const osg::Drawable& drawable) const {
        bool culls = false;
        auto look = [&](const osg::StateSet* state) {
            if (!state)
                return;
            const auto mode = state->getMode(GL_CULL_FACE);
            if (mode != osg::StateAttribute::INHERIT)
                culls = (mode & osg::StateAttribute::ON) != 0;
        };
        for (const osg::Node* node : getNodePath())
            look(node->getStateSet());
        look(drawable.getStateSet());
        return culls;
    }
};

} // namespace

std::vector<RenderItem> collectRenderItems(const Model& model) {
    Collector collector;
    model.graph()->accept(collector);
    return std::move(collector.items);
}

BoundingSphere boundingSphere(const std::vector<RenderItem>& items, const BoundingBox& bounds) {
    const Vec3 centre = bounds.centre();
    double square_m2 = 0.0;
    for (const RenderItem& item : items) {
        const auto* vertices = dynamic_cast<const osg::Vec3Array*>(item.geometry->getVertexArray());
        // Of what keeps its vertices otherwise, the box is known alone.
        if (!vertices)
            return {centre, 0.5 * bounds.diagonal_m()};
        for (const osg::Vec3& vertex : *vertices) {
            const osg::Vec3d place = osg::Vec3d(vertex) * item.modelFromLocal;
            const Vec3 arm = Vec3{place.x(), place.y(), place.z()} - centre;
            square_m2 = std::max(square_m2, dot(arm, arm));
        }
    }
    return {centre, std::sqrt(square_m2) * (1.0 + 1e-9)};
}

} // namespace irsg
