#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "irsg/scene/model/Model.h"

namespace smat {

/// A vertex of a model to be written, m.
struct FlightVertex {
    irsg::Vec3 position;
    irsg::Vec3 normal;
};

/// A colour for the eye.
struct Look {
    std::uint8_t red = 200, green = 200, blue = 200;
};

/// How the faces and meshes that follow look to the eye and to the sensor.
struct FlightSurface {
    std::string name; ///< at most 7 characters
    irsg::IrCodes codes;
    bool twoSided = false;
    Look look = {};
};

/// A run of triangles over the vertices of a mesh.
struct FlightPrimitive {
    enum class Kind : std::int16_t { strip = 1, fan = 2 };
    Kind kind = Kind::strip;
    std::vector<std::uint32_t> indices;
};

/// Writes OpenFlight 16.1: one group with one object that holds all faces and meshes, packed
/// colours, a vertex normal everywhere, metres.
class FlightWriter {
  public:
    explicit FlightWriter(const std::string& name);

    /// A flat face, counter-clockwise from its front.
    void addFace(const FlightSurface& surface, std::span<const FlightVertex> corners);
    /// A mesh over shared vertices; one pair of codes for all of it. A large one is written with
    /// continuation records.
    void addMesh(const FlightSurface& surface, std::span<const FlightVertex> vertices,
                 std::span<const FlightPrimitive> primitives);

    /// The whole file.
    std::string bytes() const;
    /// Throws InputError for a place that cannot be written.
    void save(const std::filesystem::path& file) const;

  private:
    std::uint32_t paletteOffset(const FlightVertex& vertex);

    std::string name_;
    std::string palette_;  ///< vertex records
    std::string geometry_; ///< face and mesh records
    std::map<std::string, std::uint32_t> known_;
};

} // namespace smat
