#include "irsg/geometry/reading/FarOrigin.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string_view>

#include <osg/Geode>
#include <osg/Geometry>
#include <osg/MatrixTransform>
#include <osg/NodeVisitor>

#include "irsg/core/Errors.h"

namespace irsg {

namespace {

constexpr double floatStep = std::numeric_limits<float>::epsilon();

double farthest(const osg::BoundingBoxd& bounds) {
    double most = 0.0;
    for (int axis = 0; axis < 3; ++axis)
        most = std::max({most, std::abs(bounds._min[axis]), std::abs(bounds._max[axis])});
    return most;
}

class Drawn : public osg::NodeVisitor {
  public:
    Drawn() : osg::NodeVisitor(TRAVERSE_ALL_CHILDREN) { setNodeMaskOverride(~0u); }
    void apply(osg::Geode& geode) override { geodes.insert(&geode); }
    void apply(osg::Group& group) override {
        // A plain group of faces moves them as one.
        const bool plain = std::string_view(group.className()) == "Group";
        bool whole = plain && group.getNumChildren() > 1;
        for (unsigned int i = 0; whole && i < group.getNumChildren(); ++i)
            whole = group.getChild(i)->asGeode() && group.getChild(i)->getNumParents() == 1;
        if (whole)
            groups.insert(&group);
        else
            traverse(group);
    }
    std::set<osg::Geode*> geodes;
    std::set<osg::Group*> groups; ///< whose children are such Geodes and nothing else
};

class LocalBounds : public osg::NodeVisitor {
  public:
    LocalBounds() : osg::NodeVisitor(TRAVERSE_ALL_CHILDREN) { setNodeMaskOverride(~0u); }
    void apply(osg::Drawable& drawable) override {
        const auto* geometry = drawable.asGeometry();
        const auto* places =
            geometry ? dynamic_cast<const osg::Vec3Array*>(geometry->getVertexArray()) : nullptr;
        if (!places)
            return;
        for (const osg::Vec3& place : *places)
            bounds.expandBy(osg::Vec3d(place));
    }
    osg::BoundingBoxd bounds;
};

} // namespace

std::optional<osg::Vec3d> farOriginOf(const osg::BoundingBoxd& bounds) {
    // A fifth of the 1e-5 that a shape may lose.
    constexpr double mayLose = 2e-6;
    if (!bounds.valid() ||
        farthest(bounds) * floatStep <= mayLose * (bounds._max - bounds._min).length())
        return std::nullopt;
    const osg::Vec3d middle = (bounds._min + bounds._max) * 0.5;
    const osg::Vec3d origin(std::round(middle.x()), std::round(middle.y()), std::round(middle.z()));
    return origin == osg::Vec3d() ? std::nullopt : std::optional(origin);
}

void moveBack(osg::Node& graph, const osg::Vec3d& origin) {
    Drawn drawn;
    graph.accept(drawn);
    const osg::Matrixd back = osg::Matrixd::translate(origin);
    for (osg::Geode* geode : drawn.geodes) {
        const osg::ref_ptr<osg::MatrixTransform> moved = new osg::MatrixTransform(back);
        const osg::Node::ParentList parents = geode->getParents();
        moved->addChild(geode);
        for (osg::Group* parent : parents)
            parent->replaceChild(geode, moved);
    }
    for (osg::Group* group : drawn.groups) {
        const osg::ref_ptr<osg::MatrixTransform> moved = new osg::MatrixTransform(back);
        for (unsigned int i = 0; i < group->getNumChildren(); ++i)
            moved->addChild(group->getChild(i));
        group->removeChildren(0, group->getNumChildren());
        group->addChild(moved);
    }
}

std::optional<std::string> remarkOfRounding(osg::Node& graph) {
    LocalBounds local;
    graph.accept(local);
    if (!local.bounds.valid())
        return std::nullopt;
    const double far = farthest(local.bounds), step = far * floatStep;
    if (step <= 1e-5 * (local.bounds._max - local.bounds._min).length())
        return std::nullopt;
    return "coordinates up to " + numberText(far) +
           " are read in single precision, which places vertices to " + numberText(step) +
           " only: the file's reader has no other";
}

} // namespace irsg
