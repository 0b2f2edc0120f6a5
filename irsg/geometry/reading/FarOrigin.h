#pragma once

#include <optional>
#include <string>

#include <osg/BoundingBox>
#include <osg/Node>
#include <osg/Vec3d>

namespace irsg {

/// Where positions of these bounds are to be counted from, so that what is left of them in single
/// precision keeps its shape: a whole number near their middle, or nothing where they lie so close
/// to zero that nothing is gained.
std::optional<osg::Vec3d> farOriginOf(const osg::BoundingBoxd& bounds);

/// Puts a translation above everything that is drawn in a graph, below all its other
/// transformations: positions that an origin was taken from are where they were. What is used in
/// several places stays one.
void moveBack(osg::Node& graph, const osg::Vec3d& origin);

/// A remark where positions in single precision lie so far from the origin of their part that its
/// shape suffers: their reader had no other numbers.
std::optional<std::string> remarkOfRounding(osg::Node& graph);

} // namespace irsg
