// How close samples come: small objects at many places among the pixels, and every way of sampling.
#include <cmath>

#include "irsg/radiometry/Planck.h"
#include "irsg/radiometry/Units.h"
#include "irsg/reference/Scenes.h"
#include "smatcore/selftest/CheckParts.h"
#include "smatcore/selftest/Checks.h"

namespace smat::selftest {
namespace {

using namespace irsg::reference;
using irsg::InteractiveRenderer;
using irsg::Outputs;
using irsg::Vec3;

constexpr double pixel_rad = 1e-4;

Triangles fineBall() {
    return sphereMesh(1.0, 48, 96, one);
}
/// Two plates of different height side by side, 2 m high.
Triangles lopsided() {
    return joined(plateMesh({-0.7, 0, 0}, {0, 0, 1}, {0.3, 0, 0}, one),
                  plateMesh({0.3, 0, -0.8}, {0, 0, 0.2}, {0.7, 0, 0}, one));
}

struct Way {
    int tileSide_samples = 256;
    int samplesPerAxis = 4;
    irsg::TileStrategy zoom = irsg::TileStrategy::aligned;
};

/// Root mean square of the relative errors of the intensity of an object 2 m wide that is so many
/// pixels wide, at 8 x 8 places among them that are irrational to every lattice.
double rms(SelfTestBench& bench, const Triangles& mesh, double size_px, double roll_rad,
           const Way& way = {}) {
    InteractiveRenderer& irsg = bench.irsg();
    irsg::RenderSettings settings = irsg::RenderSettings::direct();
    settings.tileSide_samples = way.tileSide_samples;
    settings.samplesPerAxis = way.samplesPerAxis;
    settings.tileStrategy = way.zoom;
    settings.pointSourceBelow_px = 0.0;
    irsg.scene.settings = settings;
    irsg.scene.entities = {entityOf(modelOf(mesh), greyDatabase(0.9, 320.0))};
    const int frame_px = static_cast<int>(std::ceil(1.5 * size_px)) + 6;
    const double range_m = 2.0 / (size_px * pixel_rad);
    look(irsg, {.range_m = range_m,
                .width_px = frame_px,
                .height_px = frame_px,
                .fieldOfView_rad = 2.0 * std::atan(0.5 * frame_px * pixel_rad)});
    const irsg::Attitude attitude{0, 0, roll_rad};
    double squares = 0.0;
    for (int i = 0; i < 8; ++i) {
        for (int j = 0; j < 8; ++j) {
            const irsg::Viewpoint& camera = irsg.view.viewpoint;
            const double step_m = pixel_rad * range_m;
            irsg::Pose pose{{0, 0, standingAltitude_m}, attitude};
            pose.position_m = pose.position_m +
                              camera.right * (std::fmod(i * 0.61803398875 + 0.1, 1.0) * step_m) +
                              camera.up * (std::fmod(j * 0.41421356237 + 0.3, 1.0) * step_m);
            irsg.scene.entities[0].pose = pose;
            const Vec3 away = camera.position_m - pose.position_m;
            const Vec3 from = attitude.rotation().transposed() * away;
            const double truth = grey_W_m2_sr() * convexSolidAngle_sr(mesh, from) * dot(away, away);
            const double error = irsg.measure().all.contrastIntensity_W_sr / truth - 1.0;
            squares += error * error / 64.0;
        }
    }
    return std::sqrt(squares);
}

SelfTestCheck rmsCheck(const std::string& name, const std::string& says, double bound,
                       const Triangles& mesh, double size_px, double roll_deg,
                       const Way& way = {}) {
    return {.name = "sampling." + name,
            .says = says + ": rms over 64 places among the pixels",
            .unit = "",
            .bound = bound,
            .error = absolute,
            .measure = [=](SelfTestBench& bench) {
                return SelfTestValue{rms(bench, mesh, size_px, irsg::radians(roll_deg), way), 0.0};
            }};
}

/// A curve over range from a few drawings, against the solid angle at each range.
SelfTestValue rangeCurve(SelfTestBench& bench) {
    InteractiveRenderer& irsg = bench.irsg();
    irsg.scene.entities = {entityOf(modelOf(fineBall()), greyDatabase(0.9, 320.0))};
    Farthest farthest;
    for (const double range_m : {300.0, 500.0, 900.0, 2000.0, 7000.0}) {
        look(irsg, {.range_m = range_m, .fieldOfView_rad = 0.009});
        farthest.add(irsg.render(Outputs::reports({band}).alongRange().withErrors(false))
                         .reports.front()
                         .all.intensity_W_sr,
                     grey_W_m2_sr() * convexSolidAngle_sr(fineBall(), {0, range_m, 0}) * range_m *
                         range_m);
    }
    return farthest.found();
}

} // namespace

std::vector<SelfTestCheck> samplingChecks() {
    return withHard(
        {
            rmsCheck("ball-30-px", "A ball 30 pixels wide in windows of 256 samples", 1e-3,
                     fineBall(), 30.0, 0.0),
            rmsCheck("ball-1-px", "A ball one pixel wide in windows of 256 samples", 1e-3,
                     fineBall(), 1.0, 0.0),
            rmsCheck("ball-a-tenth-px", "A ball a tenth of a pixel wide", 1e-3, fineBall(), 0.1,
                     0.0),
            rmsCheck("lopsided-3-px", "A lopsided body 3 pixels wide, turned by 30 degrees", 1e-3,
                     lopsided(), 3.0, 30.0),
            rmsCheck("lopsided-upright", "The same with its edges along the pixels", 5e-3,
                     lopsided(), 3.0, 0.0),
            rmsCheck("supersampling-4", "A ball 30 pixels wide with 4 x 4 samples a pixel", 3e-3,
                     fineBall(), 30.0, 0.0, {.tileSide_samples = 0}),
            {"sampling.range-curve",
             "Intensity along the range, 300 m to 7 km, against the solid angle", "W sr-1", 1e-3,
             relative, rangeCurve},
        },
        {
            rmsCheck("ball-a-thousandth-px", "A ball a thousandth of a pixel wide", 1e-3,
                     fineBall(), 1e-3, 0.0),
            rmsCheck("lopsided-a-hundredth-px",
                     "The lopsided body a hundredth of a pixel wide, turned by 37 degrees", 1e-3,
                     lopsided(), 0.01, 37.0),
            rmsCheck("window-128",
                     "A lopsided body 6 pixels wide in windows of 128 samples (mode 3)", 3e-3,
                     lopsided(), 6.0, 31.5, {.tileSide_samples = 128}),
            rmsCheck("window-512", "The same in windows of 512 samples (mode 5)", 1e-3, lopsided(),
                     6.0, 31.5, {.tileSide_samples = 512}),
        });
}

} // namespace smat::selftest
