#include "irsg/scene/EarthHorizon.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "irsg/render/rays/RayMesh.h"

namespace irsg {

namespace {

/// The lowest and the highest altitude of an entity's box.
std::pair<double, double> altitudesOf(const Entity& entity) {
    const BoundingBox box = entity.model->bounds();
    double low_m = std::numeric_limits<double>::infinity(), high_m = -low_m;
    for (unsigned i = 0; i < 8; ++i) {
        const double z_m =
            entity.pose
                .toWorld({(i & 1 ? box.max : box.min).x, (i & 2 ? box.max : box.min).y,
                          (i & 4 ? box.max : box.min).z})
                .z;
        low_m = std::min(low_m, z_m);
        high_m = std::max(high_m, z_m);
    }
    return {low_m, high_m};
}

void takeApparentDirection(const Environment& environment, const SpectralRange& range,
                           const Entity& entity, ObjectGeometry& object) {
    const auto viewAt = [&](double range_m) {
        AtmosphericPath path = object.path;
        path.range_m = std::max(range_m, std::abs(path.targetAltitude_m - path.sensorAltitude_m));
        return environment.targetView(path, range);
    };
    const TargetView view = viewAt(object.path.range_m);
    const auto [low_m, high_m] = altitudesOf(entity);
    object.hiddenBelow_m = {viewAt(object.nearest_m).hiddenBelow_m, view.hiddenBelow_m,
                            viewAt(object.farthest_m).hiddenBelow_m};
    object.hidden = object.hiddenBelow_m.back() <= low_m || object.hiddenBelow_m.back() <= 0.0
                        ? HiddenPart::none
                    : object.hiddenBelow_m.front() >= high_m ? HiddenPart::all
                                                             : HiddenPart::some;
    // What appears on the horizon stands at that altitude.
    AtmosphericPath seen = object.path;
    seen.targetAltitude_m = std::max(seen.targetAltitude_m, view.hiddenBelow_m);
    if (object.hidden == HiddenPart::all)
        object.path.targetAltitude_m = seen.targetAltitude_m;
    object.raised_rad = view.elevation_rad - flatTargetView(seen).elevation_rad;
    object.sight = steadied(
        LineOfSight{object.path.sensorAltitude_m, view.elevation_rad, object.path.azimuth_rad});
}

Mesh::Part quads(const std::vector<std::array<Vec3, 4>>& corners) {
    Mesh::Part part;
    for (const std::array<Vec3, 4>& quad : corners) {
        const auto first = static_cast<unsigned>(part.vertices.size());
        for (const Vec3& corner : quad) {
            part.vertices.push_back({static_cast<float>(corner.x), static_cast<float>(corner.y),
                                     static_cast<float>(corner.z)});
            part.bounds.include(corner);
        }
        for (const unsigned i : {0u, 1u, 2u, 0u, 2u, 3u})
            part.triangles.push_back(first + i);
    }
    part.polygons = static_cast<long>(corners.size());
    return part;
}

/// In axes whose y points away from the sensor and whose origin is the reference point.
Mesh meshBefore(const ObjectGeometry& object, double reference_m) {
    constexpr double wide = 3.0, deep = 100.0; // in reaches
    const double reach_m = object.farthest_m - object.path.range_m;
    const double x = wide * reach_m, y = reach_m * 1.001;
    const double near = object.hiddenBelow_m[0] - reference_m,
                 middle = object.hiddenBelow_m[1] - reference_m,
                 far = object.hiddenBelow_m[2] - reference_m, bottom = -deep * reach_m;
    return meshOf({quads({{{{-x, -y, bottom}, {x, -y, bottom}, {x, -y, near}, {-x, -y, near}}},
                          {{{-x, -y, near}, {x, -y, near}, {x, 0.0, middle}, {-x, 0.0, middle}}},
                          {{{-x, 0.0, middle}, {x, 0.0, middle}, {x, y, far}, {-x, y, far}}}})});
}

} // namespace

double hiddenByHorizon(const Entity& entity, const ObjectGeometry& object) {
    if (object.hidden != HiddenPart::some)
        return object.hidden == HiddenPart::all ? 1.0 : 0.0;
    const auto [low_m, high_m] = altitudesOf(entity);
    return std::clamp((object.hiddenBelow_m[1] - low_m) / std::max(high_m - low_m, 1e-9), 0.0, 1.0);
}

void takeApparentDirections(FrameRequest& request, std::vector<ObjectGeometry>& geometry) {
    const Scene& scene = request.scene;
    const Vec3 forward = request.view.viewpoint.forward();
    double nearest = -std::numeric_limits<double>::infinity();
    for (std::size_t e = 0; e < geometry.size(); ++e) {
        takeApparentDirection(scene.environment, request.bands.front().range(), scene.entities[e],
                              geometry[e]);
        const Vec3 towards = request.referencePoints_m[e] - request.view.viewpoint.position_m;
        const double range_m = length(towards);
        const double cosine = range_m > 0.0 ? dot(towards, forward) / range_m : 1.0;
        if (cosine > nearest) {
            nearest = cosine;
            request.lookedAt = static_cast<int>(e);
        }
    }
    if (request.lookedAt < 0)
        return;
    constexpr double zenith_rad = 0.5 * std::numbers::pi;
    request.raised_rad = geometry[static_cast<std::size_t>(request.lookedAt)].raised_rad;
    request.centre.elevation_rad =
        std::clamp(request.centre.elevation_rad + request.raised_rad, -zenith_rad, zenith_rad);
    request.centre = steadied(request.centre);
}

std::vector<GroundBefore> groundBefore(const FrameRequest& request,
                                       const std::vector<ObjectGeometry>& geometry, bool forRays) {
    std::vector<GroundBefore> all;
    for (std::size_t e = 0; e < geometry.size(); ++e) {
        if (geometry[e].hidden != HiddenPart::some)
            continue;
        const Vec3& at_m = request.referencePoints_m[e];
        auto mesh = std::make_shared<const Mesh>(meshBefore(geometry[e], at_m.z));
        GroundBefore& ground = all.emplace_back();
        ground.entity = static_cast<int>(e);
        ground.pose.position_m = at_m;
        // Yaw turns y from north to the left.
        ground.pose.attitude.yaw_rad = -geometry[e].path.azimuth_rad;
        if (forRays)
            ground.rays = RayMesh::of(mesh);
        ground.mesh = std::move(mesh);
    }
    return all;
}

} // namespace irsg
