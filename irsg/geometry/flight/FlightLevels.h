#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "irsg/geometry/flight/FlightLog.h"

namespace irsg {

/// A model has no more, each counted as often as it is placed.
inline constexpr double mostFaces = 20e6;

/// The nodes of an OpenFlight file as its records open and close them: levels, subfaces, instances,
/// and how often instances draw what is below a node.
class FlightLevels {
  public:
    /// How often faces (key -1) and external references (their index) are drawn below a node.
    using Placements = std::map<int, double>;
    struct Node {
        Node(std::uint16_t theOpcode, std::size_t theOffset)
            : opcode(theOpcode), offset(theOffset) {}
        std::uint16_t opcode;
        std::size_t offset;
        int face = -1; ///< index in file.faces of a face or mesh
        bool pushed = false;
        int subfaces = 0; ///< push subface records open among its children
        bool light = false;
        bool anonymous = false; ///< a level that no node opens: it belongs to the one above
        std::optional<std::uint32_t> poolSize; ///< of a mesh
        std::size_t step = 0;
        std::size_t children = 0, childLimit = 0; ///< of a switch; 0 is no limit
        int number = 0;                           ///< of an instance definition
        int height = 1;
        Placements placements;
    };

    explicit FlightLevels(FlightLog& log) : log_(log) {}

    /// Opens a node below the present level and closes the one before it.
    Node& open(const FlightRecord& record, FlightTreatment treatment = FlightTreatment::keep);
    void push(const FlightRecord& record);
    void pop(const FlightRecord& record);
    void pushSubface(const FlightRecord& record);
    void popSubface(const FlightRecord& record);
    /// A definition of an instance, or a reference to one.
    void instance(const FlightRecord& record);
    /// What was opened must have been closed at the end of the file.
    void finish(std::size_t end);

    /// The node read last at the present level; null where there is none.
    Node* current() { return current_ ? &*current_ : nullptr; }
    /// The node whose children are being read; null above the first level.
    Node* parent();

  private:
    struct Instance {
        Placements placements;
        int height = 0;
    };
    void close(Node node);
    void closeCurrent();

    FlightLog& log_;
    std::vector<Node> levels_; ///< nodes whose children are being read
    std::optional<Node> current_;
    std::map<int, Instance> instances_;
    int emptyFaces_ = 0;
    int anonymous_ = 0;
};

} // namespace irsg
