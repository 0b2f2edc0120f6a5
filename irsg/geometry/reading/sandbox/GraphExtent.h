#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <osg/Node>

namespace irsg {

/// Deeper graphs are refused: whoever walks one needs room for each level.
constexpr int mostLevels = 1000;

/// How much a graph becomes once every copy of its parts is counted. A file of some kilobytes can
/// name a group of two groups of two groups and so on, which no computer can walk to its end.
class GraphExtent {
  public:
    /// `name` is used in messages.
    explicit GraphExtent(const std::string& name) : name_(name) {}
    /// Adds a node above some that were added before, by their numbers. Throws InputError where
    /// what it stands for is too much: more than 2 million polygons and nodes and more than 200
    /// times what there is, or more than 1000 levels.
    void add(osg::Node& node, const std::vector<std::uint32_t>& children);

  private:
    const std::string& name_;
    struct Part {
        double size = 0.0; ///< nodes and polygons with all copies
        int levels = 1;
    };
    std::vector<Part> parts_;
    double written_ = 0.0; ///< nodes and polygons, each once
};

} // namespace irsg
