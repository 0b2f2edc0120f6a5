#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "irsg/geometry/model/Model.h"
#include "irsg/geometry/view/Pose.h"

namespace osg {
class Node;
}

namespace irsg {

class CameraFrame;
struct OccluderItem;

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
    static std::shared_ptr<const Terrain> fromGraph(osg::Node& graph, const std::string& name,
                                                    const Vec3& position_m = {});
    ~Terrain();

    const std::string& name() const;
    /// Of the geometry in its own axes, which are at the middle of the model.
    const Pose& pose() const;
    const BoundingBox& bounds() const;
    const std::vector<std::string>& remarks() const;

    /// What hides the objects of a frame.
    std::vector<OccluderItem> occluders(const CameraFrame& camera) const;

    struct Impl;
    /// Geometry and textures, for drawing.
    const Impl& parts() const { return *impl_; }

  private:
    explicit Terrain(std::unique_ptr<Impl> parts);
    std::unique_ptr<Impl> impl_;
};

} // namespace irsg
