#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include "irsg/scene/model/FlightScanner.h"

namespace irsg {

/// The walk of scanFlightBytes over the records of one file. Knows what the stock plug-in follows
/// without looking, and refuses what would lead it astray.
class FlightValidator {
  public:
    /// `file.bytes` must be set and stay where they are.
    FlightValidator(FlightFile& file, bool coloursGiven);
    /// Fills the file's faces, externals, remarks and steps; throws InputError with every
    /// diagnostic.
    void run();

  private:
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
        std::optional<std::uint32_t> poolSize; ///< of a mesh
        std::size_t step = 0;
        std::size_t children = 0, childLimit = 0; ///< of a switch; 0 is no limit
        int number = 0;                           ///< of an instance definition
        int height = 1;
        Placements placements;
    };
    struct Instance {
        Placements placements;
        int height = 0;
    };

    void visit(const FlightRecord& record);
    bool visitControl(const FlightRecord& record);
    bool visitPalette(const FlightRecord& record);
    bool visitAncillary(const FlightRecord& record);
    bool visitGeometry(const FlightRecord& record);
    bool visitNode(const FlightRecord& record);

    void header(const FlightRecord& record);
    void push(const FlightRecord& record);
    void pop(const FlightRecord& record);
    void vertexPalette(const FlightRecord& record);
    void paletteVertex(const FlightRecord& record);
    void face(const FlightRecord& record);
    void vertexList(const FlightRecord& record);
    void localVertexPool(const FlightRecord& record);
    void meshPrimitive(const FlightRecord& record);
    void switchNode(const FlightRecord& record);
    void instance(const FlightRecord& record);
    void external(const FlightRecord& record);
    void matrix(const FlightRecord& record);
    void replicate(const FlightRecord& record);

    /// Opens a node below the present level and closes the one before it.
    Node& open(const FlightRecord& record, FlightTreatment treatment = FlightTreatment::keep);
    void close(Node node);
    void keep(const FlightRecord& record, FlightTreatment treatment = FlightTreatment::keep);
    bool atLeast(const FlightRecord& record, std::size_t size);
    void coordinate(const FlightRecord& record, std::size_t at);
    void finite(const FlightRecord& record, std::size_t at, std::size_t count);
    void offend(std::size_t offset, const std::string& value, const std::string& expected);
    void checkPaletteEnd(std::size_t at);
    void remarkOnce(const std::string& key, const std::string& text);

    FlightFile& file_;
    std::vector<Diagnostic> diagnostics_;
    std::vector<Node> levels_;    ///< nodes whose children are being read
    std::optional<Node> current_; ///< the node read last at the present level
    bool closed_ = false;         ///< the first level has been closed
    int extensionDepth_ = 0;
    bool colours_;
    bool coloursGiven_;

    bool hasPalette_ = false;
    std::size_t paletteStart_ = 0, paletteEnd_ = 0;
    bool inPalette_ = false;
    std::unordered_map<std::uint32_t, bool> vertices_; ///< offset in the palette, has a normal

    std::map<int, Instance> instances_;
    std::set<std::string> remarked_;
    int billboards_ = 0, emptyFaces_ = 0;
};

} // namespace irsg
