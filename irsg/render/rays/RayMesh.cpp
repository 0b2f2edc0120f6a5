#include "irsg/render/rays/RayMeshImpl.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "irsg/core/Errors.h"
#include "irsg/render/rays/RayVectors.h"

namespace irsg {

namespace {

/// One device a process. Trees are built by one thread: what a ray meets first where facets touch
/// follows from their order.
RTCDevice device() {
    static const RTCDevice one = rtcNewDevice("threads=1,set_affinity=0");
    if (!one)
        throw InputError({"rays", "Embree", "no device", "a processor with SSE 2"});
    return one;
}

} // namespace

bool areRaysBuilt() {
    return true;
}
std::string raysDescription() {
    return "Embree " RTC_VERSION_STRING;
}
std::string whyNoRays() {
    return "";
}

RayMesh::Impl::~Impl() {
    if (scene)
        rtcReleaseScene(scene);
}

RayMesh::Impl::Impl(std::shared_ptr<const Mesh> of) : mesh(std::move(of)), facets(mesh->facets()) {
    for (const Mesh::Part& part : mesh->parts) {
        std::vector<Float3>& copy = padded.emplace_back();
        if (part.vertices.capacity() > part.vertices.size())
            continue;
        copy.reserve(part.vertices.size() + 1);
        copy = part.vertices;
        copy.emplace_back();
    }
    for (const Mesh::Piece& piece : mesh->pieces)
        pieces.push_back({&mesh->partOf(piece), mesh->trianglesOf(piece)});
}

void RayMesh::Impl::attach(std::size_t number) {
    const TracedPiece& piece = pieces[number];
    if (piece.triangles.empty())
        return;
    const std::vector<Float3>& copy = padded[mesh->pieces[number].part];
    const Float3* places = copy.empty() ? piece.part->vertices.data() : copy.data();
    RTCGeometry geometry = rtcNewGeometry(device(), RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, places, 0,
                               sizeof(Float3), piece.part->vertices.size());
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                               piece.triangles.data(), 0, 3 * sizeof(unsigned),
                               piece.triangles.size() / 3);
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(scene, geometry, static_cast<unsigned>(number));
    rtcReleaseGeometry(geometry);
}

void RayMesh::Impl::commit() {
    scene = rtcNewScene(device());
    // Robust: no ray slips through an edge between two facets.
    rtcSetSceneFlags(scene, static_cast<RTCSceneFlags>(RTC_SCENE_FLAG_ROBUST |
                                                       RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION));
    for (std::size_t i = 0; i < pieces.size(); ++i)
        attach(i);
    rtcCommitScene(scene);
    if (const RTCError error = rtcGetDeviceError(device()); error != RTC_ERROR_NONE)
        throw InputError({"rays", "Embree", "error " + std::to_string(error),
                          "memory for a tree of " + std::to_string(facets) + " facets"});
    if (facets == 0)
        return;
    RTCBounds box;
    rtcGetSceneBounds(scene, &box);
    const Vec3 least = toVec3({box.lower_x, box.lower_y, box.lower_z}),
               most = toVec3({box.upper_x, box.upper_y, box.upper_z});
    constexpr double digits = 4e-7;
    rounding_m =
        digits * std::max({plainLength(least), plainLength(most), plainLength(most - least)});
    low = {least.x - rounding_m, least.y - rounding_m, least.z - rounding_m};
    high = {most.x + rounding_m, most.y + rounding_m, most.z + rounding_m};
}

bool RayMesh::Impl::clip(const Ray& ray, double& from_m, double& to_m) const {
    const std::array<double, 3> origin{ray.origin_m.x, ray.origin_m.y, ray.origin_m.z};
    const std::array<double, 3> along{ray.direction.x, ray.direction.y, ray.direction.z};
    from_m = ray.from_m;
    to_m = ray.to_m;
    for (std::size_t i = 0; i < 3; ++i) {
        const double per = 1.0 / along[i];
        double enter = (low[i] - origin[i]) * per, leave = (high[i] - origin[i]) * per;
        if (enter > leave)
            std::swap(enter, leave);
        if (along[i] == 0.0) {
            if (origin[i] < low[i] || origin[i] > high[i])
                return false;
            continue;
        }
        from_m = std::max(from_m, enter);
        to_m = std::min(to_m, leave);
    }
    return from_m <= to_m;
}

RayHit RayMesh::Impl::refined(const Ray& ray, const Candidate& candidate) const {
    const TracedPiece& piece = pieces[candidate.piece];
    const unsigned* corner = &piece.triangles[3 * static_cast<std::size_t>(candidate.facet)];
    const Vec3 a = piece.vertex(corner[0]);
    const Vec3 ab = piece.vertex(corner[1]) - a;
    const Vec3 ac = piece.vertex(corner[2]) - a;
    const Vec3 p = crossed(ray.direction, ac);
    const double determinant = product(ab, p);
    RayHit hit;
    hit.piece = static_cast<int>(candidate.piece);
    hit.facet = candidate.facet;
    hit.isFront = determinant > 0.0;
    const Vec3 s = ray.origin_m - a;
    const double per = determinant != 0.0 ? 1.0 / determinant : 0.0;
    const Vec3 q = crossed(s, ab);
    const double u = product(s, p) * per, v = product(ray.direction, q) * per;
    hit.distance_m = hit.order_m = product(ac, q) * per;
    hit.weights = {1.0 - u - v, u, v};
    return hit;
}

RTCRay RayMesh::Impl::rayFrom(const Ray& ray, double from_m, double to_m) const {
    const double skipped_m = std::max(0.0, from_m - rounding_m);
    const Vec3 origin = ray.origin_m + ray.direction * skipped_m;
    RTCRay along;
    along.org_x = static_cast<float>(origin.x);
    along.org_y = static_cast<float>(origin.y);
    along.org_z = static_cast<float>(origin.z);
    along.dir_x = static_cast<float>(ray.direction.x);
    along.dir_y = static_cast<float>(ray.direction.y);
    along.dir_z = static_cast<float>(ray.direction.z);
    along.tnear = static_cast<float>(std::max(0.0, from_m - skipped_m));
    along.tfar = static_cast<float>(to_m - skipped_m);
    along.time = 0.0f;
    along.mask = ~0u;
    along.id = 0;
    along.flags = 0;
    return along;
}

RayMesh::RayMesh(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
RayMesh::~RayMesh() = default;

std::shared_ptr<const RayMesh> RayMesh::of(std::shared_ptr<const Mesh> mesh) {
    auto impl = std::make_unique<Impl>(std::move(mesh));
    impl->commit();
    return std::shared_ptr<const RayMesh>(new RayMesh(std::move(impl)));
}

std::size_t RayMesh::facets() const {
    return impl_->facets;
}

std::size_t RayMesh::pieces() const {
    return impl_->pieces.size();
}

std::size_t RayMesh::facetsOf(std::size_t piece) const {
    return impl_->pieces[piece].triangles.size() / 3;
}

RayMesh::Corners RayMesh::cornersOf(std::size_t piece) const {
    const TracedPiece& traced = impl_->pieces[piece];
    return {traced.part->vertices.data(), traced.triangles.data()};
}

RayMesh::Facet RayMesh::facet(std::size_t piece, unsigned number) const {
    const TracedPiece& traced = impl_->pieces[piece];
    Facet found;
    found.arrays = traced.part;
    for (std::size_t i = 0; i < 3; ++i) {
        found.vertices[i] = traced.triangles[3 * static_cast<std::size_t>(number) + i];
        found.corners_m[i] = traced.vertex(found.vertices[i]);
    }
    return found;
}

bool RayMesh::touch(const RayHit& hit, const RayHit& other) const {
    const Facet one = facet(static_cast<std::size_t>(hit.piece), hit.facet);
    const Facet two = facet(static_cast<std::size_t>(other.piece), other.facet);
    return one.arrays == two.arrays && std::ranges::any_of(one.vertices, [&](unsigned vertex) {
               return std::ranges::find(two.vertices, vertex) != two.vertices.end();
           });
}

RayHit RayMesh::onPlaneOf(const RayHit& hit, const Ray& ray) const {
    return impl_->refined(ray, {static_cast<unsigned>(hit.piece), hit.facet});
}

Vec3 RayMesh::lifted(const RayHit& hit, const Ray& ray) const {
    const TracedPiece& piece = impl_->pieces[static_cast<std::size_t>(hit.piece)];
    const unsigned* corner = &piece.triangles[3 * static_cast<std::size_t>(hit.facet)];
    const double side = hit.isFront ? 1.0 : -1.0;
    const Vec3 place = ray.origin_m + ray.direction * hit.distance_m;
    Vec3 start = place + planeNormal(hit) * (side * 2.0 * impl_->rounding_m);
    for (std::size_t i = 0; i < 3 && !piece.part->normals.empty(); ++i) {
        const Vec3 normal = piece.normal(corner[i]) * side;
        const double below_m = std::min(product(place - piece.vertex(corner[i]), normal), 0.0);
        start = start - normal * (std::clamp(hit.weights[i], 0.0, 1.0) * below_m);
    }
    return start;
}

bool RayMesh::again(const Ray& ray, int piece, unsigned facet, const PieceUse& use,
                    double distance_m, double off_m, RayHit& hit) const {
    hit = impl_->refined(ray, {static_cast<unsigned>(piece), facet});
    return std::abs(hit.distance_m - distance_m) <= off_m && hit.weights[0] >= 0.0 &&
           hit.weights[1] >= 0.0 && hit.weights[2] >= 0.0 &&
           (hit.isFront || use.transparent || !use.cullsBackFaces);
}

double RayMesh::rounding_m() const {
    return impl_->rounding_m;
}

double RayMesh::bulge_m(std::size_t piece, unsigned number, bool isFront) const {
    const TracedPiece& traced = impl_->pieces[piece];
    if (traced.part->normals.empty())
        return 0.0;
    const unsigned* corner = &traced.triangles[3 * static_cast<std::size_t>(number)];
    const double side = isFront ? 1.0 : -1.0;
    const Vec3 plane = planeNormal({.piece = static_cast<int>(piece), .facet = number}) * side;
    double most_m = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3 normal = traced.normal(corner[i]) * side;
        double below_m = 0.0;
        for (std::size_t k = 0; k < 3; ++k)
            below_m =
                std::max(below_m, dot(traced.vertex(corner[i]) - traced.vertex(corner[k]), normal));
        if (below_m > 0.0 && dot(normal, plane) < 0.0)
            return -1.0;
        most_m = std::max(most_m, below_m * length(normal));
    }
    return most_m;
}

Vec3 RayMesh::normal(const RayHit& hit) const {
    const TracedPiece& piece = impl_->pieces[static_cast<std::size_t>(hit.piece)];
    if (piece.part->normals.empty())
        return planeNormal(hit);
    const unsigned* corner = &piece.triangles[3 * static_cast<std::size_t>(hit.facet)];
    Vec3 sum;
    for (std::size_t i = 0; i < 3; ++i)
        sum = sum + piece.normal(corner[i]) * hit.weights[i];
    return sum == Vec3{} ? planeNormal(hit) : normalized(sum);
}

Vec3 RayMesh::planeNormal(const RayHit& hit) const {
    const TracedPiece& piece = impl_->pieces[static_cast<std::size_t>(hit.piece)];
    const unsigned* corner = &piece.triangles[3 * static_cast<std::size_t>(hit.facet)];
    const Vec3 a = piece.vertex(corner[0]);
    const Vec3 normal = crossed(piece.vertex(corner[1]) - a, piece.vertex(corner[2]) - a);
    const double size = plainLength(normal);
    return size > 0.0 ? normal * (1.0 / size) : Vec3{0, 0, 1};
}

} // namespace irsg
