// Rays in place of OpenGL: the same answers to the same samples, without EGL.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>

#include <osg/Geode>
#include <osg/Geometry>
#include <osg/Texture2D>

#include "irsg/core/Errors.h"
#include "irsg/core/ParallelFor.h"
#include "irsg/radiometry/Units.h"
#include "irsg/render/background/Terrain.h"
#include "irsg/render/rays/RayMesh.h"
#include "irsg/scene/PreparedEntities.h"
#include "tests/support/MadeGraphs.h"
#include "tests/support/Refusal.h"
#include "tests/support/SceneFixtures.h"

using namespace irsg;
using namespace irsg::test;
using smat::test::refusalOf;

namespace {

class RayEngineTest : public testing::Test {
  protected:
    void SetUp() override {
        if (!areRaysBuilt()) {
            GTEST_SKIP() << whyNoRays();
        }
    }
    void TearDown() override { setMostThreads(0); }
};

InteractiveRenderer withEngine(EngineChoice engine, RenderSettings settings,
                               const std::vector<Entity>& entities, const View& view) {
    InteractiveRenderer irsg{RenderSettings::direct()};
    settings.engine = engine;
    irsg.scene.settings = settings;
    irsg.scene.environment = brightAtmosphere();
    irsg.scene.entities = entities;
    look(irsg, view);
    return irsg;
}

/// One sample a pixel.
RenderSettings plainPixels() {
    RenderSettings settings = RenderSettings::direct();
    settings.tileSide_samples = 0;
    settings.samplesPerAxis = 1;
    settings.truthLayers = true;
    return settings;
}

/// Every pair of codes of a model has an entry; materials of an odd index above 4 let light
/// through.
Entity dressed(const std::shared_ptr<const Model>& model) {
    SignatureDatabase database;
    for (const auto& [codes, use] : model->codes()) {
        database.temperatures[codes.temperature] =
            fixedTemperature(300.0 + 7.0 * codes.temperature);
        const bool isClear = codes.material > 4 && codes.material % 2 == 1;
        database.materials[codes.material] =
            greyMaterial(isClear ? 0.3 : 0.9, isClear ? 0.6 : 0.0, codes.material % 3);
    }
    return entityOf(model, database);
}

/// For every pixel what its middle meets, near to far; of one entity at standing altitude.
std::vector<std::vector<std::pair<int, unsigned>>> facetsOf(const InteractiveRenderer& irsg) {
    const Entity& entity = irsg.scene.entities.front();
    PreparedEntities prepared;
    prepared.keep(irsg.scene.entities);
    PreparedModel& model = prepared.of(entity);
    const RayMesh& mesh = *model.forRays();
    PieceUses uses(model.mesh().pieces.size());
    for (std::size_t i = 0; i < model.mesh().pieces.size(); ++i) {
        const Mesh::Part& part = model.mesh().partOf(model.mesh().pieces[i]);
        uses.set(i, {true, !materialEntry(entity, part.codes.material)->isOpaque(), part.culled,
                     part.layer});
    }
    const Sensor& sensor = irsg.view.sensor;
    const Viewpoint& eye = irsg.view.viewpoint;
    const double pitch = sensor.pixelPitch();
    std::vector<std::vector<std::pair<int, unsigned>>> met;
    for (int y = 0; y < sensor.height_px; ++y) {
        for (int x = 0; x < sensor.width_px; ++x) {
            const Vec3 along = eye.forward() +
                               eye.right * ((x + 0.5 - 0.5 * sensor.width_px) * pitch) +
                               eye.up * ((0.5 * sensor.height_px - y - 0.5) * pitch);
            const Rotation toModel = entity.pose.attitude.rotation().transposed();
            const Ray ray{toModel * (eye.position_m - entity.pose.position_m),
                          toModel * normalized(along)};
            RayHit opaque;
            std::vector<RayHit> hits;
            if (mesh.meet(ray, uses, pitch, opaque, hits)) {
                hits.push_back(opaque);
            }
            std::ranges::sort(hits, {}, &RayHit::order_m);
            auto& own = met.emplace_back();
            for (const RayHit& hit : hits) {
                own.emplace_back(hit.piece, hit.facet);
            }
        }
    }
    return met;
}

bool isInterior(const std::vector<std::vector<std::pair<int, unsigned>>>& met, int width, int x,
                int y) {
    const auto at = [&](int i, int j) { return met[static_cast<std::size_t>(j * width + i)]; };
    for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
            if (at(x + dx, y + dy) != at(x, y)) {
                return false;
            }
        }
    }
    return !at(x, y).empty();
}

/// The largest difference of every channel where neighbours meet the same facets, relative to the
/// radiance there; expects some pixels to compare.
void expectAlike(const std::vector<Entity>& entities, const View& view, double tolerance,
                 RenderSettings settings = plainPixels()) {
    InteractiveRenderer drawn = withEngine(EngineChoice::opengl, settings, entities, view);
    InteractiveRenderer traced = withEngine(EngineChoice::rays, settings, entities, view);
    const RenderedImage a = drawn.imageWithReport(), b = traced.imageWithReport();
    const auto met = facetsOf(drawn);
    const int width = a.image.width(), height = a.image.height();
    double worst = 0.0;
    int compared = 0, others = 0, covered = 0;
    for (int y = 1; y + 1 < height; ++y) {
        for (int x = 1; x + 1 < width; ++x) {
            const std::size_t i = a.image.offset(x, y);
            const auto here = [&](const RenderedImage& made, const std::string& name) {
                return static_cast<double>(made.image.find(name)->values[i]);
            };
            const bool isInside = isInterior(met, width, x, y);
            covered += !met[static_cast<std::size_t>(y * width + x)].empty();
            double most = 0.0;
            for (const char* name : {"L", "thermal", "sun", "up", "down", "path"}) {
                most = std::max(most, std::abs(here(a, name) - here(b, name)) / here(a, "L"));
            }
            if (isInside) {
                worst = std::max(worst, most);
                worst = std::max(worst, std::abs(here(b, "range") / here(a, "range") - 1.0));
                EXPECT_EQ(here(a, "material_index"), here(b, "material_index")) << x << ", " << y;
                ++compared;
            } else if (most > tolerance) {
                ++others;
            }
        }
    }
    ASSERT_GT(compared, 50);
    EXPECT_LE(worst, tolerance);
    EXPECT_LE(others, 1 + covered / 100) << "samples on edges that fell to another facet";
    const double intensity = a.report.all.intensity_W_sr;
    EXPECT_NEAR(b.report.all.intensity_W_sr / intensity, 1.0, 2e-3);
    EXPECT_EQ(a.report.layersLeftOver, b.report.layersLeftOver);
    std::printf("  %d samples compared, largest relative difference %.1e, %d of %d on edges\n",
                compared, worst, others, covered - compared);
}

std::shared_ptr<const Model> sampleModel(const std::string& name) {
    return Model::load(std::string(SMAT_SOURCE_DIR) + "/samples/" + name + "/" + name + ".flt");
}

osg::ref_ptr<osg::Geode> texturedSheet(const Vec3& corner, const Vec3& along, const Vec3& up) {
    const auto place = [](const Vec3& v) {
        return osg::Vec3(static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z));
    };
    const osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    const osg::Vec3 vertices[] = {place(corner), place(corner + along), place(corner + along + up),
                                  place(corner + up)};
    const osg::Vec2 places[] = {{0, 0}, {3, 0}, {3, 2}, {0, 2}};
    geometry->setVertexArray(new osg::Vec3Array(4, vertices));
    geometry->setTexCoordArray(0, new osg::Vec2Array(4, places));
    geometry->addPrimitiveSet(new osg::DrawArrays(GL_QUADS, 0, 4));
    const osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(16, 16, 1, GL_LUMINANCE, GL_FLOAT);
    for (unsigned y = 0; y < 16; ++y) {
        for (unsigned x = 0; x < 16; ++x) {
            *reinterpret_cast<float*>(image->data(x, y)) =
                static_cast<float>((x * 7 + y * 13) % 17) / 17.0f;
        }
    }
    const osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    geode->addDrawable(geometry);
    osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D(image);
    texture->setWrap(osg::Texture::WRAP_S, osg::Texture::REPEAT);
    texture->setWrap(osg::Texture::WRAP_T, osg::Texture::MIRROR);
    geode->getOrCreateStateSet()->setTextureAttributeAndModes(0, texture);
    return geode;
}

} // namespace

TEST_F(RayEngineTest, GivesEverySampleOfTheSamplesWhatOpenGlGives) {
    struct Aspect {
        const char* name;
        double azimuth_rad, elevation_rad, fieldOfView_rad; ///< of 20 diagonals away
    };
    const Aspect aspects[] = {{"turboprop4", 0.4, -0.3, 0.05}, {"turboprop4", 2.6, 0.5, 0.05},
                              {"turboprop4", 1.2, 0.1, 0.008}, {"turboprop4", 3.0, 0.2, 0.008},
                              {"ship", 0.4, 0.5, 0.05},        {"ship", 2.6, 0.1, 0.008},
                              {"box", 0.4, -0.3, 0.05},        {"box", 2.6, 0.5, 0.05},
                              {"sphere", 0.4, 0.5, 0.004},     {"chessboard", 0.4, 0.5, 0.05},
                              {"chessboard", 2.6, 0.05, 0.008}};
    for (const Aspect& aspect : aspects) {
        const auto model = sampleModel(aspect.name);
        Entity entity = dressed(model);
        entity.pose.position_m.z = standingAltitude_m;
        SCOPED_TRACE(testing::Message()
                     << aspect.name << " " << aspect.azimuth_rad << " " << aspect.elevation_rad);
        expectAlike({entity},
                    {.range_m = 20.0 * model->bounds().diagonal_m(),
                     .azimuth_rad = aspect.azimuth_rad,
                     .elevation_rad = aspect.elevation_rad,
                     .width_px = 320,
                     .height_px = 240,
                     .fieldOfView_rad = aspect.fieldOfView_rad},
                    1e-5);
    }
}

TEST_F(RayEngineTest, HasTheFactorsOfTheShaderUnderEverySetting) {
    SignatureDatabase database = greyDatabase(0.4, 320.0, 2.5);
    Entity entity = entityOf(modelOf(sphereMesh(1.0, 12, 24, {1, 1})), database);
    entity.pose.position_m.z = standingAltitude_m;
    for (const ReflectionMode mode :
         {ReflectionMode::off, ReflectionMode::approx, ReflectionMode::smart}) {
        for (const FluxWeights weights : {FluxWeights::viewFactor, FluxWeights::report}) {
            RenderSettings settings = plainPixels();
            settings.sun = settings.ambientReflection = mode;
            settings.fluxWeights = weights;
            SCOPED_TRACE(static_cast<int>(mode));
            expectAlike({entity}, {.width_px = 200, .height_px = 200, .fieldOfView_rad = 0.025},
                        1e-5, settings);
        }
    }
}

TEST_F(RayEngineTest, KeepsItsDigitsFarAwayAndFarFromTheOrigin) {
    Entity entity = dressed(modelOf(glazedMesh()));
    entity.database = std::make_shared<const SignatureDatabase>([] {
        SignatureDatabase database;
        for (int i = 1; i <= 3; ++i) {
            database.temperatures[i] = fixedTemperature(300.0 + 20.0 * i);
            database.materials[i] = greyMaterial(0.5, i == 3 ? 0.4 : 0.0);
        }
        return database;
    }());
    entity.pose.position_m = {6.4e6, -6.4e6, standingAltitude_m};
    entity.pose.attitude = {0.3, 0.2, -0.4};
    expectAlike({entity},
                {.range_m = 2e5,
                 .azimuth_rad = 0.7,
                 .elevation_rad = 0.5,
                 .width_px = 240,
                 .height_px = 200,
                 .fieldOfView_rad = 2.5e-5},
                1e-5);
}

TEST_F(RayEngineTest, SamplesTheSameTilesSoThatSumsAreThoseOfOpenGl) {
    const auto model = sampleModel("turboprop4");
    Entity entity = dressed(model);
    entity.pose.position_m.z = standingAltitude_m;
    for (const double range_m : {150.0, 1000.0, 20000.0, 3e6}) {
        const View view{.range_m = range_m,
                        .azimuth_rad = 0.9,
                        .elevation_rad = 0.2,
                        .width_px = 160,
                        .height_px = 128,
                        .fieldOfView_rad = 0.04};
        InteractiveRenderer drawn = withEngine(EngineChoice::opengl, {}, {entity}, view);
        InteractiveRenderer traced = withEngine(EngineChoice::rays, {}, {entity}, view);
        const RenderReport a = drawn.measure(), b = traced.measure();
        EXPECT_NEAR(b.all.intensity_W_sr / a.all.intensity_W_sr, 1.0, 1e-3) << range_m;
        EXPECT_NEAR(b.all.solidAngle_sr / a.all.solidAngle_sr, 1.0, 1e-3) << range_m;
        std::printf("  %8.0f m: %.1e\n", range_m,
                    b.all.intensity_W_sr / a.all.intensity_W_sr - 1.0);
        const RenderedImage drawnImage = drawn.imageWithReport(),
                            tracedImage = traced.imageWithReport();
        EXPECT_EQ(drawnImage.image.attributes.at("windows"),
                  tracedImage.image.attributes.at("windows"));
        EXPECT_NEAR(tracedImage.report.all.intensity_W_sr / drawnImage.report.all.intensity_W_sr,
                    1.0, 1e-3);
    }
}

TEST_F(RayEngineTest, GivesTheSameBytesWithAnyNumberOfThreads) {
    const auto model = sampleModel("turboprop4");
    Entity entity = dressed(model);
    entity.pose.position_m.z = standingAltitude_m;
    const View view{.range_m = 500.0,
                    .azimuth_rad = 2.2,
                    .elevation_rad = 0.3,
                    .width_px = 160,
                    .height_px = 128,
                    .fieldOfView_rad = 0.1};
    std::vector<std::vector<float>> pictures;
    std::vector<double> sums;
    for (const unsigned threads : {1u, 2u, 5u}) {
        setMostThreads(threads);
        InteractiveRenderer irsg = withEngine(EngineChoice::rays, {}, {entity}, view);
        pictures.push_back(irsg.imageWithReport().image.primary().values);
        sums.push_back(irsg.measure().all.intensity_W_sr);
    }
    for (std::size_t i = 1; i < pictures.size(); ++i) {
        EXPECT_EQ(pictures[i], pictures[0]);
        EXPECT_EQ(sums[i], sums[0]);
    }
}

TEST_F(RayEngineTest, SeesTerrainBehindAndBeforeObjects) {
    // A wall that hides the right half of a plate, and another behind it.
    const osg::ref_ptr<osg::Group> group = new osg::Group;
    group->addChild(texturedSheet({0.3, -2, -9}, {6, 0.5, 0}, {0, 0, 18}));
    group->addChild(texturedSheet({-9, 3, -9}, {18, 0, 0}, {0, 1, 18}));
    const auto terrain = terrainOfGraph(*group, "walls", {0, 0, standingAltitude_m});
    Entity entity =
        entityOf(modelOf(plateMesh({}, {2, 0, 0}, {0, 0, 2}, {1, 1})), greyDatabase(0.7, 330.0));
    entity.pose.position_m.z = standingAltitude_m;
    for (const int tileSide_samples : {0, 256}) {
        RenderSettings settings = RenderSettings::direct();
        settings.tileSide_samples = tileSide_samples;
        settings.terrain = {5.0, 0.2};
        std::vector<RadianceImage> images;
        for (const EngineChoice engine : {EngineChoice::opengl, EngineChoice::rays}) {
            InteractiveRenderer irsg = withEngine(engine, settings, {entity},
                                                  {.range_m = 20.0,
                                                   .azimuth_rad = pi,
                                                   .width_px = 90,
                                                   .height_px = 70,
                                                   .fieldOfView_rad = 0.5});
            irsg.scene.terrain = terrain;
            images.push_back(irsg.imageWithReport().image);
        }
        int differ = 0;
        double most = 0.0, mean = 0.0;
        for (std::size_t i = 0; i < images[0].primary().values.size(); ++i) {
            const double off = std::abs(static_cast<double>(images[0].primary().values[i]) -
                                        static_cast<double>(images[1].primary().values[i]));
            most = std::max(most, off);
            mean += static_cast<double>(images[0].primary().values[i]);
            differ += off > 0.01;
        }
        mean /= static_cast<double>(images[0].primary().values.size());
        EXPECT_GT(mean, 0.5);
        EXPECT_LE(differ, 40) << most; // along the walls' edges
        std::printf("  mean %.3f, %d pixels differ by more than 0.01, most %.2e\n", mean, differ,
                    most);
    }
}

TEST_F(RayEngineTest, AsksForNoEgl) {
    // In a process of its own: others of this program have drawn.
    if (!std::getenv("SMAT_TEST_RUNS_AGAIN")) {
        const std::string again =
            "SMAT_TEST_RUNS_AGAIN=1 __EGL_VENDOR_LIBRARY_FILENAMES=/dev/null /proc/" +
            std::to_string(getpid()) + "/exe --gtest_filter=RayEngineTest.AsksForNoEgl";
        EXPECT_EQ(std::system(again.c_str()), 0);
        return;
    }
    Entity entity = dressed(sampleModel("box"));
    entity.pose.position_m.z = standingAltitude_m;
    InteractiveRenderer irsg = withEngine(EngineChoice::rays, {}, {entity}, {.range_m = 200.0});
    EXPECT_GT(irsg.imageWithReport().report.all.intensity_W_sr, 0.0);
    EXPECT_NE(irsg.rendererDescription().find("Embree"), std::string::npos);
    std::ifstream maps("/proc/self/maps");
    for (std::string line; std::getline(maps, line);) {
        EXPECT_EQ(line.find("libEGL"), std::string::npos) << line;
    }
    // Without OpenGL auto takes rays, and OpenGL is refused.
    RenderSettings settings = irsg.scene.settings;
    settings.engine = EngineChoice::automatic;
    irsg.scene.settings = settings;
    EXPECT_NE(irsg.imageWithReport().report.renderer.find("(auto: this machine has no OpenGL)"),
              std::string::npos);
    settings.engine = EngineChoice::opengl;
    irsg.scene.settings = settings;
    EXPECT_THROW(irsg.imageWithReport(), InputError);
}

TEST_F(RayEngineTest, IsChosenByItselfAndSaysSo) {
    Entity few = dressed(sampleModel("box"));
    few.pose.position_m.z = standingAltitude_m;
    Entity many = entityOf(modelOf(sphereMesh(1.0, 330, 330, {1, 1})), greyDatabase(0.5, 300.0));
    many.pose.position_m.z = standingAltitude_m;
    InteractiveRenderer irsg = withEngine(EngineChoice::automatic, {}, {few}, {});
    const std::string drawn = irsg.imageWithReport().report.renderer;
    EXPECT_NE(drawn.find("(auto: "), std::string::npos) << drawn;
    if (drawn.find("llvmpipe") == std::string::npos) {
        GTEST_SKIP() << "a graphics card draws any scene";
    }
    irsg.scene.entities = {many};
    const std::string traced = irsg.imageWithReport().report.renderer;
    EXPECT_NE(traced.find("Embree"), std::string::npos) << traced;
    EXPECT_EQ(irsg.rendererDescription(), traced);
}

TEST(RaysAbsent, AreRefusedByName) {
    if (areRaysBuilt()) {
        GTEST_SKIP() << "this build has rays";
    }
    Entity entity =
        entityOf(modelOf(boxMesh({1, 1, 1}, {{1, 1}, {1, 1}, {1, 1}, {1, 1}, {1, 1}, {1, 1}})),
                 greyDatabase(0.5, 300.0));
    entity.pose.position_m.z = standingAltitude_m;
    InteractiveRenderer irsg = withEngine(EngineChoice::rays, {}, {entity}, {});
    EXPECT_NE(refusalOf([&] { irsg.imageWithReport(); }).find("render.engine"), std::string::npos);
}
