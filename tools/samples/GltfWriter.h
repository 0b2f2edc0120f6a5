#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "tools/samples/ModelWriter.h"

namespace smat {

/// Writes glTF 2.0, one file with its buffer in it, as an artist's program does it: y up, the nose
/// along z, a mesh for each surface, materials with names, no infrared codes. Each mesh is an
/// object of its own, named with object().
class GltfWriter : public ModelWriter {
  public:
    /// `unit_m` is what one unit of the file is to be. glTF knows metres alone; many files do not.
    GltfWriter(std::string generator, double unit_m);

    /// Meshes that follow belong to this object.
    void object(const std::string& name) { object_ = name; }
    void addMesh(const FlightSurface& surface, std::span<const FlightVertex> vertices,
                 std::span<const FlightPrimitive> primitives) override;

    std::string text() const;
    /// Throws InputError for a place that cannot be written.
    void save(const std::filesystem::path& file) const;

  private:
    struct Part {
        std::vector<float> positions, normals;
        std::vector<std::uint32_t> triangles;
    };
    struct Material {
        FlightSurface surface;
        std::size_t number = 0;
    };

    std::string generator_;
    double unit_m_;
    std::string object_ = "model";
    std::vector<FlightSurface> materials_;
    std::vector<std::string> objects_;                          ///< in their order
    std::map<std::pair<std::string, std::size_t>, Part> parts_; ///< by object and material
};

} // namespace smat
