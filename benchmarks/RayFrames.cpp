// Frames of rays beside those of OpenGL: one sample in each pixel of 640 x 512, of spheres with
// more and more facets and of the four-engined aircraft, without and with shadows of the sun.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <vector>

#include "irsg/radiometry/Units.h"
#include "irsg/scene/Irsg.h"
#include "irsg/scene/trace/RaysBuilt.h"
#include "tests/support/SceneFixtures.h"

using namespace irsg;

namespace {

/// Median of some frames after the first, ms.
double frame_ms(Irsg& irsg) {
    std::vector<double> times_ms;
    for (int i = 0; i < 9; ++i) {
        const auto start = std::chrono::steady_clock::now();
        irsg.render();
        times_ms.push_back(
            std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
                .count());
    }
    times_ms.erase(times_ms.begin());
    std::ranges::nth_element(times_ms, times_ms.begin() + 4);
    return times_ms[4];
}

void measure(const char* name, const Entity& entity) {
    std::printf("%-24s", name);
    for (const SunShadowMode shadows :
         {SunShadowMode::off, SunShadowMode::point, SunShadowMode::disc})
        for (const EngineChoice engine : {EngineChoice::opengl, EngineChoice::rays}) {
            Irsg irsg;
            RenderSettings settings;
            settings.engine = engine;
            settings.sunShadows = shadows;
            settings.zoomWindow = 0;
            settings.samplesPerAxis = 1;
            irsg.setSettings(settings);
            irsg.setEnvironment(test::brightAir());
            irsg.setEntities({entity});
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

int main() {
    if (!areRaysBuilt()) {
        std::printf("%s\n", whyNoRays().c_str());
        return 1;
    }
    std::printf("%-24s %9s %9s %9s %9s %9s %9s\n", "ms a frame", "OpenGL", "rays", "+ shadows", "",
                "+ disc", "");
    Entity aircraft =
        test::entityOf(Model::load(SMAT_SOURCE_DIR "/samples/turboprop4/turboprop4.flt"), {});
    SignatureDatabase database;
    for (const auto& [codes, use] : aircraft.model->codes()) {
        database.temperatures[codes.temperature] = test::fixedTemperature(300.0);
        database.materials[codes.material] =
            test::greyMaterial(0.4, codes.material >= 5 && codes.material <= 7 ? 0.6 : 0.0);
    }
    aircraft.database = std::make_shared<const SignatureDatabase>(database);
    aircraft.pose.position_m.z = test::standingAltitude_m;
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
