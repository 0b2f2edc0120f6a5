// What directional surfaces reflect of other surfaces along their lobes: plane mirrors in closed
// form, rough plates by an own quadrature, and the sun on what is reflected.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include "irsg/radiometry/Units.h"
#include "irsg/reference/PlanckReference.h"
#include "irsg/signature/SurfaceModels.h"
#include "tests/support/LightScenes.h"
#include "tests/support/RaysTest.h"
#include "tests/support/RevolvedMeshes.h"

using namespace irsg;
using namespace irsg::test;

namespace {

class ReflectedSurfaces : public RaysTest {};

constexpr double wallHeight_m = 0.3;
constexpr double wavelength_um = 4.0;

Material polished(const std::string& model, double roughness) {
    Material material = greyMaterial(0.1);
    material.surfaceModel = model;
    material.roughness = roughness;
    return material;
}

/// A level plate of 1 m whose edge at x = 0.5 a wall of 600 K stands on.
struct PlateAndWall {
    Material plate;
    double wallEmissivity = 1.0, wall_K = 600.0;
    int divisions = 1; ///< of the wall along its edge

    Triangles mesh() const {
        Triangles all = plateMesh({}, {0.5, 0, 0}, {0, 0.5, 0}, {1, 1});
        for (int i = 0; i < divisions; ++i) {
            all =
                joined(all, plateMesh({0.5, (i + 0.5) / divisions - 0.5, 0.5 * wallHeight_m},
                                      {0, 0, 0.5 * wallHeight_m}, {0, 0.5 / divisions, 0}, {2, 2}));
        }
        return all;
    }
    Entity entity() const {
        SignatureDatabase database = greyDatabase(0.5, 2.0);
        database.materials[1] = plate;
        database.materials[2] = greyMaterial(wallEmissivity);
        database.temperatures[2] = fixedTemperature(wall_K);
        Entity made = entityOf(modelOf(mesh()), database);
        made.referencePoint_m = Vec3{};
        return made;
    }
};

double intensity_W_sr(InteractiveRenderer& irsg, double elevation_rad) {
    look(irsg, {.range_m = 30'000.0,
                .azimuth_rad = -0.5 * pi,
                .elevation_rad = elevation_rad,
                .width_px = 16,
                .height_px = 16,
                .fieldOfView_rad = 0.001});
    return irsg.measure().all.intensity_W_sr;
}

/// The part of a level plate of 1 m from which a direction, in its axes with x away from the wall,
/// meets the wall.
double partThatMeetsWall(const SurfaceDirection& from) {
    constexpr int places = 40;
    if (!(from.z > 0.0) || !(from.x < 0.0)) {
        return 0.0;
    }
    int met = 0;
    for (int p = 0; p < places; ++p) {
        for (int q = 0; q < places; ++q) {
            const double x = (p + 0.5) / places - 0.5, y = (q + 0.5) / places - 0.5;
            const double step = (0.5 - x) / -from.x;
            met += step * from.z < wallHeight_m && std::abs(y - step * from.y) < 0.5 ? 1 : 0;
        }
    }
    return static_cast<double>(met) / (places * places);
}

/// What the plate sends of a wall of radiance 1, m2: facets by Trowbridge and Reitz, or Gaussian,
/// and whether the direction from which each reflects meets the wall; what is reflected among
/// facets more than once by its BRDF.
double plateShows_m2(const Material& material, double elevation_rad) {
    const auto model = surfaceModelOf(material);
    const SurfaceModel::Amounts amounts = model->amountsAt(material, wavelength_um);
    const double alpha = material.roughness;
    const SurfaceDirection to{std::cos(elevation_rad), 0.0, std::sin(elevation_rad)};
    constexpr int slopes = 60, turns = 61;
    double sum = 0.0;
    for (int i = 0; i < slopes; ++i) {
        const double share = (i + 0.5) / slopes;
        const double tan2 = material.surfaceModel == "ggx" ? alpha * alpha * share / (1.0 - share)
                                                           : -alpha * alpha * std::log1p(-share);
        const double cosine = 1.0 / std::sqrt(1.0 + tan2), sine = std::sqrt(1.0 - cosine * cosine);
        for (int j = 0; j < turns; ++j) {
            const double around = 2.0 * pi * (j + 0.5) / turns;
            const SurfaceDirection facet{sine * std::cos(around), sine * std::sin(around), cosine};
            double sent = 0.0, diffuse = 0.0;
            const double level = std::sqrt(share), up = std::sqrt(1.0 - share);
            const SurfaceDirection spread{level * std::cos(around), level * std::sin(around), up};
            for (std::size_t k = 0; k < model->components(); ++k) {
                if (model->hasLobe(k)) {
                    sent += amounts[k] * model->facetWeight(k, to, facet);
                } else {
                    diffuse += amounts[k] * pi * model->brdf_per_sr(k, to, spread);
                }
            }
            if (sent > 0.0) {
                sum += sent * partThatMeetsWall(mirrored(to, facet));
            }
            sum += diffuse * partThatMeetsWall(spread);
        }
    }
    return sum / (slopes * turns) * std::sin(elevation_rad);
}

double black_W_m2_sr(double temperature_K) {
    return static_cast<double>(reference::bandRadiance({3.0, 5.0}, temperature_K));
}

} // namespace

TEST_F(ReflectedSurfaces, APlaneMirrorShowsAHotWall) {
    // The mirror image of the wall: places whose mirror direction meets it lie within height / tan
    // of its foot.
    for (const EngineChoice engine : {EngineChoice::opengl, EngineChoice::rays}) {
        for (const double elevation_deg : {25.0, 40.0, 60.0}) {
            const double elevation_rad = radians(elevation_deg), sine = std::sin(elevation_rad);
            PlateAndWall scene{polished("ggx", 0.002)};
            RenderSettings settings = lightSettings(convergedBounces);
            settings.engine = engine;
            InteractiveRenderer irsg = rendererOf({scene.entity()}, settings);
            const double found = intensity_W_sr(irsg, elevation_rad);
            const double direct = wallHeight_m * std::cos(elevation_rad);
            const double shown = sine * std::min(wallHeight_m / std::tan(elevation_rad), 1.0) *
                                 (0.9 + 0.1 * std::pow(1.0 - sine, 5));
            const double expected = black_W_m2_sr(600.0) * (direct + shown);
            std::printf("  %g deg: %.5f of the closed form; without what is mirrored %.3f\n",
                        elevation_deg, found / expected, direct / (direct + shown));
            EXPECT_NEAR(found / expected, 1.0, 0.003) << elevation_deg;
        }
    }
}

TEST_F(ReflectedSurfaces, RoughPlatesShowAHotWall) {
    for (const char* model : {"ggx", "beckmann"}) {
        for (const double roughness : {0.05, 0.15, 0.4}) {
            for (const double elevation_deg : {30.0, 55.0}) {
                PlateAndWall scene{polished(model, roughness)};
                InteractiveRenderer irsg =
                    rendererOf({scene.entity()}, lightSettings(convergedBounces));
                const double elevation_rad = radians(elevation_deg);
                const double direct = wallHeight_m * std::cos(elevation_rad);
                const double shown = plateShows_m2(scene.plate, elevation_rad);
                const double expected = black_W_m2_sr(600.0) * (direct + shown);
                const double found = intensity_W_sr(irsg, elevation_rad);
                std::printf("  %s %g, %g deg: %.5f of the quadrature; mirrored part %.3f\n", model,
                            roughness, elevation_deg, found / expected, shown / (direct + shown));
                EXPECT_NEAR(found / expected, 1.0, 0.005) << model << " " << roughness;
            }
        }
    }
}

TEST_F(ReflectedSurfaces, APlaneMirrorShowsTheSunOnAWall) {
    ConstantAtmosphere air;
    air.sunValue = 100.0;
    const double elevation_rad = radians(40.0);
    // The sun on the side that the wall faces, so that its cosine to the wall is that of 30
    // degrees.
    const Environment environment = environmentOf(air, {-0.5 * pi, radians(30.0)});
    RenderSettings settings = lightSettings(convergedBounces);
    settings.sun = ReflectionMode::smart;
    settings.sunShadows = SunShadowMode::point;
    PlateAndWall scene{polished("ggx", 0.002), 0.4, 2.0, 3};
    InteractiveRenderer irsg = rendererOf({scene.entity()}, settings, environment);
    const double found = intensity_W_sr(irsg, elevation_rad);
    // The wall reflects the sun, and the sun's glint from the plate, which reaches it from below: a
    // mirror of roughness 0 sends all of it there, and lights it up to where its rays leave the
    // plate.
    const double radiance = 0.6 / pi * 200.0 * std::cos(radians(30.0));
    const double direct = wallHeight_m * std::cos(elevation_rad);
    const double sine = std::sin(elevation_rad);
    const double shown =
        sine * wallHeight_m / std::tan(elevation_rad) * (0.9 + 0.1 * std::pow(1.0 - sine, 5));
    std::printf("  %.5f of sun on the wall, direct and mirrored\n",
                found / (radiance * (direct + shown)));
    // What the plate irradiates the wall with is not by direction: it is at most its reflectivity
    // times the wall's view of it.
    EXPECT_GT(found, 0.997 * radiance * (direct + shown));
    EXPECT_LT(found, 1.5 * radiance * (direct + shown));
}
