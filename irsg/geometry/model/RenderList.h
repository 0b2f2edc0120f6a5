#pragma once

#include <vector>

#include <osg/Geometry>
#include <osg/Matrixd>
#include <osg/ref_ptr>

#include "irsg/geometry/model/Model.h"

namespace irsg {

/// One piece of a model that is drawn with one pair of codes.
struct RenderItem {
    osg::ref_ptr<osg::Geometry> geometry;
    osg::Matrixd modelFromLocal; ///< of the transforms above it
    IrCodes codes;
    bool cullsBackFaces = false; ///< OpenFlight draw type 0
    int layer = 0;               ///< OpenFlight subface level: drawn over the face it lies on
};

/// The visible pieces of a model in the order of its graph. Level-of-detail nodes show their most
/// detailed child at every range, switches their active ones.
std::vector<RenderItem> collectRenderItems(const Model& model);

/// A sphere about the centre of a model's bounding box that holds all its vertices.
struct BoundingSphere {
    Vec3 centre_m; ///< model axes
    double radius_m = 0.0;
};
BoundingSphere boundingSphere(const std::vector<RenderItem>& items, const BoundingBox& bounds);

} // namespace irsg
