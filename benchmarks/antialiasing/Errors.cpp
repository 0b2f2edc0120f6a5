#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>

#include "benchmarks/antialiasing/Bodies.h"
#include "benchmarks/antialiasing/Study.h"
#include "irsg/core/Errors.h"
#include "irsg/radiometry/Units.h"

namespace irsg::study {

namespace {

struct Phase {
    Pose pose;
    double intensity_W_sr; ///< of the closed form
};

/// Irrational to every lattice of samples.
double phase_px(int i, double step, double first) {
    return std::fmod(i * step + first, 1.0);
}

std::vector<Phase> phasesOf(const Body& body, const Viewpoint& camera, int count) {
    const Vec3 origin_m{0, 0, test::standingAltitude_m};
    const double pixel_m = pixel_rad * length(camera.position_m - origin_m);
    std::vector<Phase> result;
    for (int i = 0; i < count; ++i)
        for (int j = 0; j < count; ++j) {
            Pose pose{origin_m, body.attitude};
            pose.position_m = origin_m +
                              camera.right * (phase_px(i, 0.61803398875, 0.1) * pixel_m) +
                              camera.up * (phase_px(j, 0.41421356237, 0.3) * pixel_m);
            const Vec3 away = camera.position_m - pose.position_m;
            result.push_back({pose, greyRadiance_W_m2_sr() * solidAngle_sr(body, camera, pose) *
                                        dot(away, away)});
        }
    return result;
}

/// Looks at a body so that it is `size_px` wide, in a frame that holds it at every phase.
void lookAt(InteractiveRenderer& irsg, const Body& body, double size_px) {
    const int frame_px = static_cast<int>(std::ceil(1.5 * size_px)) + 6;
    test::look(irsg, {.range_m = body.size_m / (size_px * pixel_rad),
                      .azimuth_rad = body.azimuth_rad,
                      .elevation_rad = body.elevation_rad,
                      .width_px = frame_px,
                      .height_px = frame_px,
                      .fieldOfView_rad = 2.0 * std::atan(0.5 * frame_px * pixel_rad)});
}

/// The two ways to the truth must agree where both are exact.
void checkTruth(const Body& body, const Viewpoint& camera, const Phase& phase) {
    if (!body.facesAdd)
        return;
    const double ratio = solidAngleByLines_sr(body.mesh, camera, phase.pose) /
                         solidAngle_sr(body, camera, phase.pose);
    if (std::abs(ratio - 1.0) > 1e-6)
        throw LogicError("the two truths of " + body.name + " differ by a factor of 1 + " +
                         std::to_string(ratio - 1.0));
}

struct ErrorOverPhases {
    double rms_percent = 0.0, largest_percent = 0.0;
};

/// Of the contrast intensity that a method finds, as the generator looks.
ErrorOverPhases errorOf(InteractiveRenderer& irsg, const std::vector<Phase>& phases,
                        const Method& method) {
    irsg.scene.settings = method.settings();
    double squares = 0.0, largest = 0.0;
    for (const Phase& phase : phases) {
        irsg.scene.entities[0].pose = phase.pose;
        const double error =
            irsg.imageWithReport().report.all.contrastIntensity_W_sr / phase.intensity_W_sr - 1.0;
        squares += error * error;
        largest = std::max(largest, std::abs(error));
    }
    const double rms = std::sqrt(squares / static_cast<double>(phases.size()));
    return {100.0 * rms, 100.0 * largest};
}

/// Phases of a body that is `size_px` wide; the generator looks at it.
std::vector<Phase> look(InteractiveRenderer& irsg, const Body& body, double size_px, int phases) {
    irsg.scene.entities[0].pose = {{0, 0, test::standingAltitude_m}, {}};
    lookAt(irsg, body, size_px);
    return phasesOf(body, irsg.view.viewpoint, phases);
}

} // namespace

void measureErrors(const Options& options) {
    std::ofstream file(options.folder / "errors.csv");
    file << "body,size [px],strategy,mode,rms_error [%],largest_error [%]\n";
    InteractiveRenderer irsg{RenderSettings::direct()};
    irsg.scene.environment = test::environmentOf(test::ConstantAtmosphere{});
    for (const Body& body : chosenBodies(options)) {
        irsg.scene.entities = {greyEntity(body.mesh)};
        for (double size_px : sizes_px()) {
            const std::vector<Phase> phases = look(irsg, body, size_px, options.phases);
            checkTruth(body, irsg.view.viewpoint, phases.front());
            for (const Method& method : methods()) {
                if (method.wholeFrame) // the same samples as in the object's window
                    continue;
                const ErrorOverPhases error = errorOf(irsg, phases, method);
                char row[160];
                std::snprintf(row, sizeof row, "%s,%.6g,%s,%d,%.4g,%.4g\n", body.name.c_str(),
                              size_px, method.strategy.c_str(), method.mode, error.rms_percent,
                              error.largest_percent);
                file << row << std::flush;
            }
        }
    }
}

void measureAngles(const Options& options) {
    constexpr int phases = 6;
    constexpr double first_deg = 5.0, last_deg = 85.5, step_deg = 0.5, bound_percent = 0.1;
    std::ofstream file(options.folder / "angles.csv");
    file << "angle [deg],size [px],rms_error [%],largest_error [%]\n";

    InteractiveRenderer irsg{RenderSettings::direct()};
    irsg.scene.environment = test::environmentOf(test::ConstantAtmosphere{});
    Body body = bodies()[1];
    irsg.scene.entities = {greyEntity(body.mesh)};
    int cases = 0, above = 0;
    ErrorOverPhases worst;
    double worst_deg = 0.0;
    for (double angle_deg = first_deg; angle_deg <= last_deg; angle_deg += step_deg)
        for (const double size_px : {53.0, 5.9, 0.61, 0.067, 0.0097}) {
            body.attitude = Attitude{0.0, 0.0, radians(angle_deg)};
            const ErrorOverPhases error =
                errorOf(irsg, look(irsg, body, size_px, phases), {"aligned", 4, false});
            file << angle_deg << "," << size_px << "," << error.rms_percent << ","
                 << error.largest_percent << "\n";
            ++cases;
            above += error.rms_percent > bound_percent ? 1 : 0;
            if (error.rms_percent > worst.rms_percent)
                worst_deg = angle_deg;
            worst = {std::max(worst.rms_percent, error.rms_percent),
                     std::max(worst.largest_percent, error.largest_percent)};
        }
    std::printf("L turned by %g to %g degrees, mode 4: RMS above %g %% in %d of %d cases, worst "
                "%.3f %% (%g degrees), largest error %.3f %%\n",
                first_deg, last_deg, bound_percent, above, cases, worst.rms_percent, worst_deg,
                worst.largest_percent);
}

} // namespace irsg::study
