#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "irsg/geometry/conversion/TexturedMesh.h"
#include "irsg/geometry/view/Pose.h"

namespace irsg {

class CameraFrame;
class RayMesh;
struct SurfaceBody;

/// A textured model that stands fixed in the world (F31): what it shows is the red channel of its
/// textures as linear numbers. Any format of OpenSceneGraph's; textures are those of unit 0, read
/// as TextureImage reads them. Both sides of its faces are seen and all of it is opaque. Faces
/// without a texture add nothing and are reported.
class Terrain {
  public:
    /// `position_m`: where the origin of the file stands; its axes are those of the world (x east,
    /// y north, z up). Throws InputError for a file that is missing, unreadable or without faces,
    /// for a texture that cannot be read and for coordinates that are not finite.
    static std::shared_ptr<const Terrain> load(const std::filesystem::path& file,
                                               const Vec3& position_m = {});
    /// Of a graph in memory.
    static std::shared_ptr<const Terrain> ofGraph(const LoadedGraph& graph, const std::string& name,
                                                  const Vec3& position_m = {});

    const std::string& name() const { return name_; }
    /// Of the geometry in its own axes, which are at the middle of the model.
    const Pose& pose() const { return pose_; }
    const BoundingBox& bounds() const { return shown_.mesh->bounds; }
    const std::vector<std::string>& remarks() const { return shown_.remarks; }

    /// Geometry and textures.
    const TexturedMesh& shown() const { return shown_; }
    /// What hides the objects of a frame; `rays`: of its mesh, or null for OpenGL.
    SurfaceBody bodyFor(const CameraFrame& camera, std::shared_ptr<const RayMesh> rays) const;

  private:
    Terrain(const std::string& name, TexturedMesh shown, const Vec3& position_m);

    std::string name_;
    TexturedMesh shown_;
    Pose pose_;
};

} // namespace irsg
