#include "smatcore/analysis/AnalysisPlan.h"

#include <fmt/format.h>

#include "irsg/core/CsvTable.h"
#include "irsg/core/Errors.h"
#include "irsg/radiometry/Units.h"
#include "smatcore/analysis/AnalysisDefinition.h"
#include "smatcore/project/SceneBuilder.h"
#include "smatcore/settings/SettingKeys.h"

namespace smat {

namespace {

std::string describe(const AnalysisPlan& plan, const Settings& settings) {
    const irsg::QuantityInfo& axis = irsg::info(plan.coordinate);
    const std::string raster = fmt::format("{} x {} px", settings.text(key::sensorWidth),
                                           settings.text(key::sensorHeight));
    if (plan.kind->form == AnalysisForm::image)
        return fmt::format("{}: 1 case, {}", name(plan.kind), raster);
    if (plan.kind->form == AnalysisForm::spectrum) {
        return fmt::format("{}: 1 case, {} wavenumbers from {:.6g} to {:.6g} cm-1, {}",
                           name(plan.kind), plan.wavenumbers_per_cm.size(),
                           plan.wavenumbers_per_cm.front(), plan.wavenumbers_per_cm.back(), raster);
    }
    const char* more = plan.refined.empty() ? "" : " and more where curves bend";
    if (!plan.axes.empty()) {
        return fmt::format("{}: {} cases{}, {} to {}, {}", name(plan.kind), plan.cases.size(), more,
                           plan.place(plan.cases.front()), plan.place(plan.cases.back()), raster);
    }
    return fmt::format("{}: {} cases{}, {} {:.6g} to {:.6g} {}, {}", name(plan.kind),
                       plan.cases.size(), more, axis.key, plan.cases.front().coordinate,
                       plan.cases.back().coordinate, axis.unit, raster);
}

/// What a kind of analysis cannot do, whatever its sweep.
void checkAbilities(AnalysisKind kind, const Settings& settings,
                    std::vector<irsg::Diagnostic>& diagnostics) {
    const bool isImage = kind->form == AnalysisForm::image;
    const bool isOneBand = isImage || kind->form == AnalysisForm::spectrum;
    if (isOneBand && eachBand(settings).size() > 1) {
        const bool hasResponse = !settings[key::sensorResponse].empty();
        const std::string key =
            hasResponse ? std::string(key::sensorResponse) : std::string(key::sensorBand);
        diagnostics.push_back(
            {.file = "",
             .position = key,
             .value = settings.text(key),
             .expected = isImage ? "one band for an image in the window; smat-batch "
                                   "writes a file for each of several"
                                 : "one band: a spectrum runs from its one end to the "
                                   "other"});
    }
    // Modes 0 to 2 have no zoom.
    if (!isImage && settings.text(key::renderZoom) == "sills" &&
        settings[key::renderAntialiasing] > 2) {
        diagnostics.push_back(
            {.file = "",
             .position = key::renderZoom,
             .value = "sills",
             .expected = "aligned: the samples of the published zoom do not add to "
                         "pixels, so that the sums of a " +
                         name(kind) +
                         " analysis come from the aligned windows; only images show "
                         "the published zoom"});
    }
}

} // namespace

bool isAdaptivePlot(AnalysisKind kind, const Settings& settings) {
    if (kind->step == nullptr)
        return false;
    const std::string& steps = settings.text(key::stepsOf(name(kind)));
    return steps == "adaptive" || (steps == "auto" && !settings[OptionalRealKey{kind->step}]);
}

Settings withFixedSteps(AnalysisKind kind, Settings settings) {
    if (isAdaptivePlot(kind, settings) && settings.text(key::stepsOf(name(kind))) == "auto")
        settings.set(key::stepsOf(name(kind)), "fixed");
    return settings;
}

AnalysisCase startingCase(const Settings& settings) {
    AnalysisCase one;
    one.time_s = settings[key::stateTime];
    one.attitude = targetPoseOf(settings).attitude;
    one.cameraYaw_rad = one.attitude.yaw_rad;
    one.azimuth_rad = irsg::radians(settings[key::cameraAzimuth]);
    one.elevation_rad = irsg::radians(settings[key::cameraElevation]);
    one.range_m = settings[key::cameraRange];
    one.shownAzimuth_deg = settings[key::cameraAzimuth];
    one.shownElevation_deg = settings[key::cameraElevation];
    one.shownYaw_deg = settings[key::targetYaw];
    return one;
}

irsg::Pose AnalysisCase::standing(const irsg::Pose& inScene) const {
    irsg::Pose at = inScene;
    at.position_m.z = altitude_m.value_or(inScene.position_m.z);
    return at;
}

irsg::EntityState AnalysisCase::state(irsg::EntityState inScene, const StateOverride& own) const {
    inScene.time_s = time_s;
    inScene.power = power.value_or(inScene.power);
    inScene.mach = mach.value_or(inScene.mach);
    return own.where(inScene);
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

double AnalysisCase::value(irsg::Quantity quantity) const {
    switch (quantity) {
    case irsg::Quantity::azimuth:
        return shownAzimuth_deg;
    case irsg::Quantity::elevation:
        return shownElevation_deg;
    case irsg::Quantity::yaw:
        return shownYaw_deg;
    case irsg::Quantity::range:
        return range_m;
    case irsg::Quantity::time:
        return time_s;
    case irsg::Quantity::power:
        return power.value_or(coordinate);
    case irsg::Quantity::mach:
        return mach.value_or(coordinate);
    case irsg::Quantity::altitude:
        return altitude_m.value_or(coordinate);
    default:
        return coordinate;
    }
}

double stepped(double first, std::size_t i, double step) {
    return irsg::parseNumber(fmt::format("{:.13g}", first + static_cast<double>(i) * step)).value();
}

std::string AnalysisPlan::place(const AnalysisCase& one) const {
    if (!axes.empty()) {
        std::string places;
        for (const irsg::Quantity axis : axes) {
            const irsg::QuantityInfo& info = irsg::info(axis);
            places += fmt::format("{}{} {:.6g}{}{}", places.empty() ? "" : ", ", info.key,
                                  one.value(axis), info.unit.empty() ? "" : " ", info.unit);
        }
        return places;
    }
    return fmt::format("{:.6g} {}", one.coordinate, irsg::info(coordinate).unit);
}

AnalysisPlan planAnalysis(AnalysisKind kind, const Project& project, const Settings& settings) {
    AnalysisPlan plan;
    plan.kind = kind;
    if (kind->plan == nullptr)
        throw irsg::LogicError(name(kind) + " is no analysis that can be planned");
    std::vector<irsg::Diagnostic> diagnostics;
    checkAbilities(kind, settings, diagnostics);
    kind->plan(plan, project, settings, diagnostics);
    if (plan.columns.empty())
        plan.columns = {plan.coordinate};
    if (!diagnostics.empty()) {
        for (irsg::Diagnostic& diagnostic : diagnostics)
            diagnostic.file = project.displayName();
        throw irsg::InputError(diagnostics);
    }
    plan.errors = errorColumnsOf(settings);
    if (kind->form == AnalysisForm::sweep)
        plan.parts = partsByOf(settings);
    // A target chooses nothing for a spectrum.
    if (kind->form != AnalysisForm::spectrum && plan.errors == ErrorColumns::none &&
        settings[key::renderTargetError])
        plan.errors = ErrorColumns::sum;
    if (!plan.refined.empty()) {
        const bool isAsked = settings.text(key::stepsOf(name(kind))) == "adaptive";
        plan.largestBend = 0.01 * settings[key::renderTargetError].value_or(isAsked ? 1.0 : 2.0);
        // What nobody asked for stays quick, and goes after curves, not after noise.
        if (!isAsked) {
            plan.mostRefined = 2 * plan.cases.size();
            if (plan.errors == ErrorColumns::none)
                plan.errors = ErrorColumns::sum;
        }
    }
    plan.description = describe(plan, settings);
    return plan;
}

} // namespace smat
