// What rough surfaces show of small bright parts: pixel by pixel as the integral over the lobe has
// it, without the specks that a few facets a sample leave.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <string>
#include <vector>

#include "irsg/radiometry/Units.h"
#include "irsg/reference/PlanckReference.h"
#include "irsg/signature/SurfaceModels.h"
#include "tests/support/LightScenes.h"
#include "tests/support/RaysTest.h"
#include "tests/support/RevolvedMeshes.h"

using namespace irsg;
using namespace irsg::test;

namespace {

class LobeAimsTest : public RaysTest {};

constexpr double ball_K = 1000.0, radius_m = 0.012, wavelength_um = 4.0;
constexpr int width_px = 160, height_px = 120;
constexpr double fieldOfView_deg = 7.0;
const Vec3 eye_m{0.3, -3.0, 2.2}, target_m{0.05, 0.05, 0.0};

Material roughPaint(const std::string& model, double roughness) {
    Material material = greyMaterial(0.4);
    material.surfaceModel = model;
    material.roughness = roughness;
    return material;
}

/// A cold rough plate of 1.6 m under hot balls, out of sight of the camera.
Entity plateUnder(const std::vector<Vec3>& balls_m, const Material& paint) {
    Triangles all = plateMesh({}, {0.8, 0, 0}, {0, 0.8, 0}, {1, 1});
    for (const Vec3& at_m : balls_m) {
        all = joined(all, moved(sphereOfEqualArea(radius_m, 10, {2, 2}), at_m));
    }
    SignatureDatabase database = greyDatabase(0.5, 2.0);
    database.materials[1] = paint;
    database.materials[2] = greyMaterial(1.0);
    database.temperatures[2] = fixedTemperature(ball_K);
    Entity made = entityOf(modelOf(all), database);
    made.referencePoint_m = Vec3{};
    return made;
}

/// What a place of the plate sends to the camera of balls of radiance 1, by its BRDF.
double shows(const SurfaceModel& model, const SurfaceModel::Amounts& amounts, const Vec3& place_m,
             const std::vector<Vec3>& balls_m) {
    const Vec3 to = normalized(eye_m - place_m);
    double sum = 0.0;
    for (const Vec3& ball_m : balls_m) {
        const Vec3 way_m = ball_m - place_m;
        const double distance_m = length(way_m);
        const Vec3 from = way_m * (1.0 / distance_m);
        const double solidAngle_sr = pi * radius_m * radius_m / (distance_m * distance_m);
        for (std::size_t k = 0; k < model.components(); ++k) {
            sum += amounts[k] * solidAngle_sr * from.z *
                   model.brdf_per_sr(k, {to.x, to.y, to.z}, {from.x, from.y, from.z});
        }
    }
    return sum;
}

/// Of pixels from the integral over the lobe, in parts of the mean of these.
struct Deviations {
    double rms = 0.0, most = 0.0;
    double ofSum = 0.0;
};

Deviations deviationsFrom(const std::vector<Vec3>& balls_m, const std::string& modelName,
                          double roughness, EngineChoice engine) {
    const Material paint = roughPaint(modelName, roughness);
    RenderSettings settings = lightSettings(1);
    settings.engine = engine;
    InteractiveRenderer irsg = rendererOf({plateUnder(balls_m, paint)}, settings);
    Sensor sensor = sensorOf(width_px, height_px, fieldOfView_deg);
    sensor.band = Band::topHat(3.0, 5.0);
    irsg.view.sensor = sensor;
    const Vec3 up_m{0, 0, standingAltitude_m};
    const Viewpoint camera = Viewpoint::lookAt(eye_m + up_m, target_m + up_m);
    irsg.view.viewpoint = camera;
    const RadianceImage image = irsg.imageWithReport().image;
    const std::vector<float>& values = image.find("L")->values;

    const auto model = surfaceModelOf(paint);
    const SurfaceModel::Amounts amounts = model->amountsAt(paint, wavelength_um);
    const auto radiance = static_cast<double>(reference::bandRadiance({3.0, 5.0}, ball_K));
    const double halfWidth = std::tan(0.5 * radians(fieldOfView_deg));
    std::vector<double> expected, differences;
    for (int row = 0; row < height_px; ++row) {
        for (int column = 0; column < width_px; ++column) {
            const double x = (2.0 * (column + 0.5) / width_px - 1.0) * halfWidth;
            const double y =
                (1.0 - 2.0 * (row + 0.5) / height_px) * halfWidth * height_px / width_px;
            const Vec3 along = camera.forward() + camera.right * x + camera.up * y;
            const Vec3 place_m = eye_m + along * (-eye_m.z / along.z);
            expected.push_back(radiance * shows(*model, amounts, place_m, balls_m));
            differences.push_back(static_cast<double>(values[expected.size() - 1]) -
                                  expected.back());
        }
    }
    const double pixels = width_px * height_px;
    const double mean = std::accumulate(expected.begin(), expected.end(), 0.0) / pixels;
    Deviations found;
    for (const double difference : differences) {
        found.rms += difference * difference / pixels;
        found.most = std::max(found.most, std::abs(difference) / mean);
        found.ofSum += difference / mean / pixels;
    }
    found.rms = std::sqrt(found.rms) / mean;
    return found;
}

} // namespace

TEST_F(LobeAimsTest, ASmallHotBallLeavesNoSpecks) {
    for (const EngineChoice engine : {EngineChoice::opengl, EngineChoice::rays}) {
        for (const char* model : {"ggx", "beckmann"}) {
            for (const double roughness : {0.2, 0.3, 0.5}) {
                const Deviations found =
                    deviationsFrom({{0.0, 0.35, 0.5}}, model, roughness, engine);
                std::printf("  %s %g: sum %+.4f; pixels rms %.3f, at most %.2f\n", model, roughness,
                            found.ofSum, found.rms, found.most);
                EXPECT_NEAR(found.ofSum, 0.0, 0.015) << model << " " << roughness;
                EXPECT_LT(found.rms, 0.25) << model << " " << roughness;
                EXPECT_LT(found.most, 3.0) << model << " " << roughness;
            }
        }
    }
}

TEST_F(LobeAimsTest, SeveralBallsAreAimedAtOneByOne) {
    // Two of them one behind the other, so that their spheres overlap from much of the plate.
    const std::vector<Vec3> balls_m{
        {0.0, 0.35, 0.5}, {0.04, 0.4, 0.55}, {-0.5, 0.2, 0.4}, {0.6, 0.6, 0.7}};
    const Deviations found = deviationsFrom(balls_m, "ggx", 0.3, EngineChoice::rays);
    std::printf("  sum %+.4f; pixels rms %.3f, at most %.2f\n", found.ofSum, found.rms, found.most);
    EXPECT_NEAR(found.ofSum, 0.0, 0.015);
    EXPECT_LT(found.rms, 0.25);
    EXPECT_LT(found.most, 3.0);
}
