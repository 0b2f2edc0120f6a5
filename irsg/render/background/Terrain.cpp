#include "irsg/render/background/Terrain.h"

#include <osg/Node>

#include "irsg/geometry/conversion/ModelLoader.h"
#include "irsg/geometry/view/CameraFrame.h"
#include "irsg/render/background/TerrainCollector.h"
#include "irsg/render/background/TerrainImpl.h"
#include "irsg/render/sampling/SurfaceScene.h"

namespace irsg {

Terrain::Terrain(std::unique_ptr<Impl> parts) : impl_(std::move(parts)) {}
Terrain::~Terrain() = default;

std::shared_ptr<const Terrain> Terrain::load(const std::filesystem::path& file,
                                             const Vec3& position_m) {
    const LoadedGraph loaded = loadGraph(file, LoadPurpose::visible);
    auto parts = std::make_unique<Impl>();
    parts->name = file.filename().string();
    parts->remarks = loaded.remarks;
    TerrainCollector(file.parent_path(), file.string()).collect(*loaded.node, position_m, *parts);
    return std::shared_ptr<const Terrain>(new Terrain(std::move(parts)));
}

std::shared_ptr<const Terrain> Terrain::fromGraph(osg::Node& graph, const std::string& name,
                                                  const Vec3& position_m) {
    auto parts = std::make_unique<Impl>();
    parts->name = name;
    TerrainCollector({}, name).collect(graph, position_m, *parts);
    return std::shared_ptr<const Terrain>(new Terrain(std::move(parts)));
}

const std::string& Terrain::name() const {
    return impl_->name;
}
const Pose& Terrain::pose() const {
    return impl_->pose;
}
const BoundingBox& Terrain::bounds() const {
    return impl_->bounds;
}
const std::vector<std::string>& Terrain::remarks() const {
    return impl_->remarks;
}

std::vector<OccluderItem> Terrain::occluders(const CameraFrame& camera) const {
    std::vector<OccluderItem> items;
    const osg::Matrixd eyeFromLocal = camera.eyeFromModel(impl_->pose);
    for (const Impl::Piece& piece : impl_->pieces)
        items.push_back({piece.geometry.get(), eyeFromLocal});
    return items;
}

} // namespace irsg
