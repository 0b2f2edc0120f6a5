#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <nlohmann/json.hpp>
#include <osg/Vec3d>

namespace irsg::test {

/// A scene of glTF that grows call by call, with its numbers in one buffer.
class GltfWriter {
  public:
    GltfWriter();

    /// An accessor of positions or of indices of 1, 2 or 4 bytes; its number.
    std::size_t positions(const std::vector<osg::Vec3d>& places);
    std::size_t indices(const std::vector<unsigned int>& numbers, int bytes = 2);
    /// A mesh with one list of faces: what a primitive has in glTF.
    std::size_t mesh(const std::string& name, nlohmann::json primitive);
    /// A node below another one, or in the scene.
    std::size_t node(nlohmann::json node, int below = -1);
    std::size_t material(nlohmann::json material);

    /// A text that holds its buffer, or one whose buffer lies in a file of this name.
    std::string text(const std::string& buffer = "") const;
    std::string binary() const;
    const std::string& buffer() const { return buffer_; }

    nlohmann::json json;

  private:
    std::size_t accessor(const std::string& bytes, int type, const char* shape, std::size_t count);
    std::string buffer_;
};

/// A box with 8 corners and 12 triangles, its least corner in the origin.
std::vector<osg::Vec3d> boxCorners(double x, double y, double z);
const std::vector<unsigned int>& boxTriangles();
/// A hull of 1 x 2 x 3 in red, and two engines that share a mesh in blue, below a node that is
/// turned: 22 + 2 * 6 m^2.
GltfWriter smallAircraft();

std::string base64(const std::string& bytes);

/// A record of an .fbx, as text or binary.
struct FbxRecord {
    using Value = std::variant<std::int32_t, std::int64_t, double, std::string,
                               std::vector<std::int32_t>, std::vector<double>>;
    std::string name;
    std::vector<Value> values;
    std::vector<FbxRecord> records;
};
struct FbxWriter {
    double unit_cm = 1.0;
    int upAxis = 1, upSign = 1;
    osg::Vec3d translation;
    /// A mesh of these polygons.
    std::vector<osg::Vec3d> corners;
    std::vector<std::vector<std::int32_t>> polygons;

    std::string text() const;
    std::string binary() const;

  private:
    std::vector<FbxRecord> records(bool binary) const;
};

/// A .dae of one mesh that is placed as often as said, 10 units apart along x.
struct ColladaWriter {
    std::string unit = "<unit name=\"inch\" meter=\"0.0254\"/>";
    std::string up = "<up_axis>Z_UP</up_axis>";
    std::vector<osg::Vec3d> corners;
    std::vector<std::vector<std::int32_t>> polygons;
    int copies = 1;

    std::string text() const;
};

/// Six corners in the shape of an L, of 3 m^2, in the plane z = 0, and the polygon of them.
std::vector<osg::Vec3d> cornersOfL();

} // namespace irsg::test
