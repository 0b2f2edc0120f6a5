#include "smatcore/analysis/AnalysisPlan.h"

#include <cmath>

#include <fmt/format.h>

#include "irsg/radiometry/CsvTable.h"
#include "irsg/radiometry/Errors.h"
#include "irsg/radiometry/Units.h"
#include "smatcore/project/SceneBuilder.h"

namespace smat {

namespace {

constexpr double mostCases = 1e6;

/// The angle in [0, 360), with what rounding left below 0 or at 360 taken as 0.
double wholeTurn_deg(double angle_deg) {
    const double turned = angle_deg - 360.0 * std::floor(angle_deg / 360.0);
    return turned >= 360.0 - 1e-9 || turned < 1e-12 ? 0.0 : turned;
}

/// `first + i step` without the digits that binary fractions leave behind: 0.3, not
/// 0.30000000000000004.
double stepped(double first, std::size_t i, double step) {
    return irsg::parseNumber(fmt::format("{:.13g}", first + static_cast<double>(i) * step)).value();
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
    const double facing_deg = settings.real("target.yaw") - settings.real("camera.azimuth");
    one.attitude = {irsg::radians(facing_deg + angle_deg), 0.0, 0.0};
    one.cameraYaw_rad = irsg::radians(facing_deg);
    one.azimuth_rad = 0.0;
    one.shownAzimuth_deg = angle_deg;
    one.shownElevation_deg = settings.real("camera.elevation");
    one.shownYaw_deg = wholeTurn_deg(facing_deg + angle_deg);
}

void planPolar(AnalysisPlan& plan, const Settings& settings,
               std::vector<irsg::Diagnostic>& diagnostics) {
    const std::string& type = settings.text("polar.type");
    const double step_deg = settings.real("polar.step");
    const double offset_deg = settings.real("polar.offset");
    if (type != "camera-azimuth" && offset_deg != 0.0) {
        diagnostics.push_back({.file = "",
                               .position = "polar.offset",
                               .value = settings.text("polar.offset"),
                               .expected = "0: only a camera-azimuth plot has a view offset"});
    }
    plan.coordinate = irsg::Quantity::angle;
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

void planRange(AnalysisPlan& plan, const Settings& settings,
               std::vector<irsg::Diagnostic>& diagnostics) {
    const double from_m = settings.real("range.from");
    const double to_m = settings.real("range.to");
    const int points = settings.integer("range.points");
    const bool logarithmic = settings.boolean("range.log");
    plan.coordinate = irsg::Quantity::range;
    if (to_m <= from_m) {
        diagnostics.push_back({.file = "",
                               .position = "range.to",
                               .value = settings.text("range.to"),
                               .expected = "a number above range.from, which is " +
                                           settings.text("range.from") + " m"});
    }
    if (logarithmic && from_m <= 0.0) {
        diagnostics.push_back({.file = "",
                               .position = "range.from",
                               .value = settings.text("range.from"),
                               .expected = "a number above 0 m, because range.log is true"});
    }
    if (!diagnostics.empty()) {
        return;
    }
    for (int i = 0; i < points; ++i) {
        const double share = static_cast<double>(i) / (points - 1);
        AnalysisCase one = standingCase(settings);
        one.range_m = logarithmic ? from_m * std::pow(to_m / from_m, share)
                                  : from_m + (to_m - from_m) * share;
        if (i == points - 1) {
            one.range_m = to_m;
        }
        one.coordinate = one.range_m;
        plan.cases.push_back(one);
    }
}

void planTime(AnalysisPlan& plan, const Settings& settings,
              std::vector<irsg::Diagnostic>& diagnostics) {
    const double from_s = settings.real("time.from");
    const double to_s = settings.real("time.to");
    const double step_s = settings.real("time.step");
    plan.coordinate = irsg::Quantity::time;
    if (to_s <= from_s) {
        diagnostics.push_back({.file = "",
                               .position = "time.to",
                               .value = settings.text("time.to"),
                               .expected = "a number above time.from, which is " +
                                           settings.text("time.from") + " s"});
        return;
    }
    const double count = std::floor((to_s - from_s) / step_s + 1e-9) + 1.0;
    if (count > mostCases) {
        diagnostics.push_back(
            {.file = "",
             .position = "time.step",
             .value = settings.text("time.step"),
             .expected = fmt::format("at most {:.0f} cases, not {:.0f}", mostCases, count)});
        return;
    }
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
        AnalysisCase one = standingCase(settings);
        one.time_s = stepped(from_s, i, step_s);
        one.coordinate = one.time_s;
        plan.cases.push_back(one);
    }
}

void planSpectrum(AnalysisPlan& plan, const Project& project, const Settings& settings,
                  std::vector<irsg::Diagnostic>& diagnostics) {
    const irsg::SpectralRange range = sensorOf(project, settings).band.range();
    const double lowest_per_cm = irsg::wavenumberFromWavelength_per_cm(range.max_um);
    const double highest_per_cm = irsg::wavenumberFromWavelength_per_cm(range.min_um);
    const double step_per_cm = settings.real("spectrum.resolution");
    plan.coordinate = irsg::Quantity::wavenumber;
    plan.cases.push_back(standingCase(settings));
    const double count = std::floor((highest_per_cm - lowest_per_cm) / step_per_cm + 1e-9) + 1.0;
    if (count > mostCases) {
        diagnostics.push_back(
            {.file = "",
             .position = "spectrum.resolution",
             .value = settings.text("spectrum.resolution"),
             .expected = fmt::format("at most {:.0f} wavenumbers, not {:.0f}", mostCases, count)});
        return;
    }
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
        plan.wavenumbers_per_cm.push_back(
            std::min(lowest_per_cm + static_cast<double>(i) * step_per_cm, highest_per_cm));
    }
    // The band ends at its end, also where the last step is shorter.
    if (highest_per_cm - plan.wavenumbers_per_cm.back() > 1e-6 * step_per_cm) {
        plan.wavenumbers_per_cm.push_back(highest_per_cm);
    }
}

std::string describe(const AnalysisPlan& plan, const Settings& settings) {
    const irsg::QuantityInfo& axis = irsg::info(plan.coordinate);
    const std::string raster =
        fmt::format("{} x {} px", settings.text("sensor.width"), settings.text("sensor.height"));
    if (plan.kind == AnalysisKind::image) {
        return fmt::format("image: 1 case, {}", raster);
    }
    if (plan.kind == AnalysisKind::spectrum) {
        return fmt::format("spectrum: 1 case, {} wavenumbers from {:.6g} to {:.6g} cm-1, {}",
                           plan.wavenumbers_per_cm.size(), plan.wavenumbers_per_cm.front(),
                           plan.wavenumbers_per_cm.back(), raster);
    }
    return fmt::format("{}: {} cases, {} {:.6g} to {:.6g} {}, {}", name(plan.kind),
                       plan.cases.size(), axis.key, plan.cases.front().coordinate,
                       plan.cases.back().coordinate, axis.unit, raster);
}

/// What a kind of analysis cannot do, whatever its sweep.
void checkAbilities(AnalysisKind kind, const Settings& settings,
                    std::vector<irsg::Diagnostic>& diagnostics) {
    const bool isOneBand = kind == AnalysisKind::image || kind == AnalysisKind::spectrum;
    if (isOneBand && eachBand(settings).size() > 1) {
        const bool hasResponse = !settings.paths("sensor.response").empty();
        const char* key = hasResponse ? "sensor.response" : "sensor.band";
        diagnostics.push_back(
            {.file = "",
             .position = key,
             .value = settings.text(key),
             .expected = kind == AnalysisKind::image
                             ? "one band for an image in the window; smat-batch "
                               "writes a file for each of several"
                             : "one band: a spectrum runs from its one end to the "
                               "other"});
    }
    // Modes 0 to 2 have no zoom.
    if (kind != AnalysisKind::image && settings.text("render.zoom") == "sills" &&
        settings.integer("render.antialiasing") > 2) {
        diagnostics.push_back(
            {.file = "",
             .position = "render.zoom",
             .value = "sills",
             .expected = "aligned: the samples of the published zoom do not add to "
                         "pixels, so that the sums of a " +
                         name(kind) +
                         " analysis come from the aligned windows; only images show "
                         "the published zoom"});
    }
}

} // namespace

AnalysisCase standingCase(const Settings& settings) {
    AnalysisCase one;
    one.time_s = settings.real("state.time");
    one.attitude = targetPoseOf(settings).attitude;
    one.cameraYaw_rad = one.attitude.yaw_rad;
    one.azimuth_rad = irsg::radians(settings.real("camera.azimuth"));
    one.elevation_rad = irsg::radians(settings.real("camera.elevation"));
    one.range_m = settings.real("camera.range");
    one.shownAzimuth_deg = settings.real("camera.azimuth");
    one.shownElevation_deg = settings.real("camera.elevation");
    one.shownYaw_deg = settings.real("target.yaw");
    return one;
}

irsg::Pose AnalysisCase::pose(const irsg::Pose& standing,
                              const irsg::Vec3& referencePointInModel) const {
    irsg::Pose turned = standing;
    if (attitude != standing.attitude) {
        turned.attitude = attitude;
        turned.position_m =
            standing.toWorld(referencePointInModel) - attitude.rotation() * referencePointInModel;
    }
    return turned;
}

irsg::Viewpoint AnalysisCase::viewpoint(const irsg::Vec3& referencePoint) const {
    return path == CameraPath::pitchPlane
               ? irsg::Viewpoint::aroundPitchPlane(referencePoint, attitude, angle_rad, range_m)
               : irsg::Viewpoint::about(referencePoint, cameraYaw_rad, azimuth_rad, elevation_rad,
                                        range_m);
}

std::string AnalysisPlan::place(const AnalysisCase& one) const {
    return fmt::format("{:.6g} {}", one.coordinate, irsg::info(coordinate).unit);
}

AnalysisPlan planAnalysis(AnalysisKind kind, const Project& project, const Settings& settings) {
    AnalysisPlan plan;
    plan.kind = kind;
    std::vector<irsg::Diagnostic> diagnostics;
    checkAbilities(kind, settings, diagnostics);
    switch (kind) {
    case AnalysisKind::image:
        plan.cases.push_back(standingCase(settings));
        break;
    case AnalysisKind::spectrum:
        planSpectrum(plan, project, settings, diagnostics);
        break;
    case AnalysisKind::polar:
        planPolar(plan, settings, diagnostics);
        break;
    case AnalysisKind::time:
        planTime(plan, settings, diagnostics);
        break;
    case AnalysisKind::range:
        planRange(plan, settings, diagnostics);
        break;
    }
    if (!diagnostics.empty()) {
        for (irsg::Diagnostic& diagnostic : diagnostics) {
            diagnostic.file = project.displayName();
        }
        throw irsg::InputError(diagnostics);
    }
    plan.description = describe(plan, settings);
    return plan;
}

} // namespace smat
