// Frames of rays beside those of OpenGL: one sample in each pixel of 640 x 512, of spheres with
// more and more facets and of the four-engined aircraft, without and with shadows of the sun and
// light between surfaces, and with surfaces that reflect by direction; a polar of 360 aspects of
// the latter; and what the view factors between the surfaces of models cost.
//
//     bench_rays [factors] [light] [frames] [engines] [--aspects=360]    all of it without a word
//
// Times are those of all processors together, which what else the machine does hardly changes.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <memory>
#include <string>
#include <vector>

#include "irsg/radiance/exchange/BodyLight.h"
#include "irsg/radiometry/Units.h"
#include "irsg/render/rays/RaysBuilt.h"
#include "irsg/scene/InteractiveRenderer.h"
#include "irsg/signature/SignatureFile.h"
#include "tests/support/SceneFixtures.h"

using namespace irsg;

namespace {

Entity sampleOf(const std::string& name) {
    const std::string folder = SMAT_SOURCE_DIR "/samples/" + name + "/";
    Entity entity = test::entityOf(Model::load(folder + name + ".flt"),
                                   loadSignatureFile(folder + name + ".sigdb").database);
    entity.pose.position_m.z = test::standingAltitude_m;
    return entity;
}

/// That all threads took so far.
double now_s() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// Median of some frames after the first, ms.
double frame_ms(InteractiveRenderer& irsg) {
    std::vector<double> times_ms;
    for (int i = 0; i < 9; ++i) {
        const double start_s = now_s();
        irsg.imageWithReport();
        times_ms.push_back(1e3 * (now_s() - start_s));
    }
    times_ms.erase(times_ms.begin());
    std::ranges::nth_element(times_ms, times_ms.begin() + 4);
    return times_ms[4];
}

/// The same with every surface of facets of GGX.
Entity glossy(const Entity& entity) {
    Entity other = entity;
    SignatureDatabase database = *entity.database;
    for (auto& [index, material] : database.materials) {
        material.surfaceModel = "ggx";
        material.roughness = 0.2;
    }
    other.database = std::make_shared<const SignatureDatabase>(std::move(database));
    return other;
}

/// Frames and a polar of sums with so many reflections, the first of them by itself; in times those
/// of the first line.
void measureLight(const Entity& entity, EngineChoice engine, int aspects) {
    std::printf("%-26s %9s %9s %7s %9s %7s %9s\n", engine == EngineChoice::rays ? "rays" : "OpenGL",
                "first, ms", "frame, ms", "times", "polar, s", "times", "W/sr");
    const double size_m = entity.model->bounds().diagonal_m();
    struct Case {
        const char* name;
        SunShadowMode shadows;
        int bounces;
        bool hasLobes;
    };
    double primary_ms = 0.0, primary_s = 0.0;
    for (const auto& [name, shadows, bounces, hasLobes] :
         {Case{"primary", SunShadowMode::off, 0, false},
          Case{"shadows", SunShadowMode::point, 0, false},
          Case{"shadows, 1 bounce", SunShadowMode::point, 1, false},
          Case{"shadows, converged", SunShadowMode::point, convergedBounces, false},
          Case{"lobes", SunShadowMode::off, 0, true},
          Case{"lobes, shadows, converged", SunShadowMode::point, convergedBounces, true}}) {
        InteractiveRenderer irsg{RenderSettings::direct()};
        RenderSettings settings = RenderSettings::direct();
        settings.engine = engine;
        settings.sunShadows = shadows;
        settings.bounces = bounces;
        settings.tileSide_samples = 0;
        settings.samplesPerAxis = 1;
        irsg.scene.settings = settings;
        irsg.scene.environment = test::brightAtmosphere();
        irsg.scene.entities = {hasLobes ? glossy(entity) : entity};
        test::View view{.range_m = 20.0 * size_m,
                        .azimuth_rad = radians(60.0),
                        .elevation_rad = radians(15.0),
                        .width_px = 640,
                        .height_px = 512,
                        .fieldOfView_rad = 0.05};
        test::look(irsg, view);
        const double before_s = now_s();
        irsg.imageWithReport();
        const double first_ms = 1e3 * (now_s() - before_s);
        const double each_ms = frame_ms(irsg);
        settings.tileSide_samples = 256;
        irsg.scene.settings = settings;
        irsg.measure();
        const double start_s = now_s();
        double sum_W_sr = 0.0;
        for (int aspect = 0; aspect < aspects; ++aspect) {
            view.azimuth_rad = radians(360.0 * aspect / aspects);
            test::look(irsg, view);
            sum_W_sr += irsg.measure().all.intensity_W_sr;
        }
        const double polar_s = now_s() - start_s;
        if (primary_ms == 0.0) {
            primary_ms = each_ms;
            primary_s = polar_s;
        }
        std::printf("%-26s %9.0f %9.1f %7.2f %9.2f %7.2f %9.4g\n", name, first_ms, each_ms,
                    each_ms / primary_ms, polar_s, polar_s / primary_s, sum_W_sr / aspects);
        std::fflush(stdout);
    }
}

/// What the view factors of a model cost that is seen for the first time.
void measureGeometry(const char* name, const Entity& entity) {
    const std::shared_ptr<const Mesh>& shape = entity.model->mesh();
    PieceUses uses(shape->pieces.size());
    for (std::size_t i = 0; i < shape->pieces.size(); ++i) {
        const Mesh::Part& part = shape->partOf(shape->pieces[i]);
        const Material& material = entity.database->materials.at(part.codes.material);
        uses.set(i, {true, !material.isOpaque(), part.culled, part.layer});
    }
    for (const double error : {0.02, 0.01, 0.005, 0.002}) {
        const double start_s = now_s();
        const std::shared_ptr<const RayMesh> mesh = RayMesh::of(shape);
        const ExchangeResolution resolution;
        const BodyLight light(
            std::make_shared<const ExchangeNodes>(
                std::make_shared<const ExchangeMesh>(mesh, uses, resolution), resolution),
            uses, error);
        std::printf("%-12s %8.3f %9.2f %9.4f %9zu %9zu %9.1f %9zu\n", name, error,
                    now_s() - start_s, light.error(), mesh->facets(), light.nodes().nodes(),
                    static_cast<double>(light.raysSent()) / static_cast<double>(mesh->facets()),
                    light.balance().pairs->size());
        std::fflush(stdout);
    }
}

/// What the rule of `render.engine` auto is made of (EngineCost): frames of spheres with so many
/// facets in pictures of so many samples, by both engines, with shells of glass about them, shadows
/// and lobes.
void measureEngines() {
    std::printf("%-10s %9s %8s", "facets", "samples", "shells");
    for (const char* what : {"plain", "shadows", "lobes"})
        std::printf(" %9s %9s", what, "rays");
    std::printf("\n");
    for (const double facets : {1e3, 1e4, 1e5, 1e6})
        for (const int side_px : {64, 256, 640})
            for (const int shells : {0, 2}) {
                if (shells > 0 && (facets != 1e4 || side_px == 64))
                    continue;
                const int latitudes = static_cast<int>(std::sqrt(facets / 4.0));
                reference::Triangles mesh = test::sphereMesh(1.0, latitudes, 2 * latitudes, {1, 1});
                for (int shell = 0; shell < shells; ++shell)
                    mesh = test::joined(mesh, test::sphereMesh(1.1 + 0.1 * shell, 16, 32, {2, 2}));
                SignatureDatabase database = test::greyDatabase(0.4, 300.0);
                database.temperatures[2] = test::fixedTemperature(300.0);
                database.materials[2] = test::greyMaterial(0.1, 0.8);
                Entity sphere = test::entityOf(test::modelOf(mesh), database);
                sphere.pose.position_m.z = test::standingAltitude_m;
                std::printf("%-10.0f %9d %8d", facets, side_px * side_px, shells);
                for (int what = 0; what < 3; ++what)
                    for (const EngineChoice engine : {EngineChoice::opengl, EngineChoice::rays}) {
                        InteractiveRenderer irsg{RenderSettings::direct()};
                        RenderSettings settings = RenderSettings::direct();
                        settings.engine = engine;
                        settings.sunShadows = what == 1 ? SunShadowMode::point : SunShadowMode::off;
                        settings.tileSide_samples = 0;
                        settings.samplesPerAxis = 1;
                        irsg.scene.settings = settings;
                        irsg.scene.environment = test::brightAtmosphere();
                        irsg.scene.entities = {what == 2 ? glossy(sphere) : sphere};
                        test::look(irsg, {.range_m = 50.0,
                                          .azimuth_rad = radians(60.0),
                                          .elevation_rad = radians(15.0),
                                          .width_px = side_px,
                                          .height_px = side_px,
                                          .fieldOfView_rad = 0.06});
                        std::printf(" %9.2f", frame_ms(irsg));
                        std::fflush(stdout);
                    }
                std::printf("\n");
            }
}

void measure(const char* name, const Entity& entity) {
    std::printf("%-24s", name);
    for (const SunShadowMode shadows :
         {SunShadowMode::off, SunShadowMode::point, SunShadowMode::disc})
        for (const EngineChoice engine : {EngineChoice::opengl, EngineChoice::rays}) {
            InteractiveRenderer irsg{RenderSettings::direct()};
            RenderSettings settings = RenderSettings::direct();
            settings.engine = engine;
            settings.sunShadows = shadows;
            settings.tileSide_samples = 0;
            settings.samplesPerAxis = 1;
            irsg.scene.settings = settings;
            irsg.scene.environment = test::brightAtmosphere();
            irsg.scene.entities = {entity};
            const double size_m = entity.model->bounds().diagonal_m();
            test::look(irsg, {.range_m = 20.0 * size_m,
                              .azimuth_rad = radians(60.0),
                              .elevation_rad = radians(15.0),
                              .width_px = 640,
                              .height_px = 512,
                              .fieldOfView_rad = 0.05});
            std::printf(" %9.1f", frame_ms(irsg));
            std::fflush(stdout);
        }
    std::printf("\n");
}

} // namespace

int main(int argc, char** argv) {
    if (!areRaysBuilt()) {
        std::printf("%s\n", whyNoRays().c_str());
        return 1;
    }
    std::vector<std::string> words(argv + 1, argv + argc);
    int aspects = 360;
    std::erase_if(words, [&](const std::string& word) {
        return std::sscanf(word.c_str(), "--aspects=%d", &aspects) == 1;
    });
    const auto isAsked = [&](const char* word) {
        return words.empty() || std::ranges::find(words, word) != words.end();
    };
    if (isAsked("engines"))
        measureEngines();
    Entity aircraft = sampleOf("turboprop4");
    if (isAsked("factors")) {
        std::printf("%-12s %8s %9s %9s %9s %9s %9s %9s\n", "factors", "asked", "cold, s", "error",
                    "facets", "nodes", "rays/fac.", "pairs");
        for (const char* name : {"turboprop4", "ship", "corvette", "heron"})
            measureGeometry(name, sampleOf(name));
    }
    // Grey surfaces, but for the shells of plumes: times are those of geometry.
    SignatureDatabase database;
    for (const auto& [codes, use] : aircraft.model->codes()) {
        database.temperatures[codes.temperature] = test::fixedTemperature(300.0);
        database.materials[codes.material] =
            test::greyMaterial(0.4, codes.material >= 5 && codes.material <= 7 ? 0.6 : 0.0);
    }
    aircraft.database = std::make_shared<const SignatureDatabase>(database);
    for (const EngineChoice engine : {EngineChoice::rays, EngineChoice::opengl})
        if (isAsked("light"))
            measureLight(aircraft, engine, aspects);
    if (!isAsked("frames"))
        return 0;
    std::printf("%-24s %9s %9s %9s %9s %9s %9s\n", "ms a frame", "OpenGL", "rays", "+ shadows", "",
                "+ disc", "");
    measure("turboprop4", aircraft);
    for (const double facets : {1e3, 1e5, 2e6}) {
        const int latitudes = static_cast<int>(std::sqrt(facets / 4.0));
        Entity sphere =
            test::entityOf(test::modelOf(test::sphereMesh(1.0, latitudes, 2 * latitudes, {1, 1})),
                           test::greyDatabase(0.4, 300.0));
        sphere.pose.position_m.z = test::standingAltitude_m;
        char name[32];
        std::snprintf(name, sizeof name, "%.0f facets", facets);
        measure(name, sphere);
    }
    return 0;
}
