#include "irsg/geometry/reading/sandbox/GraphExtent.h"

#include <algorithm>

#include <osg/Geometry>

#include "irsg/core/Errors.h"
#include "irsg/geometry/reading/OpenableFiles.h"

namespace irsg {

namespace {

constexpr double mostCopies = 200.0;

double ownSize(osg::Node& node) {
    double size = 1.0;
    if (const osg::Geometry* geometry = node.asGeometry())
        for (unsigned int i = 0; i < geometry->getNumPrimitiveSets(); ++i)
            size += geometry->getPrimitiveSet(i)->getNumPrimitives();
    return size;
}

} // namespace

GraphAllowance allowanceOf(const std::string& name) {
    constexpr double boundedBefore = 2e8; // 20 million faces, each with some nodes
    switch (modelReaderOf(name)) {
    case FormatReader::flight:
        // A level of the file is up to three of the graph.
        return {4096, boundedBefore};
    case FormatReader::ours:
        return {mostLevels, boundedBefore};
    case FormatReader::plugin:
    case FormatReader::assimp:
        break;
    }
    return {};
}

void GraphExtent::add(osg::Node& node, const std::vector<std::uint32_t>& children) {
    Part part;
    part.size = ownSize(node);
    written_ += part.size;
    for (const auto child : children) {
        part.size += parts_.at(child).size;
        part.levels = std::max(part.levels, parts_.at(child).levels + 1);
    }
    if (part.levels > allowed_.levels + 1)
        throw InputError({name_, "",
                          "a graph of more than " + std::to_string(allowed_.levels) + " levels",
                          "a model in fewer levels"});
    if (part.size > std::max(allowed_.size, mostCopies * written_))
        throw InputError({name_, "node '" + node.getName() + "'",
                          "copies of parts that make " + numberText(part.size) +
                              " nodes and polygons of " + numberText(written_),
                          "at most " + numberText(allowed_.size / 1e6) +
                              " million, or 200 times what is written"});
    parts_.push_back(part);
}

} // namespace irsg
