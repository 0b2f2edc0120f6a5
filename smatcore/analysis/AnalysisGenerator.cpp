#include "smatcore/analysis/AnalysisGenerator.h"

#include <chrono>
#include <functional>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "irsg/atmosphere/EnvironmentVariants.h"
#include "irsg/atmosphere/NearestRun.h"
#include "irsg/core/NewLines.h"
#include "irsg/core/Quantity.h"
#include "irsg/core/Wording.h"
#include "smatcore/analysis/AdaptiveSweep.h"
#include "smatcore/analysis/AnalysisDefinition.h"
#include "smatcore/analysis/AnalysisProvenance.h"
#include "smatcore/analysis/CalculationChoice.h"
#include "smatcore/analysis/CaseChecks.h"
#include "smatcore/analysis/CaseWarnings.h"
#include "smatcore/analysis/ErrorColumns.h"
#include "smatcore/analysis/ImageFiles.h"
#include "smatcore/analysis/SceneRestorer.h"
#include "smatcore/analysis/SweepTable.h"
#include "smatcore/analysis/SweepTarget.h"
#include "smatcore/settings/SettingKeys.h"
#include "smatcore/support/Log.h"

namespace smat {

namespace {

using Target = std::optional<SweepTarget>;

void drawImage(AnalysisData& data, const SceneDescription& scene, ImageSource& source,
               const AnalysisPlan& plan, const Target& target, SweepTable& table,
               CaseWarnings& warnings) {
    const AnalysisCase& one = plan.cases.front();
    irsg::RenderedImage rendered =
        plan.errors == ErrorColumns::none ? source.render() : source.renderWithErrors();
    if (rendered.report.all.errors)
        describeErrors(*rendered.report.all.errors, rendered.image);
    irsg::addAnswer(data.answeredBy, rendered.report.answeredBy);
    warnings.addReport(rendered.report, data.settings[key::renderLayers]);
    if (target)
        target->check({rendered.report}, warnings);
    table.addCase(one, {rendered.report});
    data.image = std::move(rendered.image);
    const std::string sentence = showQuantity(data.image, scene.sensor, data.settings);
    if (!sentence.empty())
        warnings.add(sentence);
}

void measureSpectrum(AnalysisData& data, const SceneDescription& scene, ImageSource& source,
                     const AnalysisPlan& plan, SweepTable& table, CaseWarnings& warnings) {
    // The sums of the same view say who answered for the air.
    const bool errors = plan.errors != ErrorColumns::none;
    const irsg::RenderReport report =
        errors ? source.beginMeasure({{scene.sensor.band}, false, false, true})().front()
               : source.measure();
    irsg::addAnswer(data.answeredBy, report.answeredBy);
    warnings.addReport(report, data.settings[key::renderLayers]);
    const irsg::IntensitySpectrum spectrum =
        errors ? source.measureSpectrumWithErrors(plan.wavenumbers_per_cm)
               : source.measureSpectrum(plan.wavenumbers_per_cm);
    for (const std::string& sentence : spectrum.warnings)
        warnings.add(sentence);
    table.addSpectrum(spectrum);
}

/// One case of a sweep, in every band.
CaseRecord recordOf(const AnalysisData& data, const ImageSource::Reports& reports,
                    const AnalysisCase& one, const Target& target, const SweepTable& table,
                    CaseWarnings& warnings, std::string place) {
    CaseRecord record{std::move(place), table.rowOf(one, reports), {}, {}};
    for (const irsg::RenderReport& report : reports) {
        irsg::addAnswer(record.answeredBy, report.answeredBy);
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

/// What a case set, and what is to be said of it.
struct CaseSetUp {
    const AnalysisCase* one = nullptr;
    std::size_t number = 0;
    std::vector<irsg::Pose> poses; ///< by entity
    irsg::Viewpoint viewpoint;
    std::vector<std::string> sentences;
    std::function<ImageSource::Reports()> reports; ///< of a sweep: what was begun
};

/// Sets a case; `inScene` is the target's pose there.
CaseSetUp setUp(ImageSource& source, const SceneDescription& scene, const AnalysisCase& one,
                const irsg::Pose& inScene, const std::vector<irsg::Vec3>& inModel) {
    CaseSetUp set;
    const irsg::Pose standing = one.standing(inScene);
    set.one = &one;
    for (const irsg::Entity& entity : scene.entities)
        set.poses.push_back(entity.pose);
    set.poses.front() = one.pose(standing, inModel.front());
    source.setPose(0, set.poses.front());
    set.viewpoint = one.viewpoint(standing.toWorld(inModel.front()));
    source.setViewpoint(set.viewpoint);
    for (std::size_t i = 0; i < scene.entities.size(); ++i) {
        const irsg::Entity& entity = scene.entities[i];
        const irsg::EntityState state = one.state(entity.state, scene.ownOf(i));
        source.setState(i, state);
        for (std::string& sentence :
             clampedTableWarnings(entity, state, set.poses[i], set.poses[i].toWorld(inModel[i]),
                                  set.viewpoint.position_m)) {
            set.sentences.push_back(std::move(sentence));
        }
    }
    return set;
}

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

void addSetUp(const SceneDescription& scene, AnalysisKind kind, const std::string& place,
              const CaseSetUp& set, CaseWarnings& warnings) {
    warnings.beginCase(place);
    // An image shows what it cuts off; a plot does not.
    if (kind->form != AnalysisForm::image)
        warnings.addObjectsBeyondFrame(scene, set.poses, set.viewpoint);
    for (const std::string& sentence : set.sentences)
        warnings.add(sentence);
}

} // namespace

AnalysisGenerator::AnalysisGenerator(ImageSource& source, SceneFactory scenes)
    : source_(source), scenes_(std::move(scenes)) {}

AnalysisPlan AnalysisGenerator::plan(const AnalysisData& data) const {
    return planAnalysis(data.kind, data.project, data.settings);
}

void AnalysisGenerator::run(AnalysisData& data, const ProgressCallback& progress,
                            std::stop_token stop, StageTimer* timer, CaseStore* store) {
    const auto start = std::chrono::steady_clock::now();
    const auto elapsed_s = [&] {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    data.state = AnalysisState::notRun;
    data.image = {};
    data.table = {};
    data.summary.clear();
    data.databases.clear();
    data.answeredBy.clear();
    data.warnings.clear();

    // Everything that can be refused is looked at before the first drawing.
    AnalysisPlan cases = plan(data);
    SceneDescription scene;
    {
        const StageTimer::Scope scope(timer, "load");
        scene = scenes_(data.project, data.settings);
        // A case of a sweep has the same numbers whatever was before it, and those of an image.
        scene.environment = irsg::onTheFly(scene.environment);
    }
    std::vector<irsg::Vec3> inModel;
    {
        const StageTimer::Scope scope(timer, "set up");
        if (data.kind->form == AnalysisForm::sweep && data.settings[key::sensorMode] == "auto") {
            CalculationChoice choice = chooseCalculation(scene, cases);
            scene.render.mode = choice.mode;
            if (!choice.reason.empty() && !data.settings[key::renderTargetError])
                data.answeredBy.push_back(std::move(choice.reason));
        }
        if (data.kind->form == AnalysisForm::sweep)
            shareDrawings(cases, scene);
        source_.configure(scene);
        for (std::size_t i = 0; i < scene.entities.size(); ++i) {
            data.databases.push_back(scene.entities[i].database);
            inModel.push_back(source_.referencePointInModel(i));
        }
        data.renderer = source_.rendererDescription();
        source_.resetStageTimes();
    }
    irsg::addNew(data.warnings, scene.remarks);
    const irsg::Pose standing = scene.entities.front().pose;
    const irsg::Vec3 referencePoint = standing.toWorld(inModel.front());
    SweepTable table(cases, scene, data.table);
    std::optional<AdaptiveSweep> adaptive;
    if (!cases.refined.empty())
        adaptive.emplace(cases, data.table);

    {
        const SceneRestorer restore(source_, scene,
                                    startingCase(data.settings).viewpoint(referencePoint));
        const Target target = [&] {
            const StageTimer::Scope scope(timer, "choose");
            if (progress && data.settings[key::renderTargetError])
                progress({0, cases.cases.size(), elapsed_s(), name(data.kind) + ": target error"});
            return SweepTarget::choose(
                source_, scene, cases, data.settings,
                [&](const AnalysisCase& one) { setUp(source_, scene, one, standing, inModel); });
        }();
        if (target)
            irsg::addNew(data.answeredBy, target->choice().sentences);
        const StageTimer::Scope scope(timer, "analyse");
        logInfo(cases.description);
        std::size_t done = 0;
        CaseWarnings warnings;
        // What stands in the data at any time is what is known by then: a window that does not wait
        // for a drawing takes it.
        const std::vector<std::string> before = data.warnings;
        const auto tellWarnings = [&] {
            data.warnings = before;
            irsg::addNew(data.warnings, warnings.sentences());
        };
        const auto take = [&](const CaseRecord& record) {
            data.table.insertRow(adaptive ? adaptive->add(record.row) : done, record.row);
            irsg::addAnswer(data.answeredBy, record.answeredBy);
            tellWarnings();
            ++done;
        };
        // A case of a sweep is finished when the next one has been begun: drawing never waits.
        std::optional<CaseSetUp> begun;
        const auto finish = [&](const CaseSetUp& set) {
            addSetUp(scene, data.kind, cases.place(*set.one), set, warnings);
            if (data.kind->form == AnalysisForm::sweep) {
                const CaseRecord record = recordOf(data, set.reports(), *set.one, target, table,
                                                   warnings, cases.place(*set.one));
                take(record);
                if (store != nullptr)
                    store->add(set.number, record);
                return;
            }
            if (data.kind->form == AnalysisForm::image)
                drawImage(data, scene, source_, cases, target, table, warnings);
            else
                measureSpectrum(data, scene, source_, cases, table, warnings);
            tellWarnings();
            ++done;
        };
        const auto finishBegun = [&] {
            if (begun)
                finish(*std::exchange(begun, std::nullopt));
        };
        if (store != nullptr) {
            writeProvenance(data, scene);
            // How many cases an adaptive sweep has is not known before.
            store->begin(data, adaptive ? static_cast<std::size_t>(mostCases) : cases.cases.size());
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
            if (stop.stop_requested())
                break;
            logDebug(caseName(cases, one));
            CaseSetUp set = setUp(source_, scene, one, standing, inModel);
            set.number = i;
            if (data.kind->form != AnalysisForm::sweep) {
                finish(set);
                continue;
            }
            try {
                set.reports =
                    source_.beginMeasure({scene.allBands(), cases.isAlongRange, cases.withSource,
                                          cases.errors != ErrorColumns::none});
            } catch (...) {
                finishBegun();
                throw;
            }
            finishBegun();
            begun = std::move(set);
            if (!source_.drawsBeside())
                finishBegun();
        }
        finishBegun();
        if (adaptive && done == cases.cases.size())
            data.answeredBy.push_back(adaptive->sentence());
        if (progress)
            progress({done, wanted, elapsed_s(), name(data.kind)});
        data.state = done == cases.cases.size() ? AnalysisState::complete : AnalysisState::partial;
        if (done < wanted)
            data.warnings.push_back(fmt::format("stopped after {} of {} cases", done, wanted));
    }
    if (timer != nullptr) {
        std::vector<StageTimer::Stage> parts;
        for (const irsg::StageTimes::Stage& stage : source_.stageTimes().stages)
            parts.push_back({stage.name, stage.seconds, stage.calls});
        timer->split("analyse", parts);
    }
    data.elapsed_s = elapsed_s();
    summarise(data);
    writeProvenance(data, scene);
}

} // namespace smat
