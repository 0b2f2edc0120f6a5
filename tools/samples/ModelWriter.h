#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "irsg/geometry/model/Model.h"

namespace smat {

/// A vertex of a model to be written, m.
struct FlightVertex {
    irsg::Vec3 position;
    irsg::Vec3 normal;
};

/// A colour for the eye, and the part of the light that passes it, 0 to 1.
struct Look {
    std::uint8_t red = 200, green = 200, blue = 200;
    double clear = 0.0;
};

/// How the faces and meshes that follow look to the eye and to the sensor.
struct FlightSurface {
    std::string name; ///< OpenFlight: at most 7 characters
    irsg::IrCodes codes = {};
    bool twoSided = false;
    Look look = {};
};

/// A run of triangles over the vertices of a mesh.
struct FlightPrimitive {
    enum class Kind : std::int16_t { strip = 1, fan = 2 };
    Kind kind = Kind::strip;
    std::vector<std::uint32_t> indices;
};

/// What takes the surfaces of a model, in its axes (x starboard, y nose, z up), m.
class ModelWriter {
  public:
    virtual ~ModelWriter() = default;
    /// A mesh over shared vertices, all of it of one surface.
    virtual void addMesh(const FlightSurface& surface, std::span<const FlightVertex> vertices,
                         std::span<const FlightPrimitive> primitives) = 0;
};

} // namespace smat
