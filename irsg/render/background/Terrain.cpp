#include "irsg/render/background/Terrain.h"

#include <utility>

#include "irsg/geometry/conversion/ModelLoader.h"
#include "irsg/geometry/view/CameraFrame.h"
#include "irsg/render/sampling/SurfaceScene.h"

namespace irsg {

Terrain::Terrain(const std::string& name, TexturedMesh shown, const Vec3& position_m)
    : name_(name), shown_(std::move(shown)), pose_{position_m + shown_.middle_m, {}} {}

std::shared_ptr<const Terrain> Terrain::load(const std::filesystem::path& file,
                                             const Vec3& position_m) {
    LoadedGraph loaded = loadGraph(file, LoadPurpose::visible);
    TexturedMesh shown = texturedMesh(loaded, file.parent_path(), file.string());
    shown.remarks.insert(shown.remarks.begin(), loaded.remarks.begin(), loaded.remarks.end());
    return std::shared_ptr<const Terrain>(
        new Terrain(file.filename().string(), std::move(shown), position_m));
}

std::shared_ptr<const Terrain> Terrain::ofGraph(const LoadedGraph& graph, const std::string& name,
                                                const Vec3& position_m) {
    return std::shared_ptr<const Terrain>(
        new Terrain(name, texturedMesh(graph, {}, name), position_m));
}

SurfaceBody Terrain::bodyFor(const CameraFrame& camera, std::shared_ptr<const RayMesh> rays) const {
    return {-1, shown_.mesh, std::move(rays), camera.eyeFromModel(pose_)};
}

} // namespace irsg
