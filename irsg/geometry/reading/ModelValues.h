#pragma once

#include <compare>
#include <optional>
#include <string>
#include <vector>

#include "irsg/geometry/view/Vec3.h"

namespace irsg {

/// The pair of codes a face carries.
struct IrCodes {
    int temperature = 0; ///< IRColor, OpenFlight IR colour code
    int material = 0;    ///< IRMaterial, OpenFlight IR material code

    auto operator<=>(const IrCodes&) const = default;
};

/// A direction along an axis of a file.
enum class ModelAxis { plusX, minusX, plusY, minusY, plusZ, minusZ };
/// "+x" and so on, in the order of ModelAxis.
const std::vector<std::string>& modelAxisNames();

/// Which point of a file becomes the origin of the model.
struct ModelOrigin {
    enum class At {
        file,   ///< its own
        centre, ///< of the bounding box
        base,   ///< below the centre, at the lowest point
        point
    };
    At at = At::file;
    Vec3 point = {}; ///< of At::point, in the axes and the unit of the file
    auto operator<=>(const ModelOrigin&) const = default;
};

/// How the axes and the unit of a file become those of this program: x starboard, y nose, z up, m.
/// What is not set is as the file states it or its format usually is (FileAxes), or else: up +z;
/// nose +y, and +z where up is +y or -y; 1 m; the file's origin, unless it lies so far off that
/// single precision would bend the shape (then the centre, with a remark).
struct ModelPlacing {
    std::optional<ModelAxis> up = {};   ///< what of the file points up
    std::optional<ModelAxis> nose = {}; ///< what of the file points forward
    std::optional<double> unit_m = {};  ///< what one unit of the file is, m: 1e-6 to 1e6
    std::optional<ModelOrigin> origin = {};
    auto operator<=>(const ModelPlacing&) const = default;
};

/// What of a model carries one pair of codes.
struct CodeUse {
    /// OpenFlight: Face and Mesh records, each once however often it is placed, lines and hidden
    /// faces included. Other files: polygons as they are drawn.
    int faces = 0;
    /// Of what is drawn, with every copy; 0 where there are only lines or hidden faces.
    double area_m2 = 0.0;
    bool operator==(const CodeUse&) const = default;
};

/// Faces of different codes that lie in one plane and cover each other there. Those that come first
/// in the file are drawn.
struct SharedPlane {
    IrCodes drawn;  ///< of those that come first
    IrCodes hidden; ///< of the others
    int faces = 0;  ///< hidden ones, whole or in part
    double area_m2 = 0.0;
    bool operator==(const SharedPlane&) const = default;
};
/// A sentence about it.
std::string toText(const SharedPlane& shared);

struct ModelOptions {
    ModelPlacing placing = {};
    bool forceTwoSided = false; ///< ignore draw type 0 (backface culling)
    /// What the alpha of a face's texture leaves out is no part of the face (TextureCut.h).
    bool cutsTextureAlpha = false;
    auto operator<=>(const ModelOptions&) const = default;
};

} // namespace irsg
