#include "irsg/render/rays/TileRays.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <utility>

#include "irsg/render/rays/TileSamples.h"

namespace irsg {

namespace {

Vec3 axisOf(const Matrix4& matrix, std::size_t row) {
    return {matrix(row, 0), matrix(row, 1), matrix(row, 2)};
}

/// Every piece of it stops rays, from both sides.
PieceUses opaqueUses(std::size_t pieces) {
    PieceUses uses(pieces);
    for (std::size_t i = 0; i < pieces; ++i)
        uses.set(i, {.isThere = true});
    return uses;
}

} // namespace

Vec3 TileRays::Body::toMesh(const Vec3& eyeDirection) const {
    return {product(x, eyeDirection), product(y, eyeDirection), product(z, eyeDirection)};
}
Vec3 TileRays::Body::toEye(const Vec3& meshDirection) const {
    return x * meshDirection.x + y * meshDirection.y + z * meshDirection.z;
}

TileRays::Body TileRays::bodyOf(const SurfaceBody& body, PieceUses uses, std::vector<int> rows) {
    // Row vectors times matrix: its rows are the axes of the model in eye space.
    Body own{body.entity,
             body.rays.get(),
             axisOf(body.eyeFromModel, 0),
             axisOf(body.eyeFromModel, 1),
             axisOf(body.eyeFromModel, 2),
             {},
             std::move(uses),
             std::move(rows)};
    own.eye_m = own.toMesh(axisOf(body.eyeFromModel, 3)) * -1.0;
    return own;
}

TileRays::TileRays(const SurfaceScene& scene, const SampleTile& tile)
    : scene_(scene),
      tile_(tile),
      directions_(scene.camera->sensor(), tile),
      sampleWidth_(sampleWidthOf(scene.camera->sensor(), tile)) {
    for (const SurfaceBody& body : scene.bodies) {
        PieceUses uses(body.rays->pieces());
        std::vector<int> rows(body.rays->pieces(), -1);
        for (const SurfaceItem& item : scene.items)
            if (&scene.bodyOf(item) == &body) {
                const Mesh::Part& part = scene.partOf(item);
                uses.set(item.piece, {true, item.transparent, part.culled, part.layer});
                rows[item.piece] = item.row;
            }
        bodies_.push_back(bodyOf(body, std::move(uses), std::move(rows)));
    }
    if (scene.terrain.rays)
        occluders_.push_back(bodyOf(scene.terrain, opaqueUses(scene.terrain.rays->pieces()), {}));
    for (const SurfaceBody& ground : scene.groundBefore)
        occluders_.push_back(bodyOf(ground, opaqueUses(ground.rays->pieces()), {}));
}

Ray TileRays::rayTo(const Body& body, const Vec3& eyeDirection, double from_m) {
    return {body.eye_m, body.toMesh(eyeDirection), from_m};
}

float TileRays::depthOf(double distance_m, const Vec3& eyeDirection) const {
    const DepthRange& range = scene_.depth;
    const double depth_m = -eyeDirection.z * distance_m;
    return static_cast<float>((range.far_m - depth_m) / (range.far_m - range.near_m));
}

void TileRays::fillFactors(const Met& met, const Vec3& eyeDirection, float* factors) const {
    const int row = met.body->rows[static_cast<std::size_t>(met.hit.piece)];
    const Vec3 normal = met.body->toEye(met.body->mesh->normal(met.hit));
    const SampleGeometry geometry{
        normal * (met.hit.isFront ? 1.0 : -1.0), eyeDirection * met.hit.distance_m,
        static_cast<double>(scene_.rows[static_cast<std::size_t>(row)].nAngleFactor),
        scene_.factors.directionsEye};
    for (const GeometryFactorFunction& function : scene_.factors.functions)
        *factors++ = static_cast<float>(function(geometry));
}

TileRays::Met TileRays::meet(const Vec3& eyeDirection, std::vector<Met>& layers) const {
    thread_local std::vector<RayHit> through;
    const double from_m = scene_.depth.near_m / -eyeDirection.z;
    Met opaque;
    layers.clear();
    for (const Body& body : bodies_) {
        RayHit hit;
        const bool isMet = body.mesh->meet(rayTo(body, eyeDirection, from_m), body.uses,
                                           sampleWidth_, hit, through);
        if (isMet && (!opaque.body || hit.order_m < opaque.hit.order_m))
            opaque = {&body, hit};
        for (const RayHit& layer : through)
            layers.push_back({&body, layer});
    }
    if (!opaque.body && layers.empty())
        return opaque;
    double hidden_m = opaque.body ? opaque.hit.order_m : std::numeric_limits<double>::infinity();
    for (const Body& body : occluders_) {
        RayHit hit;
        if (body.mesh->meet(rayTo(body, eyeDirection, 0.0), body.uses, 0.0, hit, through) &&
            hit.distance_m < hidden_m) {
            hidden_m = hit.distance_m;
            opaque.body = nullptr;
        }
    }
    std::erase_if(layers, [&](const Met& layer) { return layer.hit.order_m >= hidden_m; });
    return opaque;
}

std::vector<TileRays::Facet> TileRays::facetsAt(int column, int row) const {
    const Vec3 eyeDirection = directions_.at(column, row);
    std::vector<Met> met;
    Met last = meet(eyeDirection, met);
    std::ranges::stable_sort(met, {}, [](const Met& layer) { return layer.hit.order_m; });
    if (!last.body) {
        std::vector<RayHit> through;
        for (const Body& body : occluders_)
            if (body.mesh->meet(rayTo(body, eyeDirection, 0.0), body.uses, 0.0, last.hit, through))
                last.body = &body;
    }
    if (last.body)
        met.push_back(last);
    std::vector<Facet> facets;
    for (const Met& one : met)
        facets.push_back({one.body->entity, one.hit.piece, one.hit.facet});
    return facets;
}

void TileRays::traceRow(int row, int firstColumn, int lastColumn, GeometrySamples& samples,
                        std::vector<float>& fragments) const {
    thread_local std::vector<Met> layers;
    std::array<float, mostFactors + 1> factors{};
    for (int column = firstColumn; column < lastColumn; ++column) {
        const Vec3 eyeDirection = directions_.at(column, row);
        const Met opaque = meet(eyeDirection, layers);
        const std::size_t sample = indexOf(tile_, column, row);
        const auto rowOf = [](const Met& met) {
            return static_cast<float>(met.body->rows[static_cast<std::size_t>(met.hit.piece)] + 1);
        };
        for (const Met& layer : layers) {
            factors.fill(0.0f);
            fillFactors(layer, eyeDirection, factors.data());
            fragments.insert(fragments.end(),
                             {std::bit_cast<float>(static_cast<std::uint32_t>(sample)),
                              depthOf(layer.hit.order_m, eyeDirection), rowOf(layer),
                              static_cast<float>(layer.hit.distance_m)});
            fragments.insert(fragments.end(), factors.begin(),
                             factors.begin() +
                                 static_cast<std::ptrdiff_t>(samples.wordsPerFragment - 4));
        }
        if (!opaque.body)
            continue;
        factors.fill(0.0f);
        fillFactors(opaque, eyeDirection, factors.data());
        samples.opaque[4 * sample] = rowOf(opaque);
        std::copy_n(factors.begin(), 3, &samples.opaque[4 * sample + 1]);
        if (!samples.moreFactors.empty())
            std::copy_n(factors.begin() + 3, 4, &samples.moreFactors[4 * sample]);
        if (!samples.distances_m.empty())
            samples.distances_m[sample] = static_cast<float>(opaque.hit.distance_m);
    }
}

} // namespace irsg
