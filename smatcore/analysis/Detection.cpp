#include "smatcore/analysis/Detection.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "irsg/atmosphere/EnvironmentVariants.h"
#include "irsg/atmosphere/NearestRun.h"
#include "irsg/core/AppendUnique.h"
#include "irsg/core/Errors.h"
#include "irsg/core/Quantity.h"
#include "irsg/core/Wording.h"
#include "irsg/radiometry/GaussLegendre.h"
#include "irsg/sensor/PointSpread.h"
#include "irsg/sensor/SensorNumbers.h"
#include "smatcore/analysis/AnalysisDefinition.h"
#include "smatcore/analysis/AnalysisProvenance.h"
#include "smatcore/analysis/CaseWarnings.h"
#include "smatcore/settings/SettingKeys.h"

namespace smat {

namespace {

using Found = irsg::DetectionRange::Found;

double ensquaredEnergy(const irsg::SensorDescription& sensor, PointPlace place, double source_K) {
    const irsg::PointSpread spread(sensor, source_K);
    if (place == PointPlace::centre)
        return spread.energyAt(0.0, 0.0);
    if (place == PointPlace::corner)
        return spread.energyAt(0.5, 0.5);
    const irsg::GaussRule& rule = irsg::gaussLegendre(6);
    double mean = 0.0;
    for (std::size_t i = 0; i < rule.nodes.size(); ++i)
        for (std::size_t j = 0; j < rule.nodes.size(); ++j)
            mean += rule.weights[i] * rule.weights[j] *
                    spread.energyAt(0.5 * rule.nodes[i], 0.5 * rule.nodes[j]);
    return mean;
}

/// What is known of a case at a range.
struct Look {
    double contrast_W_m2 = 0.0, contrast_W_sr = 0.0, error_W_m2 = 0.0, solidAngle_sr = 0.0;
    double nei_W_m2 = 0.0;
    bool isFull = false; ///< the pixel, of the background alone
    double ratio() const { return std::abs(contrast_W_m2) / nei_W_m2; }
};

/// One aspect at any range.
class Aspect {
  public:
    Aspect(const DetectionRequest& request, const irsg::PixelResponse& response, double energy,
           const CasePlacer& placer, const SceneDescription& scene, const RenderDoor& door,
           AnalysisCase one, AnalysisData& data, CaseWarnings& warnings)
        : request_(request),
          response_(response),
          energy_(energy),
          placer_(placer),
          scene_(scene),
          door_(door),
          case_(std::move(one)),
          data_(data),
          warnings_(warnings) {}

    Look at(double range_m, bool withErrors) {
        const auto key = std::pair(range_m, withErrors);
        if (const auto known = known_.find(key); known != known_.end())
            return known->second;
        case_.range_m = range_m;
        const PlacedCase placed = placer_.place(scene_, case_);
        const irsg::Outputs outputs = irsg::Outputs::reports().alongRange().withErrors(withErrors);
        const irsg::RenderReport report = placed.render(door_, outputs).reports.front();
        irsg::addProvider(data_.providedBy, report.providedBy);
        warnings_.addReport(report, data_.settings[key::renderLayers]);
        Look look;
        look.contrast_W_m2 = report.all.irradiance_W_m2;
        look.contrast_W_sr = report.all.contrastIntensity_W_sr;
        look.solidAngle_sr = report.all.solidAngle_sr;
        for (const irsg::ObjectRadiometry& object : report.objects)
            if (report.all.solidAngle_sr == 0.0)
                look.solidAngle_sr += object.solidAngle_sr;
        if (report.all.errors)
            look.error_W_m2 = report.all.errors->irradiance_W_m2.sum();
        irsg::PixelSignal signal = response_.offset();
        signal.scene = request_.background_K
                           ? response_.signal(*request_.background_K).scene
                           : report.background_W_m2_sr * response_.signalPerRadiance();
        look.isFull = signal.total() >= response_.fullSignal();
        look.nei_W_m2 =
            response_.noise(signal).total() / (response_.signalPerIrradiance() * energy_);
        return known_[key] = look;
    }

  private:
    const DetectionRequest& request_;
    const irsg::PixelResponse& response_;
    double energy_;
    const CasePlacer& placer_;
    const SceneDescription& scene_;
    const RenderDoor& door_;
    AnalysisCase case_;
    AnalysisData& data_;
    CaseWarnings& warnings_;
    std::map<std::pair<double, bool>, Look> known_;
};

void addColumns(ResultTable& table, const AnalysisPlan& plan) {
    for (const irsg::Quantity quantity : plan.columns)
        table.add(quantity);
    table.add("detection_range", "m");
    table.add("error_detection_range", "m");
    table.add("outcome", "");
    table.add("crossings", "");
    table.add("snr", "");
    table.add("contrast_irradiance", "W m-2");
    table.add(irsg::Quantity::contrastIntensity);
    table.add("nei", "W m-2");
    table.add("extent", "px");
}

double outcomeOf(Found found) {
    return found == Found::atRange ? 0.0 : found == Found::beyond ? 1.0 : -1.0;
}

void summariseRanges(AnalysisData& data) {
    const ResultColumn* ranges = data.table.find("detection_range");
    if (ranges == nullptr || ranges->values.empty())
        return;
    const auto& angles = data.table.columns().front();
    const auto [least, most] = std::ranges::minmax_element(ranges->values);
    const auto where = [&](auto it) {
        return fmt::format(" at {:.6g} {}",
                           angles.values[static_cast<std::size_t>(it - ranges->values.begin())],
                           angles.unit);
    };
    data.summary.push_back({"Largest detection range" + where(most), *most, "m"});
    data.summary.push_back({"Least detection range" + where(least), *least, "m"});
}

} // namespace

void runDetection(AnalysisData& data, const DetectionRequest& request, const RenderDoor& door,
                  const SceneFactory& scenes, const RunControl& control) {
    const auto start = std::chrono::steady_clock::now();
    const auto elapsed_s = [&] {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    const Settings settings = withFixedSteps(data.kind, data.settings);
    AnalysisPlan plan = planAnalysis(data.kind, data.project, settings);
    SceneDescription scene = scenes(data.project, settings);
    scene.environment = irsg::onTheFly(scene.environment);
    // Contrast is of the whole target, whatever the sensor's frame is at its range.
    scene.sensor.band = request.sensor.band();
    scene.moreBands.clear();
    const CasePlacer placer(door, scene);
    for (const irsg::Entity& entity : scene.entities)
        data.databases.push_back(entity.database);
    data.renderer = door.description(scene);
    irsg::appendUnique(data.warnings, scene.remarks);

    const irsg::PixelResponse response(request.sensor);
    const double energy =
        ensquaredEnergy(request.sensor, request.place, request.background_K.value_or(300.0));
    addColumns(data.table, plan);
    CaseWarnings warnings;
    std::size_t done = 0, resolved = 0, never = 0, beyond = 0, full = 0;
    if (control.isRehearsal) {
        AnalysisCase first = plan.cases.front();
        first.range_m = request.limits.nearest_m;
        const PlacedCase placed = placer.place(scene, first);
        door.check(placed.scene, placed.view, irsg::Outputs::reports());
        return;
    }
    // Paths into the ground, say.
    double leastRefused_m = std::numeric_limits<double>::infinity();
    std::string refusal;
    for (const AnalysisCase& one : plan.cases) {
        if (control.stop.stop_requested())
            break;
        const std::string place = plan.place(one);
        if (control.progress)
            control.progress({done, plan.cases.size(), elapsed_s(), "detection: " + place});
        warnings.beginCase(place);
        Aspect aspect(request, response, energy, placer, scene, door, one, data, warnings);
        (void)aspect.at(request.limits.nearest_m, false); // refuses what no range would change
        const auto ratio = [&](double range_m) {
            try {
                return aspect.at(range_m, false).ratio();
            } catch (const irsg::InputError& error) {
                if (range_m < leastRefused_m) {
                    leastRefused_m = range_m;
                    refusal = error.what();
                }
                return 0.0;
            }
        };
        const irsg::DetectionRange found =
            irsg::detectionRange(ratio, request.threshold, request.limits);
        const double shown_m =
            found.found == Found::nowhere ? request.limits.nearest_m : found.range_m;
        const Look look = aspect.at(shown_m, true);
        double error_m = 0.0;
        if (found.found == Found::atRange && found.slope != 0.0)
            error_m = std::hypot(look.error_W_m2 / std::abs(look.contrast_W_m2) * found.range_m /
                                     std::abs(found.slope),
                                 request.limits.tolerance * found.range_m);
        const double extent =
            std::sqrt(std::max(0.0, look.solidAngle_sr)) / request.sensor.pixelAngle_rad();
        never += found.found == Found::nowhere;
        beyond += found.found == Found::beyond;
        full += look.isFull;
        resolved += found.found != Found::nowhere && extent > 1.0;
        std::vector<double> row;
        for (const irsg::Quantity quantity : plan.columns)
            row.push_back(one.value(quantity));
        row.insert(row.end(), {found.range_m, error_m, outcomeOf(found.found),
                               static_cast<double>(found.crossings), look.ratio(),
                               look.contrast_W_m2, look.contrast_W_sr, look.nei_W_m2, extent});
        data.table.addRow(row);
        ++done;
    }
    irsg::appendUnique(data.warnings, warnings.sentences());
    const auto tell = [&](std::size_t count, const char* what) {
        if (count > 0)
            data.warnings.push_back(fmt::format("{} of {} aspects {}", count, done, what));
    };
    tell(never, "are below the threshold at every range: their range is 0");
    tell(beyond, "are above the threshold at the farthest range, which is given for them");
    tell(resolved, "have an image larger than a pixel at that range: the ratio of a point, which "
                   "collects the whole target in one pixel, overstates it");
    tell(full, "have a background that fills the pixels: their noise is that of a larger well");
    if (!refusal.empty())
        data.warnings.push_back(fmt::format("nothing is seen over {} m or more: {}",
                                            irsg::roundedText(leastRefused_m, 3), refusal));
    if (done < plan.cases.size())
        data.warnings.push_back(
            fmt::format("stopped after {} of {} cases", done, plan.cases.size()));
    data.state = done == plan.cases.size() ? AnalysisState::complete : AnalysisState::partial;
    data.elapsed_s = elapsed_s();
    writeProvenance(data, scene);
    Provenance& provenance = data.table.provenance;
    // A polar plot of these settings has other numbers.
    for (auto& [key, value] : provenance.entries)
        if (key == "analysis")
            value = "detection";
    provenance.add("detection.sensor", request.sensor.title);
    provenance.add("detection.snr", irsg::numberText(request.threshold));
    provenance.add("detection.ensquaredEnergy", irsg::numberText(energy));
    provenance.add("detection.background", request.background_K
                                               ? irsg::numberText(*request.background_K) + " K"
                                               : "of the scene");
    summariseRanges(data);
}

} // namespace smat
