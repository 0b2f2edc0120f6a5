#include "irsg/geometry/reading/sandbox/GraphExtent.h"

#include <algorithm>

#include <osg/Geometry>

#include "irsg/core/Errors.h"

namespace irsg {

namespace {

constexpr double alwaysAllowed = 2e6, mostCopies = 200.0;

double ownSize(osg::Node& node) {
    double size = 1.0;
    if (const osg::Geometry* geometry = node.asGeometry())
        for (unsigned int i = 0; i < geometry->getNumPrimitiveSets(); ++i)
            size += geometry->getPrimitiveSet(i)->getNumPrimitives();
    return size;
}

} // namespace

void GraphExtent::add(osg::Node& node, const std::vector<std::uint32_t>& children) {
    Part part;
    part.size = ownSize(node);
    written_ += part.size;
    for (const auto child : children) {
        part.size += parts_.at(child).size;
        part.levels = std::max(part.levels, parts_.at(child).levels + 1);
    }
    if (part.levels > mostLevels + 1)
        throw InputError({name_, "",
                          "a graph of more than " + std::to_string(mostLevels) + " levels",
                          "a model in fewer levels"});
    if (part.size > std::max(alwaysAllowed, mostCopies * written_))
        throw InputError({name_, "node '" + node.getName() + "'",
                          "copies of parts that make " + numberText(part.size) +
                              " nodes and polygons of " + numberText(written_),
                          "at most 2 million, or 200 times what is written"});
    parts_.push_back(part);
}

} // namespace irsg
