#include <cmath>
#include <optional>

#include "irsg/radiometry/Units.h"
#include "smatcore/analysis/AnalysisDefinition.h"
#include "smatcore/analysis/AnalysisPlan.h"
#include "smatcore/settings/SettingKeys.h"
#include "smatcore/settings/SettingRows.h"

namespace smat {

namespace key {
constexpr TextKey polarType{"polar.type"};
constexpr TextKey polarSteps{"polar.steps"};
constexpr RealKey polarFrom{"polar.from"};
constexpr RealKey polarTo{"polar.to"};
constexpr RealKey polarOffset{"polar.offset"};
constexpr OptionalRealKey polarOffsetTo{"polar.offsetTo"};
constexpr RealKey polarOffsetStep{"polar.offsetStep"};
} // namespace key

namespace {

std::vector<SettingInfo> polarSettings() {
    using namespace rows;
    return {
        named(choice(key::polarType, "--type", "Type",
                     {"camera-azimuth", "camera-elevation", "model-yaw"}, "camera-azimuth",
                     "What turns: the camera about the target in a horizontal plane (clockwise "
                     "seen from above, from the nose), the camera in the target's vertical "
                     "plane (front, belly, tail, top), or the target itself "
                     "(counter-clockwise, level, the camera stays)."),
              {"camera azimuth", "camera elevation", "model yaw"}),
        choiceOrNumber(key::polarStep, "--step", "Step", "deg", {"auto"}, 0.001, 180, "auto",
                       "Angle between two cases, of adaptive steps the first ones. The sweep "
                       "covers one turn from 0. auto: 5 deg, and adaptive steps."),
        stepsOfPlot(key::polarSteps, key::polarStep, "down to 1/32 of the step"),
        number(key::polarFrom, "--from", "From", "deg", 0, 360, "0", "First angle, of a sector."),
        number(key::polarTo, "--to", "To", "deg", 0, 360, "360",
               "Last angle of a sector, which has a case whatever the step; from 0 to 360 it is a "
               "whole turn, whose end is its beginning."),
        number(key::polarOffset, "--offset", "View offset", "deg", -90, 90, "0",
               "Elevation of the camera in a camera-azimuth plot."),
        choiceOrNumber(key::polarOffsetTo, "--offset-to", "Last view offset", "deg", {"none"}, -90,
                       90, "none",
                       "Of several camera-azimuth curves, one for each elevation from the view "
                       "offset on; the last is the last step at or below it; none: one curve."),
        number(key::polarOffsetStep, "--offset-step", "Step of the view offset", "deg", 0.1, 180,
               "10", "Angle between two of these elevations."),
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
    if (one.shownElevation_deg == 0.0)
        one.shownElevation_deg = 0.0; // not -0
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

double step_deg(const Settings& settings) {
    return settings[key::polarStep].value_or(5.0);
}

/// The angles of one turn or sector.
std::vector<double> angles_deg(const Settings& settings, double step_deg) {
    const double from_deg = settings[key::polarFrom], to_deg = settings[key::polarTo];
    const bool isTurn = to_deg - from_deg >= 360.0;
    std::vector<double> angles;
    // The end of a turn is its beginning; that of a sector belongs to it.
    const double slack = 1e-9;
    const auto count = isTurn
                           ? static_cast<std::size_t>(std::ceil(360.0 / step_deg - slack))
                           : static_cast<std::size_t>((to_deg - from_deg) / step_deg + slack) + 1;
    for (std::size_t i = 0; i < count; ++i)
        angles.push_back(stepped(from_deg, i, step_deg));
    if (!isTurn && angles.back() < to_deg - slack)
        angles.push_back(to_deg);
    return angles;
}

/// The elevations of camera-azimuth curves, from the first one on.
std::vector<double> offsets_deg(const Settings& settings) {
    const double first_deg = settings[key::polarOffset];
    std::vector<double> offsets{first_deg};
    const std::optional<double> last_deg = settings[key::polarOffsetTo];
    const double step_deg = settings[key::polarOffsetStep];
    for (std::size_t i = 1; last_deg && stepped(first_deg, i, step_deg) <= *last_deg + 1e-9; ++i)
        offsets.push_back(stepped(first_deg, i, step_deg));
    return offsets;
}

void checkPolar(const Settings& settings, std::vector<irsg::Diagnostic>& diagnostics) {
    const auto refuse = [&](std::string_view key, const char* expected) {
        diagnostics.push_back({.file = "",
                               .position = std::string(key),
                               .value = settings.text(key),
                               .expected = expected});
    };
    const bool isAzimuth = settings.text(key::polarType) == "camera-azimuth";
    if (!isAzimuth && settings[key::polarOffset] != 0.0)
        refuse(key::polarOffset, "0: only a camera-azimuth plot has a view offset");
    if (!isAzimuth && settings[key::polarOffsetTo])
        refuse(key::polarOffsetTo, "none: only a camera-azimuth plot has view offsets");
    if (settings[key::polarOffsetTo] && *settings[key::polarOffsetTo] < settings[key::polarOffset])
        refuse(key::polarOffsetTo, "the view offset or more");
    if (settings[key::polarTo] <= settings[key::polarFrom])
        refuse(key::polarTo, "more than the first angle");
}

void planPolar(AnalysisPlan& plan, const Project&, const Settings& settings,
               std::vector<irsg::Diagnostic>& diagnostics) {
    checkPolar(settings, diagnostics);
    const std::string& type = settings.text(key::polarType);
    plan.coordinate = irsg::Quantity::angle;
    plan.columns = {irsg::Quantity::angle, irsg::Quantity::azimuth, irsg::Quantity::elevation,
                    irsg::Quantity::yaw};
    if (!diagnostics.empty())
        return;
    const double first_deg = step_deg(settings);
    const bool isTurn = settings[key::polarTo] - settings[key::polarFrom] >= 360.0;
    const RefinedAxis axis{irsg::Quantity::angle, angles_deg(settings, first_deg), isTurn,
                           first_deg / 32.0};
    const auto casesAt = [settings, type](const std::vector<RefinedAxis>& axes) {
        std::vector<AnalysisCase> cases;
        for (const double offset_deg : offsets_deg(settings))
            for (const double angle_deg : axes.front().places) {
                AnalysisCase one = startingCase(settings);
                one.coordinate = angle_deg;
                if (type == "camera-azimuth")
                    placeCameraAzimuth(one, angle_deg, offset_deg);
                else if (type == "camera-elevation")
                    placeCameraElevation(one, angle_deg);
                else
                    placeModelYaw(one, angle_deg, settings);
                cases.push_back(one);
            }
        return cases;
    };
    if (offsets_deg(settings).size() > 1)
        plan.axes = {irsg::Quantity::angle, irsg::Quantity::elevation};
    plan.cases = casesAt({axis});
    if (isAdaptivePlot(AnalysisKind::polar, settings)) {
        plan.refined = {axis};
        plan.casesAt = casesAt;
    }
}

std::vector<std::string> ignoredByPolar(const Settings& settings) {
    const std::string& type = settings.text(key::polarType);
    if (type == "model-yaw")
        return {key::targetYaw, key::targetPitch, key::targetRoll};
    return {key::cameraAzimuth, key::cameraElevation};
}

} // namespace

extern constinit const AnalysisDefinition polarAnalysis{
    .name = "polar",
    .title = "Polar plot",
    .help = "Intensity over one turn of camera or target",
    .icon = "polar",
    .step = key::polarStep.name,
    .settings = polarSettings,
    .plan = planPolar,
    .ignored = ignoredByPolar};

} // namespace smat
