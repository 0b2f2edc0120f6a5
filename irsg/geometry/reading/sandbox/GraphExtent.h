#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <osg/Node>

namespace irsg {

/// Deeper graphs are refused: whoever walks one needs room for each level.
constexpr int mostLevels = 1000;

/// How large a graph may be: what is deeper is refused, and what grows beyond this size and 200
/// times what is written.
struct GraphAllowance {
    int levels = mostLevels;
    double size = 2e6; ///< nodes and polygons with all copies
};
/// Of a model by its name: what we read ourselves is held to bounds of its own before there is a
/// graph (FlightLevels.h, DxfReader.cpp), and instances of 20 million faces are sound.
GraphAllowance allowanceOf(const std::string& name);

/// How much a graph becomes once every copy of its parts is counted. A file of some kilobytes can
/// name a group of two groups of two groups and so on, which no computer can walk to its end.
class GraphExtent {
  public:
    /// `name` is used in messages.
    explicit GraphExtent(const std::string& name) : name_(name), allowed_(allowanceOf(name)) {}
    /// Adds a node above some that were added before, by their numbers. Throws InputError where
    /// what it stands for is more than allowanceOf() its name.
    void add(osg::Node& node, const std::vector<std::uint32_t>& children);

  private:
    const std::string& name_;
    GraphAllowance allowed_;
    struct Part {
        double size = 0.0; ///< nodes and polygons with all copies
        int levels = 1;
    };
    std::vector<Part> parts_;
    double written_ = 0.0; ///< nodes and polygons, each once
};

} // namespace irsg
