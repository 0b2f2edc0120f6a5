#include <cmath>

#include "irsg/radiometry/Units.h"
#include "smatcore/analysis/AnalysisPlan.h"
#include "smatcore/analysis/kinds/AnalysisDefinition.h"
#include "smatcore/settings/SettingKeys.h"
#include "smatcore/settings/SettingRows.h"

namespace smat {

namespace key {
constexpr TextKey polarType{"polar.type"};
constexpr RealKey polarStep{"polar.step"};
constexpr RealKey polarOffset{"polar.offset"};
} // namespace key

namespace {

std::vector<SettingInfo> settings() {
    using namespace rows;
    return {
        named(choice(key::polarType, "--type", "Type",
                     {"camera-azimuth", "camera-elevation", "model-yaw"}, "camera-azimuth",
                     "What turns: the camera about the target in a horizontal plane (clockwise "
                     "seen from above, from the nose), the camera in the target's vertical "
                     "plane (front, belly, tail, top), or the target itself "
                     "(counter-clockwise, level, the camera stays)."),
              {"camera azimuth", "camera elevation", "model yaw"}),
        number(key::polarStep, "--step", "Step", "deg", 0.001, 180, "10",
               "Angle between two cases. The sweep covers one turn from 0."),
        number(key::polarOffset, "--offset", "View offset", "deg", -90, 90, "0",
               "Elevation of the camera in a camera-azimuth plot."),
    };
}

/// The angle in [0, 360), with what rounding left below 0 or at 360 taken as 0.
double wholeTurn_deg(double angle_deg) {
    const double turned = angle_deg - 360.0 * std::floor(angle_deg / 360.0);
    return turned >= 360.0 - 1e-9 || turned < 1e-12 ? 0.0 : turned;
}

/// Camera-Azimuth: level circle at the view offset, clockwise seen from above, from the nose.
void placeCameraAzimuth(AnalysisCase& one, double angle_deg, double offset_deg) {
    one.azimuth_rad = irsg::radians(angle_deg);
    one.elevation_rad = irsg::radians(offset_deg);
    one.shownAzimuth_deg = angle_deg;
    one.shownElevation_deg = offset_deg;
}

/// Camera-Elevation: in the target's own vertical plane, front, belly, tail, top.
void placeCameraElevation(AnalysisCase& one, double angle_deg) {
    one.path = AnalysisCase::CameraPath::pitchPlane;
    one.angle_rad = irsg::radians(angle_deg);
    // Past the belly the camera stands behind; its elevation runs 0, -90, 0, 90, 0.
    const bool isBehind = angle_deg > 90.0 && angle_deg < 270.0;
    one.shownAzimuth_deg = isBehind ? 180.0 : 0.0;
    one.shownElevation_deg = isBehind            ? angle_deg - 180.0
                             : angle_deg <= 90.0 ? -angle_deg
                                                 : 360.0 - angle_deg;
    if (one.shownElevation_deg == 0.0) {
        one.shownElevation_deg = 0.0; // not -0
    }
}

/// Model-Yaw: level target that turns counter-clockwise; at angle 0 its nose points at the camera,
/// which stays where the viewer is.
void placeModelYaw(AnalysisCase& one, double angle_deg, const Settings& settings) {
    const double facing_deg = settings[key::targetYaw] - settings[key::cameraAzimuth];
    one.attitude = {irsg::radians(facing_deg + angle_deg), 0.0, 0.0};
    one.cameraYaw_rad = irsg::radians(facing_deg);
    one.azimuth_rad = 0.0;
    one.shownAzimuth_deg = angle_deg;
    one.shownElevation_deg = settings[key::cameraElevation];
    one.shownYaw_deg = wholeTurn_deg(facing_deg + angle_deg);
}

void plan(AnalysisPlan& plan, const Project&, const Settings& settings,
          std::vector<irsg::Diagnostic>& diagnostics) {
    const std::string& type = settings.text(key::polarType);
    const double step_deg = settings[key::polarStep];
    const double offset_deg = settings[key::polarOffset];
    if (type != "camera-azimuth" && offset_deg != 0.0) {
        diagnostics.push_back({.file = "",
                               .position = key::polarOffset,
                               .value = settings.text(key::polarOffset),
                               .expected = "0: only a camera-azimuth plot has a view offset"});
    }
    plan.coordinate = irsg::Quantity::angle;
    plan.columns = {irsg::Quantity::angle, irsg::Quantity::azimuth, irsg::Quantity::elevation,
                    irsg::Quantity::yaw};
    const auto count = static_cast<std::size_t>(std::ceil(360.0 / step_deg - 1e-9));
    for (std::size_t i = 0; i < count; ++i) {
        const double angle_deg = stepped(0.0, i, step_deg);
        AnalysisCase one = standingCase(settings);
        one.coordinate = angle_deg;
        if (type == "camera-azimuth") {
            placeCameraAzimuth(one, angle_deg, offset_deg);
        } else if (type == "camera-elevation") {
            placeCameraElevation(one, angle_deg);
        } else {
            placeModelYaw(one, angle_deg, settings);
        }
        plan.cases.push_back(one);
    }
}

} // namespace

extern constinit const AnalysisDefinition polarAnalysis{
    .name = "polar",
    .title = "Polar plot",
    .help = "Intensity over one turn of camera or target",
    .icon = "polar",
    .settings = settings,
    .plan = plan};

} // namespace smat
