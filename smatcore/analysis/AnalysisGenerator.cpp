#include "smatcore/analysis/AnalysisGenerator.h"

#include <chrono>

#include <fmt/format.h>

#include "smatcore/analysis/AnalysisProvenance.h"
#include "smatcore/analysis/CaseChecks.h"
#include "smatcore/analysis/CaseWarnings.h"
#include "smatcore/analysis/ImageFiles.h"
#include "smatcore/analysis/SceneRestorer.h"
#include "smatcore/analysis/SweepTable.h"
#include "smatcore/support/Log.h"
#include "smatcore/support/NewSentences.h"

namespace smat {

namespace {

void drawImage(AnalysisData& data, const SceneDescription& scene, ImageSource& source,
               const AnalysisCase& one, SweepTable& table, CaseWarnings& warnings) {
    irsg::RenderedImage rendered = source.render();
    addNew(data.answeredBy, rendered.report.answeredBy);
    warnings.addReport(rendered.report, data.settings.integer("render.layers"));
    table.addCase(one, {rendered.report});
    data.image = std::move(rendered.image);
    const std::string sentence = showQuantity(data.image, scene.sensor, data.settings);
    if (!sentence.empty()) {
        warnings.add(sentence);
    }
}

void measureSpectrum(AnalysisData& data, ImageSource& source, const AnalysisPlan& plan,
                     SweepTable& table, CaseWarnings& warnings) {
    // The sums of the same view say who answered for the air.
    const irsg::RenderReport report = source.measure();
    addNew(data.answeredBy, report.answeredBy);
    warnings.addReport(report, data.settings.integer("render.layers"));
    const irsg::IntensitySpectrum spectrum = source.measureSpectrum(plan.wavenumbers_cm1);
    for (const std::string& sentence : spectrum.warnings) {
        warnings.add(sentence);
    }
    table.addSpectrum(spectrum);
}

/// One case of a sweep, in every band.
void measureCase(AnalysisData& data, const SceneDescription& scene, ImageSource& source,
                 const AnalysisCase& one, SweepTable& table, CaseWarnings& warnings) {
    const std::vector<irsg::RenderReport> reports = source.measure(scene.allBands());
    for (const irsg::RenderReport& report : reports) {
        addNew(data.answeredBy, report.answeredBy);
        warnings.addReport(report, data.settings.integer("render.layers"));
    }
    table.addCase(one, reports);
}

std::string caseName(const AnalysisPlan& plan, const AnalysisCase& one) {
    if (plan.cases.size() == 1) {
        return name(plan.kind);
    }
    return fmt::format("{}: {} {}", name(plan.kind), irsg::info(plan.coordinate).key,
                       plan.place(one));
}

} // namespace

AnalysisGenerator::AnalysisGenerator(ImageSource& source, SceneFactory scenes)
    : source_(source), scenes_(std::move(scenes)) {}

AnalysisPlan AnalysisGenerator::plan(const AnalysisData& data) const {
    return planAnalysis(data.kind, data.project, data.settings);
}

void AnalysisGenerator::run(AnalysisData& data, const ProgressCallback& progress,
                            std::stop_token stop, StageTimer* timer) {
    const auto start = std::chrono::steady_clock::now();
    const auto elapsed_s = [&] {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    data.state = AnalysisState::notRun;
    data.image = {};
    data.table = {};
    data.summary.clear();
    data.answeredBy.clear();
    data.warnings.clear();

    // Everything that can be refused is looked at before the first drawing.
    const AnalysisPlan cases = plan(data);
    SceneDescription scene;
    {
        const StageTimer::Scope scope(timer, "load");
        scene = scenes_(data.project, data.settings);
    }
    std::vector<irsg::Vec3> inModel;
    {
        const StageTimer::Scope scope(timer, "set up");
        source_.configure(scene);
        for (std::size_t i = 0; i < scene.entities.size(); ++i) {
            inModel.push_back(source_.referencePointInModel(i));
        }
        data.renderer = source_.rendererDescription();
        source_.resetStageTimes();
    }
    addNew(data.warnings, scene.remarks);
    const irsg::Pose standing = scene.entities.front().pose;
    const irsg::Vec3 referencePoint = standing.toWorld(inModel.front());
    SweepTable table(cases, scene, data.table);

    {
        const SceneRestorer restore(source_, scene,
                                    standingCase(data.settings).viewpoint(referencePoint));
        const StageTimer::Scope scope(timer, "analyse");
        logInfo(cases.description);
        std::size_t done = 0;
        CaseWarnings warnings;
        // What stands in the data at any time is what is known by then: a window that does not wait
        // for a drawing takes it.
        const std::vector<std::string> before = data.warnings;
        const auto tellWarnings = [&] {
            data.warnings = before;
            addNew(data.warnings, warnings.sentences());
        };
        for (const AnalysisCase& one : cases.cases) {
            if (progress) {
                progress({done, cases.cases.size(), elapsed_s(), caseName(cases, one)});
            }
            if (stop.stop_requested()) {
                break;
            }
            logDebug(caseName(cases, one));

            warnings.beginCase(cases.place(one));
            std::vector<irsg::Pose> poses;
            for (const irsg::Entity& entity : scene.entities) {
                poses.push_back(entity.pose);
            }
            poses.front() = one.pose(standing, inModel.front());
            source_.setPose(0, poses.front());
            const irsg::Viewpoint viewpoint = one.viewpoint(referencePoint);
            source_.setViewpoint(viewpoint);
            // An image shows what it cuts off; a plot does not.
            if (data.kind != AnalysisKind::image) {
                warnings.addObjectsBeyondFrame(scene, poses, viewpoint);
            }
            for (std::size_t i = 0; i < scene.entities.size(); ++i) {
                const irsg::Entity& entity = scene.entities[i];
                irsg::EntityState state = entity.state;
                state.time_s = one.time_s;
                source_.setState(i, state);
                for (const std::string& sentence :
                     heldTables(entity, state, poses[i], poses[i].toWorld(inModel[i]),
                                viewpoint.position_m)) {
                    warnings.add(sentence);
                }
            }

            if (data.kind == AnalysisKind::image) {
                drawImage(data, scene, source_, one, table, warnings);
            } else if (data.kind == AnalysisKind::spectrum) {
                measureSpectrum(data, source_, cases, table, warnings);
            } else {
                measureCase(data, scene, source_, one, table, warnings);
            }
            tellWarnings();
            ++done;
        }
        if (progress) {
            progress({done, cases.cases.size(), elapsed_s(), name(data.kind)});
        }
        data.state = done == cases.cases.size() ? AnalysisState::complete : AnalysisState::partial;
        if (data.state == AnalysisState::partial) {
            data.warnings.push_back(
                fmt::format("stopped after {} of {} cases", done, cases.cases.size()));
        }
    }
    if (timer != nullptr) {
        std::vector<StageTimer::Stage> parts;
        for (const irsg::StageTimes::Stage& stage : source_.stageTimes().stages) {
            parts.push_back({stage.name, stage.seconds, stage.calls});
        }
        timer->split("analyse", parts);
    }
    data.elapsed_s = elapsed_s();
    summarise(data);
    writeProvenance(data, scene);
}

} // namespace smat
