#include "smatcore/analysis/TargetAspect.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "irsg/atmosphere/EnvironmentVariants.h"
#include "irsg/atmosphere/NearestRun.h"
#include "irsg/core/AppendUnique.h"
#include "irsg/core/Errors.h"
#include "irsg/core/Wording.h"
#include "irsg/radiance/RangeGeometry.h"
#include "smatcore/analysis/AnalysisDefinition.h"
#include "smatcore/analysis/BackgroundClutter.h"
#include "smatcore/analysis/CommandSettings.h"
#include "smatcore/analysis/IdleSettings.h"
#include "smatcore/analysis/PartColumns.h"
#include "smatcore/settings/SettingKeys.h"

namespace smat {

namespace {

/// By entity; none where nothing is left out. Throws InputError for names that no entry has.
std::vector<LeftOut> leftOutOf(const SceneDescription& scene,
                               const std::vector<std::string>& names) {
    if (names.empty())
        return {};
    std::vector<LeftOut> out(scene.entities.size());
    std::vector<std::string> known;
    std::set<std::string> met;
    const auto take = [&](const irsg::Entity& entity, PartsBy by, std::set<int>& indices) {
        for (const ObjectPart& part : partsOf(entity, by)) {
            irsg::appendUnique(known, {part.label});
            if (std::ranges::find(names, part.label) == names.end())
                continue;
            indices.insert(part.index);
            met.insert(part.label);
        }
    };
    for (std::size_t i = 0; i < out.size(); ++i) {
        take(scene.entities[i], PartsBy::temperature, out[i].temperatures);
        take(scene.entities[i], PartsBy::material, out[i].materials);
    }
    std::vector<irsg::Diagnostic> diagnostics;
    for (const std::string& name : names)
        if (!met.contains(name))
            diagnostics.push_back(
                {"", "surfaces that are left out", name, irsg::alternatives(known)});
    if (!diagnostics.empty())
        throw irsg::InputError(diagnostics);
    return out;
}

/// The settings of a detection: those of a polar plot, or of a signature table.
AnalysisPlan planOf(AnalysisData& data, RangeCases cases) {
    // What these say of where their cases are holds here, too.
    data.kind = kindOf(cases);
    AnalysisPlan plan =
        planAnalysis(data.kind, data.project, withFixedSteps(data.kind, data.settings));
    if (cases == RangeCases::directions) {
        if (plan.isAlongRange)
            throw irsg::InputError({"", "table.ranges", data.settings.text("table.ranges"),
                                    "as-set: the range of each direction is sought"});
        // The range of a case is where clutter is measured, no part of where it is.
        plan.columns = plan.axes;
    }
    return plan;
}

SceneDescription sceneOf(AnalysisData& data, const DetectionRequest& request,
                         const SceneFactory& scenes) {
    SceneDescription scene = scenes(data.project, withFixedSteps(data.kind, data.settings));
    scene.environment = irsg::onTheFly(scene.environment);
    // Contrast is of the whole target, whatever the sensor's frame is at its range.
    scene.sensor.band = request.sensor.band();
    scene.moreBands.clear();
    // Before what is behind the target itself, which no row of a picture is.
    scene.settings.backgroundRows = 0;
    scene.settings.backgroundColumns = 1;
    // Far away a target is smaller than a pixel, which other modes miss.
    if (!scene.settings.usesAlignedTiles()) {
        scene.settings.tileStrategy = irsg::TileStrategy::aligned;
        scene.settings.tileSide_samples = irsg::RenderSettings().tileSide_samples;
        // Once, however many values a comparison has.
        irsg::appendUnique(
            data.warnings,
            {fmt::format(
                "the antialiasing of the settings misses targets below a pixel: ranges are "
                "sought with tiles of {} samples",
                scene.settings.tileSide_samples)});
    }
    return scene;
}

/// A frame that the sphere of a lone target fills, its radius in distances to it: what is behind it
/// is seen as sharply as the target itself, and nothing beside it is rendered.
irsg::Sensor frameOf(irsg::Sensor sensor, double nearness) {
    constexpr int pixels = 32, margin_px = 3; // what is beside an object is looked at, too
    constexpr double tooNear = 0.9;
    if (nearness > tooNear)
        return sensor;
    const double tangent = nearness / std::sqrt(1.0 - nearness * nearness);
    sensor.width_px = sensor.height_px = pixels + 2 * margin_px;
    sensor.horizontalFieldOfView_rad = 2.0 * std::atan(tangent * sensor.width_px / pixels);
    return sensor;
}

} // namespace

DetectionScene::DetectionScene(AnalysisData& data, const DetectionRequest& request,
                               const RenderDoor& theDoor, const SceneFactory& scenes)
    : door(theDoor),
      plan(planOf(data, request.cases)),
      scene(sceneOf(data, request, scenes)),
      placer(door, scene),
      leftOut(leftOutOf(scene, request.leftOut)) {
    for (const irsg::Entity& entity : scene.entities)
        data.databases.push_back(entity.database);
    data.renderer = door.description(scene);
    irsg::appendUnique(data.warnings, scene.remarks);
    irsg::appendUnique(data.warnings, idleSettingRemarks(data, request.draws > 0));
}

void DetectionScene::check(double range_m) const {
    AnalysisCase first = plan.cases.front();
    first.range_m = range_m;
    const PlacedCase placed = placer.place(scene, first);
    door.check(placed.scene, placed.view, irsg::Outputs::reports());
}

TargetAspect::TargetAspect(const DetectionScene& shared, const SceneDescription& scene,
                           TargetSight& sight, AnalysisCase one, AnalysisData& data,
                           CaseWarnings& warnings)
    : shared_(shared),
      scene_(scene),
      sight_(sight),
      case_(std::move(one)),
      data_(data),
      warnings_(warnings) {}

std::pair<double, double> TargetAspect::takeClutter(BackgroundClutter& clutter) {
    const MeasuredClutter measured = clutter.of(shared_.placer.place(scene_, case_));
    clutter_W_m2_sr_ = measured.deviation_W_m2_sr;
    clutterError_W_m2_sr_ = measured.error_W_m2_sr;
    known_.clear();
    const auto inKelvin = [&](double radiance_W_m2_sr) {
        return sight_.temperatureDifference_K(radiance_W_m2_sr, measured.background_W_m2_sr);
    };
    return {inKelvin(measured.deviation_W_m2_sr), inKelvin(measured.error_W_m2_sr)};
}

bool TargetAspect::isLone() const {
    return scene_.entities.size() == 1;
}

double TargetAspect::reach_m() const {
    return shared_.door.reach_m(scene_.entities.front());
}

double TargetAspect::drawnBelow_m() const {
    // Where it is too near for one drawing, or reaches out of the frame.
    const irsg::Sensor& sensor = scene_.sensor;
    const double halfSide = 0.5 * sensor.pixelPitch() * std::min(sensor.width_px, sensor.height_px);
    constexpr double margin = 1.01;
    const double ofFrame = isLone() ? 0.0 : 1.0 + 1.0 / halfSide;
    return margin * reach_m() * std::max(1.0 / irsg::RangeGeometry::closest, ofFrame);
}

void TargetAspect::sampleFrom(double range_m) {
    if (sampledFrom_m_ == range_m)
        return;
    sampledFrom_m_ = range_m;
    // Far from there another sampling changes nothing of whether the target is seen.
    constexpr double apart = 2.0;
    const auto isFar = [](double one, double other) {
        return std::max(one, other) > apart * std::min(one, other);
    };
    std::erase_if(known_, [&](const auto& known) {
        return known.second.alongRangeReach_m > 0.0 &&
               !(isFar(known.first.first, range_m) &&
                 isFar(sight_.reached(known.second), sight_.wanted()));
    });
}

TargetLook TargetAspect::at(double range_m, bool withErrors) {
    const auto key = std::pair(range_m, withErrors);
    if (const auto known = known_.find(key); known != known_.end())
        return known->second;
    return known_[key] = rendered(range_m, irsg::Outputs::reports().withErrors(withErrors));
}

TargetLook TargetAspect::throughDepth(double range_m, double depth) {
    return rendered(range_m, irsg::Outputs::reports().withErrors(false).throughDepth(depth));
}

TargetLook TargetAspect::rendered(double range_m, const irsg::Outputs::Reports& wanted) {
    case_.range_m = range_m;
    PlacedCase placed = shared_.placer.place(scene_, case_);
    if (isLone())
        placed.view.sensor = frameOf(placed.view.sensor, reach_m() / range_m);
    const irsg::Outputs::Reports ofRange =
        sampledFrom_m_ ? wanted.alongRangeFrom(*sampledFrom_m_) : wanted.alongRange();
    const irsg::Outputs outputs = ofRange.bySurface(!shared_.leftOut.empty());
    const irsg::RenderReport report = placed.render(shared_.door, outputs).reports.front();
    irsg::addProvider(data_.providedBy, report.providedBy);
    warnings_.addReport(report, data_.settings[key::renderLayers]);
    TargetLook look;
    look.contrast_W_m2 = report.all.irradiance_W_m2;
    look.contrast_W_sr = report.all.contrastIntensity_W_sr;
    look.solidAngle_sr = report.all.solidAngle_sr;
    for (const irsg::ObjectRadiometry& object : report.objects)
        if (report.all.solidAngle_sr == 0.0)
            look.solidAngle_sr += object.solidAngle_sr;
    look.counted_W_m2 = look.contrast_W_m2;
    for (std::size_t i = 0; i < shared_.leftOut.size(); ++i)
        for (const irsg::SurfaceRadiometry& surface : report.objects.at(i).surfaces)
            if (shared_.leftOut[i].has(surface)) {
                look.counted_W_m2 -= surface.irradiance_W_m2;
                look.solidAngle_sr -= surface.solidAngle_sr;
            }
    if (report.all.errors)
        look.error_W_m2 = report.all.errors->irradiance_W_m2.sum();
    look.background_W_m2_sr = report.background_W_m2_sr;
    look.alongRangeReach_m = report.alongRangeReach_m;
    look.clutter_W_m2_sr = clutter_W_m2_sr_;
    look.clutterError_W_m2_sr = clutterError_W_m2_sr_;
    sight_.see(look);
    return look;
}

double TargetAspect::alongRangeReach_m(const irsg::DetectionRange& found) {
    double reach_m = 0.0;
    for (const auto& node : found.around)
        reach_m = std::max(reach_m, at(node.range_m, false).alongRangeReach_m);
    return reach_m;
}

TargetLook TargetAspect::between(const irsg::DetectionRange& found) {
    std::vector<TargetLook> looks;
    for (const auto& node : found.around)
        looks.push_back(at(node.range_m, false));
    // By logarithms, which bend little, where there are some.
    const auto mean = [&](double TargetLook::*member) {
        double sum = 0.0, logarithms = 0.0;
        bool isOfOneSign = true;
        for (std::size_t i = 0; i < looks.size(); ++i) {
            const double value = looks[i].*member, weight = found.around[i].weight;
            sum += weight * value;
            isOfOneSign = isOfOneSign && value * looks.front().*member > 0.0;
            if (isOfOneSign)
                logarithms += weight * std::log(std::abs(value));
        }
        return isOfOneSign ? std::copysign(std::exp(logarithms), looks.front().*member) : sum;
    };
    TargetLook look;
    for (double TargetLook::*const member :
         {&TargetLook::contrast_W_m2, &TargetLook::contrast_W_sr, &TargetLook::counted_W_m2,
          &TargetLook::solidAngle_sr, &TargetLook::nei_W_m2, &TargetLook::difference_K,
          &TargetLook::cycles, &TargetLook::background_W_m2_sr, &TargetLook::noiseError})
        look.*member = mean(member);
    look.clutter_W_m2_sr = clutter_W_m2_sr_;
    look.isFull = std::ranges::any_of(looks, &TargetLook::isFull);
    const auto nearest =
        std::ranges::max_element(found.around, {}, &irsg::DetectionRange::Node::weight);
    const TargetLook known = at(nearest->range_m, true);
    if (known.contrast_W_m2 != 0.0)
        look.error_W_m2 = known.error_W_m2 * std::abs(look.contrast_W_m2 / known.contrast_W_m2);
    return look;
}

} // namespace smat
