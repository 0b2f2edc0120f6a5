#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <memory>

#include "benchmarks/antialiasing/Bodies.h"
#include "benchmarks/antialiasing/Study.h"
#include "irsg/radiometry/Units.h"
#include "irsg/signature/SignatureFile.h"

namespace irsg::study {

namespace {

constexpr double size_m = 40.0;
constexpr double pixelOfSensor_rad = 8e-5;

Entity sampleAircraft() {
    const std::string folder = std::string(SMAT_SOURCE_DIR) + "/samples/turboprop4/";
    Entity entity = test::entityOf(Model::load(folder + "turboprop4.flt"),
                                   loadSignatureFile(folder + "turboprop4.sigdb").database);
    entity.state.power = 0.7;
    entity.state.mach = 0.4;
    return entity;
}

struct Way {
    Method method;
    bool hotSpots;

    std::string name() const { return method.name() + (hotSpots ? " with hot spots" : ""); }
    RenderSettings settings() const {
        RenderSettings result = method.settings();
        result.hotSpots = hotSpots;
        return result;
    }
};

std::vector<Way> ways() {
    std::vector<Way> result{{{"supersampling", 2, false}, false}};
    for (const bool hotSpots : {false, true})
        for (const int mode : {3, 4, 5})
            result.push_back({{"aligned", mode, false}, hotSpots});
    return result;
}

/// From a direction and range, the aircraft moved by a part of a pixel.
void place(InteractiveRenderer& irsg, double azimuth_rad, double range_m, int phase) {
    irsg.scene.entities[0].pose = {{0, 0, test::standingAltitude_m}, {}};
    test::look(irsg, {.range_m = range_m,
                      .azimuth_rad = azimuth_rad,
                      .elevation_rad = radians(10.0),
                      .width_px = 640,
                      .height_px = 512,
                      .fieldOfView_rad = 2.0 * std::atan(320.0 * pixelOfSensor_rad)});
    irsg.scene.entities[0].pose = {
        Vec3{0, 0, test::standingAltitude_m} +
            phaseShift_m(irsg.view.viewpoint, pixelOfSensor_rad * range_m, phase),
        {}};
}

} // namespace

void measureParts(const Options& options) {
    constexpr int phasesOfTruth = 4, steps = 12;
    constexpr double nearest_m = 2500.0, farthest_m = 40000.0;
    const std::vector<double> azimuths_deg = {60.0, 110.0, 160.0};
    const std::vector<Way> all = ways();

    InteractiveRenderer irsg{RenderSettings::direct()};
    irsg.scene.environment = test::environmentOf(test::ConstantAtmosphere{});
    irsg.scene.entities = {sampleAircraft()};
    struct Sum {
        double squares = 0.0, largest = 0.0, time_ms = 0.0;
        int count = 0;
    };
    std::vector<Sum> sums(all.size());
    std::ofstream file(options.folder / "parts.csv");
    file << "azimuth [deg],range [m],way,contrast_intensity [W sr-1],error [%],time [ms]\n";
    for (const double azimuth_deg : azimuths_deg)
        for (int step = 0; step <= steps; ++step) {
            const double range_m =
                nearest_m * std::pow(farthest_m / nearest_m, static_cast<double>(step) / steps);
            // The truth: windows of 2048 samples, parts and all, over several phases.
            RenderSettings fine = all.back().settings();
            fine.tileSide_samples = 2048;
            irsg.scene.settings = fine;
            double truth_W_sr = 0.0;
            for (int phase = 0; phase < phasesOfTruth; ++phase) {
                place(irsg, radians(azimuth_deg), range_m, phase);
                truth_W_sr +=
                    irsg.imageWithReport().report.all.contrastIntensity_W_sr / phasesOfTruth;
            }
            for (std::size_t w = 0; w < all.size(); ++w) {
                irsg.scene.settings = all[w].settings();
                for (int phase = 0; phase < options.phases; ++phase) {
                    place(irsg, radians(azimuth_deg), range_m, phase);
                    const auto start = std::chrono::steady_clock::now();
                    const double found_W_sr =
                        irsg.imageWithReport().report.all.contrastIntensity_W_sr;
                    const std::chrono::duration<double, std::milli> time =
                        std::chrono::steady_clock::now() - start;
                    const double error = found_W_sr / truth_W_sr - 1.0;
                    sums[w].squares += error * error;
                    sums[w].largest = std::max(sums[w].largest, std::abs(error));
                    sums[w].time_ms += time.count();
                    ++sums[w].count;
                    char row[200];
                    std::snprintf(row, sizeof row, "%g,%.6g,%s,%.7g,%.4g,%.4g\n", azimuth_deg,
                                  range_m, all[w].name().c_str(), found_W_sr, 100.0 * error,
                                  time.count());
                    file << row;
                }
            }
        }

    std::printf("Four-engined aircraft, %.0f to %.1f pixels, 3-5 um, %zu aspects\n",
                size_m / (pixelOfSensor_rad * nearest_m), size_m / (pixelOfSensor_rad * farthest_m),
                azimuths_deg.size());
    for (std::size_t w = 0; w < all.size(); ++w)
        std::printf("%-30s RMS %6.3f %%  largest %6.3f %%  %7.2f ms\n", all[w].name().c_str(),
                    100.0 * std::sqrt(sums[w].squares / sums[w].count), 100.0 * sums[w].largest,
                    sums[w].time_ms / sums[w].count);
}

} // namespace irsg::study
