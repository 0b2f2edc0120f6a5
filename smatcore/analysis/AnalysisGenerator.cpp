#include "smatcore/analysis/AnalysisGenerator.h"

#include <algorithm>
#include <chrono>
#include <functional>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "irsg/atmosphere/EnvironmentVariants.h"
#include "irsg/atmosphere/NearestRun.h"
#include "irsg/core/AppendUnique.h"
#include "irsg/core/Quantity.h"
#include "irsg/core/Wording.h"
#include "smatcore/analysis/AdaptiveSweep.h"
#include "smatcore/analysis/AnalysisDefinition.h"
#include "smatcore/analysis/AnalysisProvenance.h"
#include "smatcore/analysis/CalculationChoice.h"
#include "smatcore/analysis/CaseWarnings.h"
#include "smatcore/analysis/ErrorColumns.h"
#include "smatcore/analysis/IdleSettings.h"
#include "smatcore/analysis/ImageFiles.h"
#include "smatcore/analysis/ImageSensor.h"
#include "smatcore/analysis/SweepTable.h"
#include "smatcore/analysis/SweepTarget.h"
#include "smatcore/settings/SettingKeys.h"
#include "smatcore/support/Log.h"

namespace smat {

namespace {

using irsg::Outputs;
using Target = std::optional<SweepTarget>;
using Reports = std::vector<irsg::RenderReport>;

void drawImage(AnalysisData& data, const PlacedCase& placed, const RenderDoor& door,
               const AnalysisPlan& plan, const Target& target, SweepTable& table,
               CaseWarnings& warnings) {
    const bool errors = plan.errors != ErrorColumns::none;
    const bool hasSensor = !data.settings[key::imageSensor].empty();
    irsg::Rendered rendered =
        hasSensor ? placed.render(door, Outputs::reports().withErrors(errors))
                  : placed.render(door, Outputs::imageWithReports().withErrors(errors));
    if (hasSensor)
        for (const std::string& sentence : drawThroughSensor(rendered.image, data, placed, door))
            warnings.add(sentence);
    const irsg::RenderReport& report = rendered.reports.front();
    if (report.all.errors)
        describeErrors(*report.all.errors, rendered.image);
    irsg::addProvider(data.providedBy, report.providedBy);
    warnings.addReport(report, data.settings[key::renderLayers]);
    if (target)
        target->check(rendered.reports, warnings);
    table.addCase(plan.cases.front(), rendered.reports, rowWarning(warnings.remarks()));
    data.image = std::move(rendered.image);
    const std::string sentence = showQuantity(data.image, placed.view.sensor, data.settings);
    if (!sentence.empty())
        warnings.add(sentence);
}

/// What an image of the view would print.
std::vector<SummaryItem> inBandOf(const irsg::ObjectRadiometry& all) {
    std::vector<SummaryItem> items;
    const auto add = [&](irsg::Quantity quantity, double value,
                         irsg::ErrorParts irsg::RadiometryErrors::*error) {
        const irsg::QuantityInfo& info = irsg::info(quantity);
        SummaryItem& item = items.emplace_back(
            SummaryItem{"in_band_" + std::string(info.key), value, std::string(info.unit)});
        if (all.errors)
            item.error = (*all.errors.*error).sum();
    };
    using Errors = irsg::RadiometryErrors;
    add(irsg::Quantity::intensity, all.intensity_W_sr, &Errors::intensity_W_sr);
    add(irsg::Quantity::contrastIntensity, all.contrastIntensity_W_sr,
        &Errors::contrastIntensity_W_sr);
    add(irsg::Quantity::irradiance, all.irradiance_W_m2, &Errors::irradiance_W_m2);
    return items;
}

void measureSpectrum(AnalysisData& data, const PlacedCase& placed, const RenderDoor& door,
                     const AnalysisPlan& plan, SweepTable& table, CaseWarnings& warnings) {
    // The sums of the same view say who answered for the air, and what the band has in all.
    const bool errors = plan.errors != ErrorColumns::none;
    const irsg::RenderReport report =
        placed.render(door, Outputs::reports().withErrors(errors)).reports.front();
    irsg::addProvider(data.providedBy, report.providedBy);
    warnings.addReport(report, data.settings[key::renderLayers]);
    data.inBand = inBandOf(report.all);
    const irsg::IntensitySpectrum spectrum =
        placed.render(door, Outputs::spectrum(plan.wavenumbers_per_cm).withErrors(errors)).spectrum;
    for (const std::string& sentence : spectrum.warnings)
        warnings.add(sentence);
    table.addSpectrum(spectrum);
}

/// One case of a sweep, in every band.
CaseRecord recordOf(const AnalysisData& data, const Reports& reports, const AnalysisCase& one,
                    const Target& target, const SweepTable& table, CaseWarnings& warnings,
                    std::string place) {
    CaseRecord record{std::move(place), table.rowOf(one, reports), {}, {}};
    for (const irsg::RenderReport& report : reports) {
        irsg::addProvider(record.providedBy, report.providedBy);
        warnings.addReport(report, data.settings[key::renderLayers]);
    }
    if (target)
        target->check(reports, warnings);
    record.remarks = warnings.remarks();
    return record;
}

std::string caseName(const AnalysisPlan& plan, const AnalysisCase& one) {
    if (plan.cases.size() == 1)
        return name(plan.kind);
    const std::string axis =
        plan.axes.empty() ? std::string(irsg::info(plan.coordinate).key) + " " : "";
    return fmt::format("{}: {}{}", name(plan.kind), axis, plan.place(one));
}

/// A case that is on its way.
struct BegunCase {
    const AnalysisCase* one;
    std::size_t number;
    PlacedCase placed;
    std::optional<irsg::PendingRender> reports; ///< of a sweep
};

/// Lets drawings serve all states of a sweep where these are few: those of a table.
void shareDrawings(const AnalysisPlan& plan, SceneDescription& scene) {
    constexpr std::size_t most = 8;
    std::vector<const AnalysisCase*> states;
    for (const AnalysisCase& one : plan.cases) {
        const auto isLike = [&](const AnalysisCase* known) {
            return known->time_s == one.time_s && known->power == one.power &&
                   known->mach == one.mach;
        };
        if (std::ranges::none_of(states, isLike))
            states.push_back(&one);
        if (states.size() > most)
            return;
    }
    for (std::size_t i = 0; states.size() > 1 && i < scene.entities.size(); ++i)
        for (const AnalysisCase* one : states)
            scene.entities[i].otherStates.push_back(
                one->state(scene.entities[i].state, scene.ownOf(i)));
}

void addPlaced(const std::string& place, const PlacedCase& placed, CaseWarnings& warnings) {
    warnings.beginCase(place);
    warnings.addObjectsBeyondFrame(placed.scene, placed.view);
    for (const std::string& sentence : placed.clampedTables())
        warnings.add(sentence);
}

/// True where a case of a sweep with the longest of its paths may have an object behind the
/// horizon. Ranges and tables tell which part of it is.
bool mayHide(const AnalysisData& data, const CasePlacer& placer, const SceneDescription& scene,
             const AnalysisPlan& plan) {
    if (data.kind != AnalysisKind::range && data.kind != AnalysisKind::table)
        return false;
    const auto longer = [](const AnalysisCase& a, const AnalysisCase& b) {
        return a.range_m < b.range_m;
    };
    const double longest_m = std::ranges::max_element(plan.cases, longer)->range_m;
    const irsg::SpectralRange range = scene.allBands().front().range();
    return std::ranges::any_of(plan.cases, [&](const AnalysisCase& one) {
        if (one.range_m < longest_m)
            return false;
        const PlacedCase placed = placer.place(scene, one);
        const irsg::Vec3& sensor_m = placed.view.viewpoint.position_m;
        return std::ranges::any_of(placed.scene.entities, [&](const irsg::Entity& entity) {
            const irsg::Vec3& target_m = entity.pose.position_m;
            const irsg::AtmosphericPath path{std::max(sensor_m.z, 0.0), std::max(target_m.z, 0.0),
                                             irsg::length(target_m - sensor_m), 0.0};
            return scene.environment.targetView(path, range).hiddenBelow_m > 0.0;
        });
    });
}

} // namespace

AnalysisGenerator::AnalysisGenerator(RenderDoor door, SceneFactory scenes)
    : door_(std::move(door)), scenes_(std::move(scenes)) {}

AnalysisPlan AnalysisGenerator::plan(const AnalysisData& data) const {
    return planAnalysis(data.kind, data.project, data.settings);
}

PlacedCase AnalysisGenerator::run(AnalysisData& data, const ProgressCallback& progress,
                                  std::stop_token stop, StageTimer* timer, CaseStore* store) const {
    // Everything that can be refused is looked at before the first drawing.
    AnalysisPlan cases = plan(data);
    SceneDescription scene;
    {
        const StageTimer::Scope scope(timer, "load");
        scene = scenes_(data.project, data.settings);
    }
    return runAnalysis(data, std::move(cases), std::move(scene), door_,
                       {progress, std::move(stop), timer, store});
}

PlacedCase runAnalysis(AnalysisData& data, AnalysisPlan cases, SceneDescription scene,
                       const RenderDoor& door, const RunControl& control) {
    const ProgressCallback& progress = control.progress;
    CaseStore* const store = control.store;
    const auto start = std::chrono::steady_clock::now();
    const auto elapsed_s = [&] {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    data.state = AnalysisState::notRun;
    data.image = {};
    data.table = {};
    data.summary.clear();
    data.inBand.clear();
    data.databases.clear();
    data.providedBy.clear();
    data.warnings.clear();

    followSensor(data);
    followSensor(data, scene);
    // A case of a sweep has the same numbers whatever was before it, and those of an image.
    scene.environment = irsg::onTheFly(scene.environment);
    std::optional<CasePlacer> placer;
    irsg::StageTimes before;
    {
        const StageTimer::Scope scope(control.timer, "set up");
        if (data.kind->form == AnalysisForm::sweep && data.settings[key::sensorMode] == "auto") {
            CalculationChoice choice = chooseCalculation(scene, cases);
            scene.settings.mode = choice.mode;
            if (!choice.reason.empty() && !data.settings[key::renderTargetError])
                data.providedBy.push_back(std::move(choice.reason));
        }
        if (data.kind->form == AnalysisForm::sweep)
            shareDrawings(cases, scene);
        placer.emplace(door, scene);
        for (const irsg::Entity& entity : scene.entities)
            data.databases.push_back(entity.database);
        data.renderer = door.description(scene);
        before = door.stageTimes();
    }
    irsg::appendUnique(data.warnings, scene.remarks);
    irsg::appendUnique(data.warnings, idleSettingRemarks(data));
    SweepTable table(cases, scene, data.table, mayHide(data, *placer, scene, cases));
    std::optional<AdaptiveSweep> adaptive;
    if (!cases.refined.empty())
        adaptive.emplace(cases, data.table);

    {
        const Target target = [&] {
            const StageTimer::Scope scope(control.timer, "choose");
            if (control.isRehearsal)
                return Target(); // it is chosen by drawing
            if (progress && data.settings[key::renderTargetError])
                progress({0, cases.cases.size(), elapsed_s(), name(data.kind) + ": target error"});
            return SweepTarget::choose(door, *placer, scene, cases, data.settings);
        }();
        if (target)
            irsg::appendUnique(data.providedBy, target->choice().sentences);
        const StageTimer::Scope scope(control.timer, "analyse");
        logInfo(cases.description);
        std::size_t done = 0;
        CaseWarnings warnings;
        // What stands in the data at any time is what is known by then: a window that does not wait
        // for a drawing takes it.
        const std::vector<std::string> ofLoading = data.warnings;
        const auto tellWarnings = [&] {
            data.warnings = ofLoading;
            irsg::appendUnique(data.warnings, warnings.sentences());
        };
        const auto take = [&](const CaseRecord& record) {
            data.table.insertRow(adaptive ? adaptive->add(record.row) : done, record.row,
                                 rowWarning(record.remarks));
            irsg::addProvider(data.providedBy, record.providedBy);
            tellWarnings();
            ++done;
        };
        // A case of a sweep is finished when the next one has been begun: drawing never waits.
        std::optional<BegunCase> begun;
        const auto finish = [&](BegunCase one) {
            const std::string place = cases.place(*one.one);
            addPlaced(place, one.placed, warnings);
            if (one.reports) {
                const CaseRecord record = recordOf(data, one.reports->get().reports, *one.one,
                                                   target, table, warnings, place);
                take(record);
                if (store != nullptr)
                    store->add(one.number, record);
                return;
            }
            if (data.kind->form == AnalysisForm::image)
                drawImage(data, one.placed, door, cases, target, table, warnings);
            else
                measureSpectrum(data, one.placed, door, cases, table, warnings);
            tellWarnings();
            ++done;
        };
        const auto finishBegun = [&] {
            if (begun)
                finish(*std::exchange(begun, std::nullopt));
        };
        if (cases.isAlongRange)
            data.providedBy.push_back(
                "range curves through samples at five distances: may differ from an image at one "
                "range by the stated error");
        if (store != nullptr) {
            writeProvenance(data, scene);
            // How many cases an adaptive sweep has is not known before.
            const std::size_t count =
                adaptive ? static_cast<std::size_t>(mostCases) : cases.cases.size();
            // Of a target error the head holds what drawing chose.
            if (!control.isRehearsal)
                store->begin(data, count);
            else if (!data.settings[key::renderTargetError])
                store->rehearse(data, count);
        }
        if (control.isRehearsal) {
            checkCases(cases, *placer, scene, door);
            return placer->place(scene, cases.cases.front());
        }
        std::size_t wanted =
            store == nullptr ? cases.cases.size() : store->expected(cases.cases.size());
        const auto isAtEnd = [&](std::size_t i) {
            if (i < cases.cases.size() || !adaptive)
                return i >= cases.cases.size();
            finishBegun();
            const std::vector<AnalysisCase> more = adaptive->next();
            // References to cases stay: none is begun.
            cases.cases.insert(cases.cases.end(), more.begin(), more.end());
            wanted += more.size();
            return more.empty();
        };
        for (std::size_t i = 0; !isAtEnd(i); ++i) {
            const AnalysisCase& one = cases.cases[i];
            if (const CaseRecord* known = store ? store->known(i) : nullptr) {
                finishBegun();
                warnings.addCase(known->place, known->remarks);
                take(*known);
                continue;
            }
            if (store != nullptr && !store->isMine(i))
                continue;
            if (progress)
                progress({done + (begun ? 1 : 0), wanted, elapsed_s(), caseName(cases, one)});
            if (control.stop.stop_requested())
                break;
            logDebug(caseName(cases, one));
            BegunCase next{&one, i, placer->place(scene, one), {}};
            if (data.kind->form != AnalysisForm::sweep) {
                finish(std::move(next));
                continue;
            }
            try {
                next.reports = door.begin(next.placed.scene, next.placed.view,
                                          Outputs::reports(scene.allBands())
                                              .alongRange(cases.isAlongRange)
                                              .withSource(cases.withSource)
                                              .bySurface(cases.parts != PartsBy::none)
                                              .withErrors(cases.errors != ErrorColumns::none));
            } catch (...) {
                finishBegun();
                throw;
            }
            finishBegun();
            begun = std::move(next);
            if (!begun->reports->isDrawnBeside())
                finishBegun();
        }
        finishBegun();
        if (adaptive && done == cases.cases.size())
            data.providedBy.push_back(adaptive->sentence());
        if (progress)
            progress({done, wanted, elapsed_s(), name(data.kind)});
        data.state = done == cases.cases.size() ? AnalysisState::complete : AnalysisState::partial;
        if (done < wanted)
            data.warnings.push_back(fmt::format("stopped after {} of {} cases", done, wanted));
    }
    if (control.timer != nullptr) {
        std::vector<StageTimer::Stage> parts;
        for (const irsg::StageTimes::Stage& stage : door.stageTimes().since(before).stages)
            parts.push_back({stage.name, stage.seconds, stage.calls});
        control.timer->split("analyse", parts);
    }
    data.elapsed_s = elapsed_s();
    summarise(data);
    writeProvenance(data, scene);
    return placer->place(scene, cases.cases.front());
}

} // namespace smat
