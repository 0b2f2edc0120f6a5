#pragma once

#include <compare>

namespace irsg {

/// The pair of codes a face carries.
struct IrCodes {
    int temperature = 0; ///< IRColor, OpenFlight IR colour code
    int material = 0;    ///< IRMaterial, OpenFlight IR material code

    auto operator<=>(const IrCodes&) const = default;
};

enum class NoseAxis { plusX, minusX, plusY, minusY };

/// What of a model carries one pair of codes.
struct CodeUse {
    /// OpenFlight: Face and Mesh records, each once however often it is placed, lines and hidden
    /// faces included. Other files: polygons as they are drawn.
    int faces = 0;
    /// Of what is drawn, with every copy; 0 where there are only lines or hidden faces.
    double area_m2 = 0.0;
    bool operator==(const CodeUse&) const = default;
};

struct ModelOptions {
    NoseAxis noseAxis = NoseAxis::plusY; ///< which axis of the file the nose points along
    bool forceTwoSided = false;          ///< ignore draw type 0 (backface culling)
};

} // namespace irsg
