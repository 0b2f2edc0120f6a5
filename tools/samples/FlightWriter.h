#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "tools/samples/ModelWriter.h"

namespace smat {

/// Writes OpenFlight 16.1: one group with one object that holds all faces and meshes, packed
/// colours, a vertex normal everywhere, metres.
class FlightWriter : public ModelWriter {
  public:
    explicit FlightWriter(const std::string& name);

    /// A flat face, counter-clockwise from its front.
    void addFace(const FlightSurface& surface, std::span<const FlightVertex> corners);
    /// A mesh over shared vertices; one pair of codes for all of it. A large one is written with
    /// continuation records.
    void addMesh(const FlightSurface& surface, std::span<const FlightVertex> vertices,
                 std::span<const FlightPrimitive> primitives) override;

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
