#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>

#include "benchmarks/antialiasing/Bodies.h"
#include "benchmarks/antialiasing/Study.h"
#include "irsg/radiometry/Planck.h"
#include "irsg/radiometry/Units.h"
#include "irsg/signature/SignatureFile.h"

namespace irsg::study {

namespace {

constexpr IrCodes skin{1, 1}, hot{2, 1};
constexpr double wallWidth_m = 30.0, wallHeight_m = 10.0, diameter_m = 0.12;
constexpr double pixelOfSensor_rad = 8e-5;

/// A number from 0 to 1, another for every step, irrational to any lattice.
double part(int step, double ratio) {
    return std::fmod((step + 0.5) * ratio, 1.0);
}

/// A cold wall with hot balls and plates before it, all over it.
struct Scene {
    test::Triangles mesh;
    double hot_m2 = 0.0; ///< as seen from the front and from far

    explicit Scene(int spots)
        : mesh(test::plateMesh({}, {0, 0, 0.5 * wallHeight_m}, {0.5 * wallWidth_m, 0, 0}, skin)) {
        constexpr double far_m = 1e5;
        for (int i = 0; i < spots; ++i) {
            const Vec3 place{wallWidth_m * 0.96 * (part(i, 0.7548776662) - 0.5), 0.1,
                             wallHeight_m * 0.96 * (part(i, 0.5698402910) - 0.5)};
            if (i % 2) {
                mesh = test::joined(mesh, test::plateMesh(place, {0.02, 0, 0.5 * diameter_m},
                                                          {0.5 * diameter_m, 0, -0.02}, hot));
                hot_m2 += diameter_m * diameter_m + 4.0 * 0.02 * 0.02;
            } else {
                const test::Triangles ball = test::sphereMesh(0.5 * diameter_m, 8, 16, hot);
                hot_m2 += test::convexSolidAngle_sr(ball, {0, far_m, 0}) * far_m * far_m;
                test::Triangles moved = ball;
                for (test::Triangle& triangle : moved)
                    for (Vec3& vertex : triangle.vertex)
                        vertex = vertex + place;
                mesh = test::joined(mesh, moved);
            }
        }
    }
    Entity entity() const {
        SignatureDatabase database;
        database.materials[1] = test::greyMaterial(1.0);
        database.temperatures[1] = test::fixedTemperature(280.0);
        database.temperatures[2] = test::fixedTemperature(900.0);
        return test::entityOf(test::modelOf(mesh), database);
    }
    double truth_W_sr() const {
        const auto radiance = [](double temperature_K) {
            return bandRadiance_W_m2_sr(Band::topHat(3.0, 5.0), temperature_K);
        };
        return (wallWidth_m * wallHeight_m - hot_m2) * radiance(280.0) + hot_m2 * radiance(900.0);
    }
};

struct Sum {
    double squares = 0.0, largest = 0.0, time_ms = 0.0;
    int count = 0;

    void add(double error, double ms) {
        squares += error * error;
        largest = std::max(largest, std::abs(error));
        time_ms += ms;
        ++count;
    }
    void print(const char* name) const {
        std::printf("%-34s RMS %8.4f %%  largest %8.4f %%  %8.2f ms\n", name,
                    100.0 * std::sqrt(squares / count), 100.0 * largest, time_ms / count);
        std::fflush(stdout);
    }
};

void place(InteractiveRenderer& irsg, double azimuth_rad, double elevation_rad, double range_m,
           int phase) {
    irsg.scene.entities[0].pose = {{0, 0, test::standingAltitude_m}, {}};
    test::look(irsg, {.range_m = range_m,
                      .azimuth_rad = azimuth_rad,
                      .elevation_rad = elevation_rad,
                      .width_px = 640,
                      .height_px = 512,
                      .fieldOfView_rad = 2.0 * std::atan(320.0 * pixelOfSensor_rad)});
    irsg.scene.entities[0].pose = {
        Vec3{0, 0, test::standingAltitude_m} +
            phaseShift_m(irsg.view.viewpoint, pixelOfSensor_rad * range_m, phase),
        {}};
}

double timed_W_sr(InteractiveRenderer& irsg, double& ms) {
    const auto start = std::chrono::steady_clock::now();
    const double found_W_sr = irsg.imageWithReport().report.all.intensity_W_sr;
    ms =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    return found_W_sr;
}

RenderSettings settingsOf(int tileSide_samples) {
    RenderSettings settings = Method{"aligned", 4, false}.settings();
    settings.sun = settings.ambientReflection = ReflectionMode::off;
    settings.tileSide_samples = tileSide_samples;
    return settings;
}

} // namespace

void measureSpots(const Options& options) {
    std::printf("Balls and plates of %.2f m at 900 K before a wall of 30 m x 10 m at 280 K\n",
                diameter_m);
    InteractiveRenderer irsg{RenderSettings::direct()};
    irsg.scene.environment = test::environmentOf(test::ConstantAtmosphere{});
    for (const int spots : {1, 2, 4, 8, 15, 16, 17, 18, 24, 48, 100, 200}) {
        const Scene scene(spots);
        irsg.scene.entities = {scene.entity()};
        for (const int size : {128, 256, 512}) {
            irsg.scene.settings = settingsOf(size);
            Sum sum;
            for (const double range_m : {2e3, 6.3e3, 1.3e4, 4e4})
                for (int phase = 0; phase < options.phases; ++phase) {
                    place(irsg, 0.0, 0.0, range_m, phase);
                    double ms = 0.0;
                    const double found_W_sr = timed_W_sr(irsg, ms);
                    sum.add(found_W_sr / scene.truth_W_sr() - 1.0, ms);
                }
            char name[80];
            std::snprintf(name, sizeof name, "%d spots, window %d", spots, size);
            sum.print(name);
        }
    }
    // From behind nothing hot is seen.
    const Scene scene(16);
    irsg.scene.entities = {scene.entity()};
    for (const bool hotSpots : {false, true})
        for (const int size : {128, 256, 512}) {
            RenderSettings settings = settingsOf(size);
            settings.hotSpots = hotSpots;
            irsg.scene.settings = settings;
            Sum sum;
            const double truth_W_sr =
                wallWidth_m * wallHeight_m * bandRadiance_W_m2_sr(Band::topHat(3.0, 5.0), 280.0);
            for (int phase = 0; phase < options.phases; ++phase) {
                place(irsg, pi, 0.0, 4e3, phase);
                double ms = 0.0;
                const double found_W_sr = timed_W_sr(irsg, ms);
                sum.add(found_W_sr / truth_W_sr - 1.0, ms);
            }
            char name[80];
            std::snprintf(name, sizeof name, "from behind, window %d%s", size,
                          hotSpots ? ", hot spots" : "");
            sum.print(name);
        }
}

void measureNoses(const Options& options) {
    std::printf("A box of 86 x 4 pixels and slimmer, turned in steps of a degree\n");
    InteractiveRenderer irsg{RenderSettings::direct()};
    irsg.scene.environment = test::environmentOf(test::ConstantAtmosphere{});
    const double radiance = bandRadiance_W_m2_sr(Band::topHat(3.0, 5.0), 280.0);
    for (const double thickness_m : {4.0, 1.2, 0.4}) {
        const test::Triangles mesh =
            test::boxMesh({43.0, 30.0, 0.5 * thickness_m}, std::vector<IrCodes>(6, skin));
        SignatureDatabase database;
        database.materials[1] = test::greyMaterial(1.0);
        database.temperatures[1] = test::fixedTemperature(280.0);
        irsg.scene.entities = {test::entityOf(test::modelOf(mesh), database)};
        for (const int size : {128, 256, 512}) {
            irsg.scene.settings = settingsOf(size);
            Sum sum, jump;
            double before = 0.0;
            for (int step = 0; step < 8 * options.phases; ++step) {
                const double elevation_rad = radians(0.1 * step / options.phases);
                place(irsg, 0.0, elevation_rad, 1.0 / pixelOfSensor_rad, step);
                const Vec3 away =
                    irsg.view.viewpoint.position_m - irsg.scene.entities[0].pose.position_m;
                double ms = 0.0;
                const double error =
                    timed_W_sr(irsg, ms) /
                        (radiance * test::convexSolidAngle_sr(mesh, away) * dot(away, away)) -
                    1.0;
                sum.add(error, ms);
                if (step > 0)
                    jump.add(error - before, ms);
                before = error;
            }
            char name[80];
            std::snprintf(name, sizeof name, "86 x %g, window %d", thickness_m, size);
            sum.print(name);
            jump.print("  from one to the next");
        }
    }
}

void measurePolar(const Options&) {
    std::printf("Polar of the four-engined aircraft in steps of a degree, 5 km\n");
    const std::string folder = std::string(SMAT_SOURCE_DIR) + "/samples/turboprop4/";
    Entity entity = test::entityOf(Model::load(folder + "turboprop4.flt"),
                                   loadSignatureFile(folder + "turboprop4.sigdb").database);
    entity.state.power = 0.7;
    entity.state.mach = 0.4;
    InteractiveRenderer irsg{RenderSettings::direct()};
    irsg.scene.environment = test::environmentOf(test::ConstantAtmosphere{});
    irsg.scene.entities = {entity};
    constexpr double range_m = 5e3;
    std::vector<double> truth_W_sr;
    for (const int size : {2048, 128, 256, 512}) {
        irsg.scene.settings = settingsOf(size);
        Sum sum, jump;
        double before = 0.0;
        for (int step = 0; step < 360; step += size == 2048 ? 6 : 1) {
            place(irsg, radians(step), radians(5.0), range_m, 0);
            double ms = 0.0;
            const auto start = std::chrono::steady_clock::now();
            const double found_W_sr = irsg.measure().all.intensity_W_sr;
            ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
                     .count();
            if (size == 2048) {
                truth_W_sr.push_back(found_W_sr);
                continue;
            }
            if (step % 6 == 0) {
                const double error =
                    found_W_sr / truth_W_sr[static_cast<std::size_t>(step / 6)] - 1.0;
                sum.add(error, ms);
                if (step > 0)
                    jump.add(error - before, ms);
                before = error;
            }
        }
        if (size == 2048)
            continue;
        char name[80];
        std::snprintf(name, sizeof name, "window %d", size);
        sum.print(name);
        jump.print("  from one to the next");
    }
}

} // namespace irsg::study
