#include "irsg/render/background/TerrainRays.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "irsg/core/Errors.h"
#include "irsg/core/ParallelFor.h"
#include "irsg/render/background/TexturePyramid.h"
#include "irsg/render/rays/RayMesh.h"

namespace irsg {

namespace {

using GroundPlace = std::array<double, 2>;

} // namespace

struct TerrainRays::CacheEntry {
    std::shared_ptr<const Terrain> terrain;
    std::shared_ptr<const RayMesh> mesh;
    PieceUses uses{0};
    std::vector<TexturePyramid> textures; // of the terrain

    /// Where a ray that need not meet a facet meets its plane, in the texture.
    GroundPlace placeAt(const RayHit& hit, const Ray& ray) const {
        const Mesh::Part& part = terrain->shown().mesh->parts[static_cast<std::size_t>(hit.piece)];
        const unsigned* corners = &part.triangles[3 * static_cast<std::size_t>(hit.facet)];
        const RayHit there = mesh->onPlaneOf(hit, ray);
        GroundPlace place{};
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t axis = 0; axis < 2; ++axis)
                place[axis] +=
                    there.weights[i] * static_cast<double>(part.texturePlaces[corners[i]][axis]);
        return place;
    }
};

TerrainRays::TerrainRays() = default;
TerrainRays::~TerrainRays() = default;

const TerrainRays::CacheEntry& TerrainRays::keep(const std::shared_ptr<const Terrain>& terrain) {
    if (cache_ && cache_->terrain == terrain)
        return *cache_;
    auto kept = std::make_unique<CacheEntry>();
    kept->terrain = terrain;
    kept->mesh = RayMesh::of(terrain->shown().mesh);
    kept->uses = PieceUses(kept->mesh->pieces());
    for (std::size_t i = 0; i < kept->mesh->pieces(); ++i)
        kept->uses.set(i, {.isThere = true});
    for (const TexturedMesh::Texture& texture : terrain->shown().textures)
        kept->textures.emplace_back(texture.image, texture.wrapS, texture.wrapT);
    cache_ = std::move(kept);
    return *cache_;
}

std::shared_ptr<const RayMesh> TerrainRays::meshOf(const std::shared_ptr<const Terrain>& terrain) {
    return keep(terrain).mesh;
}

TerrainImage TerrainRays::paint(const std::shared_ptr<const Terrain>& terrain,
                                const CameraFrame& camera, double offset) {
    const CacheEntry& kept = keep(terrain);
    const Sensor& sensor = camera.sensor();
    const Rotation toMesh = terrain->pose().attitude.rotation().transposed();
    const Viewpoint& eye = camera.viewpoint();
    const Vec3 eye_m = toMesh * (eye.position_m - terrain->pose().position_m);
    const double pitch = sensor.pixelPitch();
    constexpr double step_px = 1.0 / samplesPerAxis;
    constexpr double share = 1.0 / (samplesPerAxis * samplesPerAxis);
    const auto rayAt = [&](double x_px, double y_px) {
        const Vec3 along = eye.forward() + eye.right * ((x_px - 0.5 * sensor.width_px) * pitch) +
                           eye.up * ((0.5 * sensor.height_px - y_px) * pitch);
        return Ray{eye_m, normalized(toMesh * along)};
    };
    struct Sample {
        double texel, distance_m; ///< what it shows above the offset
    };
    /// Nothing where there is no terrain.
    const auto sampleAt = [&](double x_px, double y_px) -> std::optional<Sample> {
        const Ray ray = rayAt(x_px, y_px);
        RayHit hit;
        std::vector<RayHit> none;
        if (!kept.mesh->meet(ray, kept.uses, 0.0, hit, none))
            return std::nullopt;
        const int texture = terrain->shown().textureOf[static_cast<std::size_t>(hit.piece)];
        if (texture < 0)
            return Sample{0.0, hit.distance_m};
        const GroundPlace here = kept.placeAt(hit, ray);
        const GroundPlace right = kept.placeAt(hit, rayAt(x_px + step_px, y_px));
        const GroundPlace below = kept.placeAt(hit, rayAt(x_px, y_px + step_px));
        return Sample{kept.textures[static_cast<std::size_t>(texture)].at(
                          here[0], here[1], {right[0] - here[0], right[1] - here[1]},
                          {below[0] - here[0], below[1] - here[1]}) -
                          offset,
                      hit.distance_m};
    };

    TerrainImage image;
    const auto width = static_cast<std::size_t>(sensor.width_px);
    image.texel.resize(width * static_cast<std::size_t>(sensor.height_px));
    image.coverage.resize(image.texel.size());
    image.nearness_1_m.resize(image.texel.size());
    parallelFor(static_cast<std::size_t>(sensor.height_px), [&](std::size_t y) {
        for (std::size_t x = 0; x < width; ++x)
            for (int s = 0; s < samplesPerAxis * samplesPerAxis; ++s) {
                const double x_px = static_cast<double>(x) + (s % samplesPerAxis + 0.5) * step_px;
                const double y_px = static_cast<double>(y) + (s / samplesPerAxis + 0.5) * step_px;
                if (const std::optional<Sample> sample = sampleAt(x_px, y_px)) {
                    image.texel[y * width + x] += sample->texel * share;
                    image.coverage[y * width + x] += share;
                    image.nearness_1_m[y * width + x] += share / std::max(sample->distance_m, 1e-6);
                }
            }
    });
    for (double& coverage : image.coverage)
        coverage = std::min(coverage, 1.0);
    return image;
}

} // namespace irsg
