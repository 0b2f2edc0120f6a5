#include "irsg/core/Errors.h"
#include "irsg/render/rays/RayMesh.h"

// Where Embree is missing: whoever asks for rays is told so.

namespace irsg {

struct RayMesh::Impl {};

bool areRaysBuilt() {
    return false;
}
std::string raysDescription() {
    return "";
}
std::string whyNoRays() {
    return "this build has no rays (it was configured with SMAT_BUILD_RAYS=OFF or without Embree "
           "3)";
}

RayMesh::RayMesh(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
RayMesh::~RayMesh() = default;

std::shared_ptr<const RayMesh> RayMesh::of(std::shared_ptr<const Mesh>) {
    throw InputError(
        {"settings", "render.engine", whyNoRays(), "opengl, or a build with Embree 3"});
}

std::size_t RayMesh::facets() const {
    return 0;
}
std::size_t RayMesh::pieces() const {
    return 0;
}
std::size_t RayMesh::facetsOf(std::size_t) const {
    return 0;
}
RayMesh::Corners RayMesh::cornersOf(std::size_t) const {
    return {};
}
RayMesh::Facet RayMesh::facet(std::size_t, unsigned) const {
    return {};
}
bool RayMesh::touch(const RayHit&, const RayHit&) const {
    return false;
}
bool RayMesh::meet(const Ray&, const PieceUses&, double, RayHit&, std::vector<RayHit>&) const {
    return false;
}
double RayMesh::rounding_m() const {
    return 0.0;
}
double RayMesh::bulge_m(std::size_t, unsigned, bool) const {
    return -1.0;
}
RayHit RayMesh::onPlaneOf(const RayHit& hit, const Ray&) const {
    return hit;
}
std::optional<RayHit> RayMesh::seenAt(const Ray&, const Distance&, const PieceUses&,
                                      const std::function<bool(int)>&) const {
    return std::nullopt;
}
void RayMesh::findCloseSheets() const {}
bool RayMesh::standsAlone(int, unsigned, double) const {
    return true;
}
bool RayMesh::again(const Ray&, int, unsigned, const PieceUse&, double, double, RayHit&) const {
    return false;
}
bool RayMesh::letsPass(const Ray&, const PieceUses&, const RayHit*, std::vector<int>&) const {
    return true;
}
Vec3 RayMesh::lifted(const RayHit& hit, const Ray& ray) const {
    return ray.origin_m + ray.direction * hit.distance_m;
}
Vec3 RayMesh::normal(const RayHit&) const {
    return {0, 0, 1};
}
Vec3 RayMesh::planeNormal(const RayHit&) const {
    return {0, 0, 1};
}

} // namespace irsg
