#include "irsg/render/background/SceneBackground.h"

#include <algorithm>
#include <cmath>

#include "irsg/core/Errors.h"
#include "irsg/geometry/view/CameraFrame.h"
#include "irsg/radiometry/Units.h"
#include "irsg/render/background/GroundDistance.h"
#include "irsg/render/background/Horizon.h"
#include "irsg/render/background/SunDisc.h"

namespace irsg {

namespace {

/// Of the pixel in the middle, or of the two or four that touch it.
double middleOf(const std::vector<double>& pixels, const Sensor& sensor) {
    double sum = 0.0;
    for (const int y : {(sensor.height_px - 1) / 2, sensor.height_px / 2})
        for (const int x : {(sensor.width_px - 1) / 2, sensor.width_px / 2})
            sum += pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(sensor.width_px) +
                          static_cast<std::size_t>(x)];
    return 0.25 * sum;
}

} // namespace

FrameBackground SceneBackground::draw(const Sensor& sensor, const Viewpoint& viewpoint,
                                      const BandSky& sky, const BackgroundSettings& settings,
                                      TerrainPainter& painter, BackgroundReport& report) {
    layers_ = {};
    const FieldRays rays(sensor, viewpoint);
    const double altitude_m = std::max(viewpoint.position_m.z, 0.0);
    bool grid = settings.queriesEnvironment && settings.rows * settings.columns != 1;
    if (!grid && !settings.sunDisc && !skybox_ && !terrain_)
        return FrameBackground(settings.uniform_W_m2_sr);

    if (skybox_)
        layers_.sky = skybox_->pixels(rays, settings.skybox);
    if (skybox_ && settings.sunDisc && skybox_->brightSpot_rad())
        report.warnings.push_back(
            "the skybox has a bright spot of " +
            numberText(std::round(degrees(*skybox_->brightSpot_rad()) * 100) / 100) +
            " deg, as a sun would be, and the disc of the sun is drawn, too");
    const double horizon_rad = sky.horizon_rad(altitude_m);
    if (settings.sunDisc)
        renderSunImage(rays, Horizon(rays, horizon_rad), sky, altitude_m);
    if (terrain_)
        renderTerrain(sensor, viewpoint, settings.terrain, painter);
    if (grid) {
        const auto radianceAt = [&](const LineOfSight& sight) {
            return sky.radiance_W_m2_sr(sight);
        };
        try {
            const BackgroundGrid lines(sensor, viewpoint, horizon_rad, settings.rows,
                                       settings.columns, radianceAt);
            layers_.environment = lines.pixels();
            if (terrain_)
                putGroundBehindTerrain(lines, radianceAt, sky, altitude_m);
        } catch (const InputError&) {
            // Air that answers for one direction alone, such as a radiative output.
            if (settings.rows != BackgroundGrid::asManyAsNeeded)
                throw;
            grid = false;
        }
    }
    report.providedBy = sky.providedBy();
    if (layers_.sky.empty() && layers_.terrain.empty() && !grid)
        return FrameBackground(settings.uniform_W_m2_sr);

    // Terrain hides the sky, the environment is added upon both, and no sum is below 0.
    std::vector<double> pixels = layers_.sky;
    pixels.resize(static_cast<std::size_t>(sensor.width_px) *
                      static_cast<std::size_t>(sensor.height_px),
                  0.0);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        if (!layers_.terrain.empty())
            pixels[i] = layers_.terrain[i] + (1.0 - layers_.coverage[i]) * pixels[i];
        pixels[i] += grid ? layers_.environment[i] : settings.uniform_W_m2_sr;
        if (pixels[i] < 0.0) {
            pixels[i] = 0.0;
            ++report.flooredPixels;
        }
    }
    const double centre_W_m2_sr = middleOf(pixels, sensor);
    return FrameBackground(sensor.width_px, std::move(pixels), centre_W_m2_sr);
}

void SceneBackground::renderTerrain(const Sensor& sensor, const Viewpoint& viewpoint,
                                    const TextureScale& scale, TerrainPainter& painter) {
    TerrainImage image = painter.paint(terrain_, CameraFrame(sensor, viewpoint), scale.offset);
    layers_.coverage = std::move(image.coverage);
    layers_.nearness_1_m = std::move(image.nearness_1_m);
    layers_.terrain = std::move(image.texel);
    for (double& value : layers_.terrain)
        value *= scale.slope_W_m2_sr;
}

void SceneBackground::putGroundBehindTerrain(const BackgroundGrid& lines,
                                             const BackgroundGrid::Radiance& radianceAt,
                                             const BandSky& sky, double altitude_m) {
    const GroundDistance ground(altitude_m, sky.apparentHorizon_rad(altitude_m));
    std::vector<std::optional<double>> below_rad(layers_.coverage.size());
    for (std::size_t i = 0; i < below_rad.size(); ++i)
        if (layers_.nearness_1_m[i] > 0.0)
            below_rad[i] = ground.belowHorizon_rad(layers_.coverage[i] / layers_.nearness_1_m[i]);
    const std::vector<double> behind = lines.groundPixels(below_rad, radianceAt);
    for (std::size_t i = 0; i < behind.size(); ++i)
        layers_.environment[i] += layers_.coverage[i] * (behind[i] - layers_.environment[i]);
}

void SceneBackground::renderSunImage(const FieldRays& rays, const Horizon& horizon,
                                     const BandSky& sky, double altitude_m) {
    const SunPosition& sun = sky.sun();
    // Where air bends its light to, and as bright as the part of it that gives the irradiance.
    const SunView seen = sky.sunView(altitude_m);
    const SunDisc disc(rays, horizon, direction(sun.azimuth_rad, seen.elevation_rad));
    if (disc.pixels().empty() || seen.part <= 0.0)
        return;
    const double radiance = disc.radiance_W_m2_sr(sky.sun_W_m2(altitude_m) / seen.part);
    if (layers_.sky.empty())
        layers_.sky.assign(static_cast<std::size_t>(rays.width_px) *
                               static_cast<std::size_t>(rays.height_px),
                           0.0);
    for (const SunDisc::Pixel& pixel : disc.pixels()) {
        double& behind =
            layers_
                .sky[static_cast<std::size_t>(pixel.y) * static_cast<std::size_t>(rays.width_px) +
                     static_cast<std::size_t>(pixel.x)];
        behind += pixel.coverage * (radiance - behind);
    }
}

} // namespace irsg
