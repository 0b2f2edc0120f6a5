#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "irsg/geometry/reading/ModelValues.h"

namespace irsg {

/// One Face or Mesh record as the file has it.
struct FlightFace {
    std::size_t offset = 0; ///< of the record, bytes
    std::string id;         ///< the long ID where there is one; not unique
    IrCodes codes;
    bool mesh = false;
    bool hidden = false;
    /// 0 solid, back faces culled; 1 solid, two-sided; 2, 3 wire; 4 surround; 8 to 10 light points.
    int drawType = 0;
    int vertices = 0; ///< in its vertex lists, or in the mesh's vertex pool
    /// Every vertex has a normal of its own.
    bool normals = false;
};

/// A reference to another file.
struct FlightExternal {
    std::size_t offset = 0;
    std::string written;        ///< as the record has it
    std::filesystem::path file; ///< where it was found
    bool givesColours = false;  ///< the referring file's colour palette replaces the other one
    double placements = 0;      ///< how often instances place it
};

/// What is to be done with a record when the file is handed to OpenSceneGraph's plug-in.
enum class FlightTreatment {
    keep,
    drop,       ///< nothing that geometry or codes depend on, and a risk to read
    appearance, ///< kept for the visible display only: textures and materials
    asGroup     ///< a node the plug-in does not know or draws as lights: a plain group with its
                ///< children
};

/// A validated file.
struct FlightFile {
    std::filesystem::path path;
    int version = 0; ///< 14, or 1420 to 1640
    double unit_m = 1.0;
    std::vector<FlightFace> faces;
    std::vector<FlightExternal> externals;
    std::vector<std::string> pictures; ///< that palettes name, as written
    std::vector<std::string> remarks;  ///< what is read but not honoured
    double placedFaces = 0;            ///< with every instance, external references not included
    int height = 0;                    ///< levels from the header to the deepest node
    std::array<double, 3> least{1e300, 1e300, 1e300}, most{-1e300, -1e300, -1e300}; ///< positions

    /// The bytes for the plug-in. For the infrared picture without records that only the visible
    /// display needs, and with the light mode of each face set so that its normals are kept exactly
    /// where all its vertices have one. For the visible display as the file has it.
    enum class Purpose { infrared, visible };
    std::string stream(Purpose purpose) const;
    /// Where its positions are counted from in that stream, in the unit of the file: not from zero
    /// where single precision, which is all the plug-in has, would spoil their shape.
    std::array<double, 3> origin() const;

    std::string bytes; ///< of the whole file
    struct Step {      ///< one record of the stream
        std::size_t offset = 0, length = 0;
        FlightTreatment treatment = FlightTreatment::keep;
        std::size_t lightModeOffset = 0; ///< 0 where there is none
        std::uint8_t lightMode = 0;      ///< for the infrared picture
        std::string replacement; ///< stands for the record's own bytes where it is not empty
    };
    std::vector<Step> steps;
};

} // namespace irsg
