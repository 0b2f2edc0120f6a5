#include "irsg/scene/BackgroundBehind.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "irsg/atmosphere/Vacuum.h"
#include "irsg/radiance/SceneRadiometry.h"
#include "irsg/scene/ObjectSilhouette.h"
#include "irsg/scene/SightsBehind.h"

namespace irsg {

namespace {

/// A sensor nearer than so many reaches of an object sees it all around.
constexpr double tooNear = 1.2;

/// What is seen along a line of sight behind an object, by its number.
SharedValues along(AtmosphericQueryCache& answers, const SampledBand& band, std::size_t object,
                   const LineOfSight& sight) {
    if (band.isSource)
        return std::make_shared<const std::vector<double>>(band.sampling->size(), 0.0);
    const SharedValues& answer =
        answers
            .at(AtmosphericQuery::backgroundRadiance(sight, answers.environment().sun),
                band.sampling)
            .value;
    return band.behind.empty()
               ? answer
               : std::make_shared<const std::vector<double>>(band.behind[object].of(*answer));
}

void appendInBand(const SampledBand& band, const std::vector<double>& values,
                  std::vector<double>& inBand) {
    const std::vector<double>& weights_um = band.sampling->weights_um();
    for (const auto& [first, last] : band.outputs) {
        double sum = 0.0;
        for (std::size_t i = first; i < last; ++i)
            sum += weights_um[i] * values[i];
        inBand.push_back(sum);
    }
}

/// The weighted sum along the lines behind an object, by node of a band.
SharedValues sumBehind(AtmosphericQueryCache& answers, const SampledBand& band, std::size_t number,
                       const ObjectGeometry& object) {
    if (object.behind.size() == 1)
        return along(answers, band, number, object.behind.front().sight);
    std::vector<double> sum(band.sampling->size(), 0.0);
    for (const auto& [sight, weight] : object.behind) {
        const SharedValues seen = along(answers, band, number, sight);
        for (std::size_t i = 0; i < sum.size(); ++i)
            sum[i] += weight * (*seen)[i];
    }
    return std::make_shared<const std::vector<double>>(std::move(sum));
}

/// Means over a range of wavelengths; gas hides nothing, but where there is nothing else.
std::function<double(const Mesh::Part&)> opacities(const Entity& entity,
                                                   const SpectralRange& range) {
    const auto opacityOf = [&entity, range](const Mesh::Part& part) {
        const Material* material = materialEntry(entity, part.codes.material);
        if (material == nullptr || material->isOpaque())
            return 1.0;
        if (material->isGas())
            return 0.0;
        const std::array<const Spectrum*, 1> passing{&material->transmissivity};
        return std::clamp(1.0 - integrateProduct(passing, range) / range.width_um(), 0.0, 1.0);
    };
    const auto hides = [&](const Mesh::Part& part) { return opacityOf(part) > 0.0; };
    if (std::ranges::any_of(entity.model->mesh()->parts, hides))
        return opacityOf;
    return [](const Mesh::Part&) { return 1.0; };
}

/// True where the background is the same in all directions.
bool isEven(const Environment& environment, const SpectralRange& range) {
    const Atmosphere* air = environment.find(range, AtmosphereProperty::backgroundRadiance);
    return air == nullptr || dynamic_cast<const Vacuum*>(air) != nullptr;
}

} // namespace

double usedBehind(const FrameRequest& request, const ObjectGeometry& object,
                  const FrameBackground& background) {
    if (background.isUniform())
        return background.centre_W_m2_sr();
    const Sensor& sensor = request.view.sensor;
    const auto pixel = [](double place, int size) {
        return static_cast<int>(std::clamp(place, 0.0, size - 1.0));
    };
    double used = 0.0;
    for (const auto& [sight, weight] : object.behind) {
        const Vec3 towards = direction(sight.azimuth_rad, sight.elevation_rad - request.raised_rad);
        const auto place = request.camera.placeOf(request.view.viewpoint.position_m +
                                                  towards * object.path.range_m);
        used += weight * (place ? background.at(pixel(place->first, sensor.width_px),
                                                pixel(place->second, sensor.height_px))
                                : background.centre_W_m2_sr());
    }
    return used;
}

void BackgroundBehind::takeOwn(const FrameRequest& request,
                               const std::vector<ObjectGeometry>& geometry,
                               const std::vector<FrameBackground>& taken,
                               std::vector<ObjectSums>& sums) const {
    for (std::size_t e = 0; e < radiance.size(); ++e) {
        const Vec3 towards = request.referencePoints_m[e] - request.view.viewpoint.position_m;
        const double range_m = geometry[e].path.range_m;
        const double cosine =
            range_m > 0.0 ? dot(towards, request.view.viewpoint.forward()) / range_m : 1.0;
        for (std::size_t k = 0; e != lookedAt && k < sums.size(); ++k) {
            ObjectRadiometry& object = sums[k].objects[e];
            const double more_W_m2_sr = radiance[e][k] - usedBehind(request, geometry[e], taken[k]);
            const double hidden_W_m2 = more_W_m2_sr * object.solidAngle_sr;
            for (ObjectRadiometry* one : {&object, &sums[k].all}) {
                one->contrastIntensity_W_sr -= hidden_W_m2 * range_m * range_m;
                one->irradiance_W_m2 -= hidden_W_m2 * cosine;
            }
            for (SurfaceRadiometry& surface : object.surfaces) {
                const double own_W_m2 = more_W_m2_sr * surface.solidAngle_sr;
                surface.contrastIntensity_W_sr -= own_W_m2 * range_m * range_m;
                surface.irradiance_W_m2 -= own_W_m2 * cosine;
            }
        }
    }
}

bool hasBackgroundBehind(const Scene& scene) {
    const RenderSettings& settings = scene.settings;
    return settings.background == BackgroundMode::environment && settings.backgroundRows == 0 &&
           settings.backgroundColumns == 1 && !scene.skybox && !scene.terrain &&
           !settings.sunDisc && !scene.entities.empty();
}

BackgroundBehind backgroundBehind(AtmosphericQueryCache& answers, const FrameRequest& request,
                                  const std::vector<SampledBand>& bands,
                                  std::vector<ObjectGeometry>& geometry) {
    const Scene& scene = request.scene;
    const SpectralRange& range = request.bands.front().range();
    const bool isEverywhereAlike = isEven(scene.environment, range);
    std::vector<std::vector<double>> errors;
    for (std::size_t e = 0; e < geometry.size(); ++e) {
        ObjectGeometry& object = geometry[e];
        const Entity& entity = scene.entities[e];
        const double range_m = object.path.range_m, reach_m = object.farthest_m - range_m;
        const bool isApart =
            !isEverywhereAlike && range_m > tooNear * reach_m && object.hidden != HiddenPart::all;
        SightsBehind behind = sightsBehind(
            object, scene.environment.horizonElevation_rad(object.sight.sensorAltitude_m, range),
            isApart ? std::asin(reach_m / range_m) : 0.0,
            [&] {
                // About the direction that the apparent one is of, see ObjectGeometry::raised_rad.
                std::vector<SilhouettePart> slices =
                    silhouetteOf(*entity.model->mesh(), entity.pose,
                                 request.view.viewpoint.position_m, request.referencePoints_m[e],
                                 std::asin(reach_m / range_m), opacities(entity, range));
                const double flat_rad =
                    flatTargetView(object.path).elevation_rad + object.raised_rad;
                for (SilhouettePart& slice : slices)
                    slice.above_rad += flat_rad - object.sight.elevation_rad;
                return slices;
            },
            [&](const LineOfSight& sight) {
                std::vector<double> seen;
                for (const SampledBand& band : bands)
                    appendInBand(band, *along(answers, band, e, sight), seen);
                return seen;
            });
        object.behind = std::move(behind.sights);
        errors.push_back(std::move(behind.error));
    }
    BackgroundBehind all = backgroundAlong(answers, request, bands, geometry);
    if (all.background)
        all.error = std::move(errors);
    return all;
}

BackgroundBehind backgroundAlong(AtmosphericQueryCache& answers, const FrameRequest& request,
                                 const std::vector<SampledBand>& bands,
                                 const std::vector<ObjectGeometry>& geometry) {
    const auto main = static_cast<std::size_t>(request.lookedAt);
    if (main >= geometry.size() || geometry[main].behind.empty())
        return {};
    BackgroundBehind all;
    all.lookedAt = main;
    all.background = joinedOver(bands, [&](const SampledBand& band) {
        return sumBehind(answers, band, main, geometry[main]);
    });
    for (std::size_t e = 0; e < geometry.size(); ++e) {
        const ObjectGeometry& object = geometry[e];
        std::vector<double>& mean = all.radiance.emplace_back();
        std::vector<double> least, most;
        std::vector<std::vector<double>>& lines = all.along.emplace_back();
        for (const SampledBand& band : bands)
            appendInBand(band, *sumBehind(answers, band, e, object), mean);
        for (const SightBehind& behind : object.behind) {
            std::vector<double> seen;
            for (const SampledBand& band : bands)
                appendInBand(band, *along(answers, band, e, behind.sight), seen);
            lines.push_back(seen);
            if (least.empty())
                least = most = seen;
            for (std::size_t k = 0; k < seen.size(); ++k) {
                least[k] = std::min(least[k], seen[k]);
                most[k] = std::max(most[k], seen[k]);
            }
        }
        std::vector<double>& error = all.error.emplace_back();
        for (std::size_t k = 0; k < least.size(); ++k)
            error.push_back(errorOfOverlap * (most[k] - least[k]));
    }
    return all;
}

} // namespace irsg
