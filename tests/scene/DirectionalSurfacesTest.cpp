// Surfaces that reflect and emit by direction, through the renderer: closed forms, own quadratures,
// isothermal surroundings, and that every way gives the same.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "irsg/radiometry/Planck.h"
#include "irsg/radiometry/Units.h"
#include "irsg/reference/PlanckReference.h"
#include "irsg/signature/SurfaceModels.h"
#include "tests/support/LightScenes.h"
#include "tests/support/RaysTest.h"
#include "tests/support/RevolvedMeshes.h"

using namespace irsg;
using namespace irsg::test;

namespace {

class DirectionalSurfaces : public RaysTest {};

constexpr double width_um = 2.0; // of the band 3 to 5 um

Material facets(const char* model, double roughness, double emissivity, double n = 0.0,
                double k = 0.0) {
    Material material = greyMaterial(emissivity);
    material.surfaceModel = model;
    material.roughness = roughness;
    material.refractiveIndex = Spectrum::constant(n);
    material.extinction = Spectrum::constant(k);
    return material;
}

/// A paint of Sandford and Robertson, a coat of Shell, and tables of both kinds.
std::vector<Material> publishedSurfaces() {
    Material paint = facets("sandfordRobertson", 0.15, 0.55);
    paint.diffuseReflectivity = Spectrum::constant(0.1);
    paint.grazingFactor = 0.35;
    Material coat = facets("shellTarget", 0.3, 0.8, 1.4, 0.3);
    coat.diffuseReflectivity = Spectrum::constant(0.1);
    coat.volumeReflectivity = Spectrum::constant(0.03);
    Material hemispherical = facets("tabulated", 0.2, 0.7);
    hemispherical.reflectanceTable = {
        false, {3.0, 5.0}, {{0, 0, 0, {0.2, 0.4}}, {60, 0, 0, {0.3, 0.5}}, {90, 0, 0, {1, 1}}}};
    std::vector<ReflectanceTable::Row> rows;
    for (double i = 0.0; i <= 90.0; i += 15.0) {
        for (double r = 0.0; r <= 90.0; r += 15.0) {
            for (double a = 0.0; a <= 180.0; a += 30.0) {
                rows.push_back(
                    {i, r, a, {0.05 + 0.1 * std::exp(-0.05 * std::abs(i - r)) * a / 180.0}});
            }
        }
    }
    Material measured = facets("tabulated", 0.2, 0.7);
    measured.reflectanceTable = {true, {4.0}, std::move(rows)};
    return {paint, coat, hemispherical, measured};
}

Entity ballOf(const Material& material, double temperature_K, int latitudes = 96) {
    SignatureDatabase database = greyDatabase(0.5, temperature_K);
    database.materials[1] = material;
    return entityOf(modelOf(sphereMesh(1.0, latitudes, 2 * latitudes, {1, 1})), database);
}

double schlick(double normal, double cosine) {
    return normal + (1.0 - normal) * std::pow(1.0 - cosine, 5);
}

/// The sun alone, 1 W m-2 um-1 in vacuum, at an angle from the direction to a far sensor.
RenderSettings sunAlone(EngineChoice engine) {
    RenderSettings settings = RenderSettings::direct();
    settings.engine = engine;
    settings.ambientReflection = ReflectionMode::off;
    settings.background = BackgroundMode::none;
    settings.sunShadows = SunShadowMode::off;
    settings.bounces = 0;
    return settings;
}

double glint_W_sr(const Material& material, double phase_deg, EngineChoice engine) {
    ConstantAtmosphere air;
    air.sunValue = 1.0;
    const double elevation_rad = 0.4;
    // In the plane of one elevation: the angle between two directions of azimuths apart.
    const double cosine = std::cos(radians(phase_deg));
    const double apart_rad = std::acos((cosine - std::pow(std::sin(elevation_rad), 2)) /
                                       std::pow(std::cos(elevation_rad), 2));
    InteractiveRenderer irsg = rendererOf({ballOf(material, 2.0)}, sunAlone(engine),
                                          environmentOf(air, {apart_rad, elevation_rad}));
    look(irsg, {.range_m = 3000.0,
                .azimuth_rad = 0.0,
                .elevation_rad = elevation_rad,
                .fieldOfView_rad = 0.002});
    return irsg.measure().all.intensity_W_sr;
}

/// Of a BRDF of this test's own over a sphere of 1 m, a far sensor and the sun at a phase: the
/// integral of f cos cos' over its area.
template <typename Brdf>
double overSphere_m2_sr(double phase_rad, const Brdf& brdf, int rings = 2000, int places = 400) {
    double sum = 0.0;
    for (int i = 0; i < rings; ++i) {
        const double cosTo = (i + 0.5) / rings, sine = std::sqrt(1.0 - cosTo * cosTo);
        for (int j = 0; j < places; ++j) {
            const double around = pi * (j + 0.5) / places;
            // The sensor along z, the sun in the plane of x and z.
            const double cosFrom =
                sine * std::cos(around) * std::sin(phase_rad) + cosTo * std::cos(phase_rad);
            if (cosFrom > 0.0) {
                sum += brdf(cosTo, cosFrom, phase_rad) * cosTo * cosFrom * 2.0 * pi /
                       (static_cast<double>(rings) * places);
            }
        }
    }
    return sum;
}

} // namespace

TEST_F(DirectionalSurfaces, SendAGlintOfASmoothSphere) {
    // rho r^2 E / 4 with Fresnel's rho at half of the phase angle.
    for (const EngineChoice engine : {EngineChoice::opengl, EngineChoice::rays}) {
        for (const double phase_deg : {20.0, 60.0, 100.0}) {
            const double rho = schlick(0.7, std::cos(radians(0.5 * phase_deg)));
            const double expected = 0.25 * rho * width_um;
            for (const double roughness : {0.005, 0.02}) {
                const double found =
                    glint_W_sr(facets("beckmann", roughness, 0.3), phase_deg, engine);
                std::printf("  phase %g, roughness %g: %.4f of rho r^2 E / 4\n", phase_deg,
                            roughness, found / expected);
                EXPECT_NEAR(found / expected, 1.0, 0.005) << phase_deg << " " << roughness;
            }
        }
    }
}

TEST_F(DirectionalSurfaces, SendTheGlintOfARoughSphere) {
    const double alpha = 0.4, normal = 0.7;
    const auto model = surfaceModelOf(facets("ggx", alpha, 0.3));
    const SurfaceModel::Amounts amounts = model->amountsAt(facets("ggx", alpha, 1.0 - normal), 4.0);
    const auto lambda = [&](double cosine) {
        const double tangent = (1.0 - cosine * cosine) / (cosine * cosine);
        return 0.5 * (std::sqrt(1.0 + alpha * alpha * tangent) - 1.0);
    };
    const auto brdf = [&](double cosTo, double cosFrom, double phase_rad) {
        const double cosHalf = std::cos(0.5 * phase_rad);
        const double facet = (cosTo + cosFrom) / (2.0 * cosHalf);
        const double sum = facet * facet * (alpha * alpha - 1.0) + 1.0;
        const double density = alpha * alpha / (pi * sum * sum);
        const double once = schlick(normal, cosHalf) * density /
                            (1.0 + lambda(cosTo) + lambda(cosFrom)) / (4.0 * cosTo * cosFrom);
        const double often = amounts[2] * model->albedo(2, cosTo) * model->albedo(2, cosFrom) /
                             (pi * model->meanAlbedo(2));
        return once + often;
    };
    for (const double phase_deg : {30.0, 90.0}) {
        const double expected = width_um * overSphere_m2_sr(radians(phase_deg), brdf);
        EXPECT_NEAR(glint_W_sr(facets("ggx", alpha, 0.3), phase_deg, EngineChoice::rays) / expected,
                    1.0, 0.003)
            << phase_deg;
    }
}

TEST_F(DirectionalSurfaces, SendTheGlintOfPublishedModels) {
    // The BRDF of the model itself over a sphere, by the quadrature of this test.
    for (const Material& material : publishedSurfaces()) {
        const double phase_deg = 40.0;
        const auto brdf = [&](double cosTo, double cosFrom, double phase_rad) {
            const double sines = std::sqrt((1.0 - cosTo * cosTo) * (1.0 - cosFrom * cosFrom));
            const double between =
                sines > 1e-9 ? (std::cos(phase_rad) - cosTo * cosFrom) / sines : 1.0;
            const double across = std::sqrt(std::max(1.0 - between * between, 0.0));
            const double sineTo = std::sqrt(1.0 - cosTo * cosTo);
            const double sineFrom = std::sqrt(1.0 - cosFrom * cosFrom);
            double sum = 0.0;
            for (const double wavelength_um : {3.5, 4.5}) {
                sum += 0.5 * brdf_per_sr(material, {sineTo, 0.0, cosTo},
                                         {sineFrom * between, sineFrom * across, cosFrom},
                                         wavelength_um);
            }
            return sum;
        };
        const double expected = width_um * overSphere_m2_sr(radians(phase_deg), brdf, 300, 100);
        EXPECT_NEAR(glint_W_sr(material, phase_deg, EngineChoice::rays) / expected, 1.0, 0.006)
            << material.surfaceModel;
    }
}

TEST_F(DirectionalSurfaces, EmitByDirection) {
    // A smooth sphere: L pi r^2 times the hemispherical emissivity, 1 - F0 - (1 - F0) / 21; in its
    // middle 1 - F0.
    RenderSettings settings = lightSettings(0);
    for (const EngineChoice engine : {EngineChoice::opengl, EngineChoice::rays}) {
        settings.engine = engine;
        InteractiveRenderer irsg = rendererOf({ballOf(facets("ggx", 0.001, 0.3), 400.0)}, settings);
        look(irsg, {.range_m = 3000.0, .width_px = 65, .height_px = 65, .fieldOfView_rad = 0.001});
        const double black = static_cast<double>(reference::bandRadiance({3.0, 5.0}, 400.0));
        EXPECT_NEAR(irsg.measure().all.intensity_W_sr / (black * pi * 0.3 * 20.0 / 21.0), 1.0,
                    0.002);
        const RadianceImage image = irsg.imageWithReport().image;
        EXPECT_NEAR(static_cast<double>(image.at(32, 32)) / black, 0.3, 5e-4);
    }
}

TEST_F(DirectionalSurfaces, AreInvisibleInAnIsothermalEnclosure) {
    const Band band = Band::topHat(8.0, 8.0001);
    const double black = bandRadiance_W_m2_sr(band, 300.0) / band.area_um();
    ConstantAtmosphere air;
    air.transmittanceValue = 0.6;
    air.pathRadianceValue = 0.4 * black;
    air.backgroundValue = black;
    air.upValue = air.downValue = pi * black;
    std::vector<Material> materials = {facets("ggx", 0.3, 0.4), facets("beckmann", 0.01, 0.1),
                                       facets("ggx", 0.8, 0.4, 3.0, 4.0)};
    std::ranges::copy(publishedSurfaces(), std::back_inserter(materials));
    for (const Material& material : materials) {
        for (const EngineChoice engine : {EngineChoice::opengl, EngineChoice::rays}) {
            RenderSettings settings = RenderSettings::direct();
            settings.engine = engine;
            InteractiveRenderer irsg =
                rendererOf({ballOf(material, 300.0)}, settings, environmentOf(air, {0.0, -0.5}));
            look(irsg, {.range_m = 60.0, .band = band});
            const RadianceImage image = irsg.imageWithReport().image;
            for (const float value : image.primary().values) {
                ASSERT_NEAR(static_cast<double>(value) / (black * band.area_um()), 1.0, 2e-6)
                    << material.surfaceModel << " " << material.roughness << " "
                    << static_cast<int>(engine);
            }
        }
    }
}

namespace {

/// Six walls and a ball inside, of as many models, all of 400 K.
Entity furnace(bool isBlack, bool ofPublished = false) {
    Triangles mesh =
        reversed(boxMesh({2, 1.5, 1}, {{1, 1}, {1, 2}, {1, 3}, {1, 4}, {1, 5}, {1, 6}}));
    mesh = joined(mesh, sphereMesh(0.5, 6, 10, {1, 7}));
    SignatureDatabase database = greyDatabase(0.9, 400.0);
    database.materials[2] = facets("ggx", 0.3, 0.3);
    database.materials[3] = facets("beckmann", 0.05, 0.1);
    database.materials[4] = facets("ggx", 0.6, 0.5, 1.5, 4.0);
    database.materials[5] = facets("beckmann", 0.7, 0.5);
    database.materials[6] = greyMaterial(0.4);
    database.materials[7] = facets("ggx", 0.01, 0.05);
    database.materials[7].emissivity = Spectrum({2.0, 3.5, 4.2, 6.0}, {0.05, 0.6, 0.2, 0.05});
    if (ofPublished) {
        const std::vector<Material> published = publishedSurfaces();
        for (int m = 0; m < 4; ++m) {
            database.materials[m + 3] = published[static_cast<std::size_t>(m)];
        }
    }
    for (int m = 1; isBlack && m <= 7; ++m) {
        database.materials[m] = greyMaterial(1.0);
    }
    Entity entity = entityOf(modelOf(mesh), database);
    entity.pose.position_m.z = standingAltitude_m;
    entity.referencePoint_m = Vec3{};
    return entity;
}

} // namespace

TEST_F(DirectionalSurfaces, MakeAClosedRoomBlack) {
    struct Case {
        double error, most;
        bool ofPublished;
    };
    for (const auto& [error, most, ofPublished] :
         {Case{0.005, 1e-3, false}, Case{0.002, 1e-4, false}, Case{0.005, 1e-3, true}}) {
        const auto [least, greatest] =
            ratiosOf(pixelsInRoom(furnace(false, ofPublished), convergedBounces, error),
                     pixelsInRoom(furnace(true, ofPublished), 0, error));
        std::printf("  lightError %g: pixels %.2e to %.2e off\n", error, least - 1.0,
                    greatest - 1.0);
        EXPECT_GE(least, 1.0 - most);
        EXPECT_LE(greatest, 1.0 + most);
    }
}

namespace {

/// Brighter towards the zenith and the nadir from the horizon on, straight between the rows of
/// directions that are asked for.
class Sky : public ConstantAtmosphere {
  public:
    double at(double elevation_rad) const {
        elevation_rad -= horizonElevation_rad(standingAltitude_m);
        return elevation_rad >= 0.0 ? 0.5 + 0.3 * std::log1p(elevation_rad / 0.02)
                                    : 0.2 + 0.1 * std::log1p(std::sqrt(-elevation_rad / 0.02));
    }

  protected:
    Spectrum nativeSpectrum(const AtmosphericQuery& query,
                            const SpectralRange& range) const override {
        if (query.quantity == AtmosphereProperty::backgroundRadiance) {
            return Spectrum::constant(at(query.sight.elevation_rad));
        }
        return ConstantAtmosphere::nativeSpectrum(query, range);
    }
};

} // namespace

TEST_F(DirectionalSurfaces, ShowTheSkyAlongTheMirrorDirection) {
    Environment environment;
    const auto sky = std::make_shared<Sky>();
    environment.add(sky);
    environment.sun = {0.0, -0.5};
    // A level plate, smooth, seen from 40, 15 and 5 degrees above it; and one from below.
    Entity plate =
        entityOf(modelOf(plateMesh({}, {1, 0, 0}, {0, 1, 0}, {1, 1})), greyDatabase(0.5, 2.0));
    SignatureDatabase database = *plate.database;
    database.materials[1] = facets("beckmann", 0.005, 0.4);
    plate.database = std::make_shared<const SignatureDatabase>(database);
    for (const EngineChoice engine : {EngineChoice::opengl, EngineChoice::rays}) {
        for (const double elevation_deg : {40.0, 15.0, 5.0, -20.0}) {
            RenderSettings settings = RenderSettings::direct();
            settings.engine = engine;
            settings.background = BackgroundMode::none;
            InteractiveRenderer irsg = rendererOf({plate}, settings, environment);
            look(irsg, {.range_m = 300.0,
                        .elevation_rad = radians(elevation_deg),
                        .width_px = 65,
                        .height_px = 65,
                        .fieldOfView_rad = 0.004});
            const double cosine = std::sin(radians(std::abs(elevation_deg)));
            const double expected =
                width_um * schlick(0.6, cosine) * sky->at(radians(elevation_deg));
            EXPECT_NEAR(static_cast<double>(irsg.imageWithReport().image.at(32, 32)) / expected,
                        1.0, 0.003)
                << elevation_deg;
        }
    }
}

namespace {

/// A floor, a wall and a ball of metal, paint and rough facets in bright air.
Entity polishedCorner() {
    Triangles mesh = joined(plateMesh({}, {2, 0, 0}, {0, 2, 0}, {1, 1}),
                            plateMesh({0, 2, 1}, {0, 0, 1}, {2, 0, 0}, {2, 2}));
    Triangles ball = sphereMesh(0.4, 24, 48, {2, 3});
    for (Triangle& t : ball) {
        for (Vec3& v : t.vertex) {
            v = v + Vec3{0.3, -0.2, 0.6};
        }
    }
    mesh = joined(mesh, ball);
    SignatureDatabase database = greyDatabase(0.4, 300.0);
    database.temperatures[2] = fixedTemperature(420.0);
    database.materials[1] = facets("ggx", 0.5, 0.4);
    database.materials[2] = facets("beckmann", 0.3, 0.3, 2.7, 3.8);
    database.materials[3] = facets("ggx", 0.2, 0.5);
    database.materials[3].emissivity = Spectrum({2.0, 3.5, 4.2, 6.0}, {0.2, 0.7, 0.3, 0.3});
    Entity entity = entityOf(modelOf(mesh), database);
    entity.pose.position_m.z = standingAltitude_m;
    return entity;
}

} // namespace

TEST_F(DirectionalSurfaces, AreTheSameByEveryWay) {
    std::array<double, 2> byEngine{};
    for (const EngineChoice engine : {EngineChoice::opengl, EngineChoice::rays}) {
        RenderSettings settings = RenderSettings::direct();
        settings.engine = engine;
        settings.sunShadows = SunShadowMode::point;
        settings.bounces = convergedBounces;
        settings.hotSpots = false; // windows that do not follow the scales
        InteractiveRenderer irsg = rendererOf({polishedCorner()}, settings, brightAtmosphere());
        View view;
        view.azimuth_rad = 2.2;
        view.elevation_rad = 0.7;
        view.fieldOfView_rad = 0.08;
        look(irsg, view);
        const double swept = irsg.measure().all.intensity_W_sr;
        byEngine[engine == EngineChoice::rays ? 1 : 0] = swept;
        EXPECT_NEAR(irsg.imageWithReport().report.all.intensity_W_sr / swept, 1.0, 2e-3);
        const RadianceImage drawn = irsg.picture(), summed = irsg.picture();
        for (std::size_t i = 0; i < drawn.find("L")->values.size(); ++i) {
            ASSERT_NEAR(drawn.find("L")->values[i], summed.find("L")->values[i],
                        2e-5f * std::abs(drawn.find("L")->values[i]) + 1e-6f);
        }
        std::vector<double> wavenumbers;
        for (int i = 0; i < 400; ++i) {
            wavenumbers.push_back(1e4 / (3.0 + 2.0 * (i + 0.5) / 400));
        }
        double sum = 0.0;
        for (const double value : irsg.measureSpectrum(wavenumbers).intensity_W_sr_um) {
            sum += value * 2.0 / 400;
        }
        EXPECT_NEAR(sum / swept, 1.0, 1e-3);

        // A view as a function of scales.
        const std::vector<ScalingInput> inputs{{0, ScalingKind::temperature, 2, 0.9, 1.1},
                                               {0, ScalingKind::emissivity, 2, 0.8, 1.2},
                                               {0, ScalingKind::emissivity, 3, 0.8, 1.2}};
        const auto scaled = irsg.scaledView(inputs);
        ScaledValues values;
        for (const std::array<double, 3>& scales :
             {std::array{1.0, 1.0, 1.0}, std::array{1.07, 1.0, 1.0}, std::array{0.95, 1.1, 1.0},
              std::array{1.0, 1.0, 0.9}}) {
            scaled->evaluate(scales, values);
            Entity other = polishedCorner();
            other.temperatureScale[2] = scales[0];
            other.emissivityScale[2] = scales[1];
            other.emissivityScale[3] = scales[2];
            InteractiveRenderer there =
                rendererOf({other}, irsg.scene.settings, brightAtmosphere());
            look(there, view);
            const double expected = there.measure().all.intensity_W_sr;
            // A mirror that another one shows keeps its reflectivity.
            EXPECT_NEAR(values.intensity[0] / expected, 1.0,
                        scales[1] == 1.0 && scales[2] == 1.0 ? 1e-4 : 1e-3)
                << scales[0] << " " << scales[1] << " " << scales[2];
        }

        // Truth layers add up to the picture, and what is explained of a pixel to the pixel.
        RenderSettings truth = irsg.scene.settings;
        truth.truthLayers = true;
        irsg.scene.settings = truth;
        const RadianceImage layers = irsg.imageWithReport().image;
        const std::vector<float>& whole = layers.find("L")->values;
        double mirrors = 0.0;
        const std::array names{"thermal",          "sun",       "up", "down", "path", "mirror",
                               "inter_reflection", "background"};
        for (const char* name : names) {
            ASSERT_NE(layers.find(name), nullptr) << name;
        }
        for (std::size_t i = 0; i < whole.size(); ++i) {
            double parts = 0.0;
            for (const char* name : names) {
                parts += static_cast<double>(layers.find(name)->values[i]);
            }
            mirrors += static_cast<double>(layers.find("mirror")->values[i]);
            ASSERT_NEAR(parts, static_cast<double>(whole[i]), 2e-5 * std::abs(parts) + 1e-6);
        }
        EXPECT_GT(mirrors, 0.0);
        if (engine != EngineChoice::rays) {
            continue;
        }
        const auto explainer = irsg.explainer();
        for (const int x : {20, 32, 40}) {
            const PixelExplanation pixel = explainer(x, 30);
            EXPECT_NEAR(pixel.radiance_W_m2_sr / static_cast<double>(layers.at(x, 30)), 1.0, 2e-5);
            double parts = pixel.backgroundLeft_W_m2_sr;
            for (const ExplainedSurface& surface : pixel.surfaces) {
                parts += surface.radiance_W_m2_sr;
            }
            EXPECT_NEAR(parts / pixel.radiance_W_m2_sr, 1.0, 1e-9);
        }
    }
    EXPECT_NEAR(byEngine[0] / byEngine[1], 1.0, 1e-3);
}

TEST_F(DirectionalSurfaces, AreRefusedWhereTheModelIsUnknown) {
    Entity ball = ballOf(facets("phong", 0.2, 0.5), 300.0, 8);
    InteractiveRenderer irsg = rendererOf({ball}, RenderSettings{});
    look(irsg, {});
    EXPECT_THROW(irsg.measure(), InputError);
}
