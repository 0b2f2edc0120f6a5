#include "smatcore/analysis/AnalysisGenerator.h"

#include <algorithm>
#include <chrono>

#include <fmt/format.h>

#include "smatcore/analysis/AnalysisProvenance.h"
#include "smatcore/analysis/CaseChecks.h"
#include "smatcore/analysis/ImageFiles.h"
#include "smatcore/analysis/SceneRestorer.h"
#include "smatcore/support/Log.h"
#include "smatcore/support/NewSentences.h"

namespace smat {

namespace {

using irsg::Quantity;

void takeReport(AnalysisData& data, const irsg::RenderReport& report) {
    addNew(data.answeredBy, report.answeredBy);
    addNew(data.warnings, report.warnings);
}

/// What renderings could not do exactly: the worst of all cases, said once.
struct Shortcomings {
    int layersLeftOver = 0;
    double transmissivityResidue = 0.0;
    std::size_t casesBeyondFrame = 0;
    std::size_t casesWithoutPixels = 0;

    void take(const irsg::RenderReport& report) {
        casesWithoutPixels += report.all.coveredPixels > 0.0 ? 0 : 1;
        layersLeftOver = std::max(layersLeftOver, report.layersLeftOver);
        transmissivityResidue = std::max(transmissivityResidue, report.transmissivityResidue);
    }
    void sayIn(AnalysisData& data) const {
        if (casesWithoutPixels > 0) {
            data.warnings.push_back(
                fmt::format("no sample hits the target in {} of the cases: it is out of the frame, "
                            "too small for the sampling, or the camera is inside it",
                            casesWithoutPixels));
        }
        // An image shows what it cuts off; a plot does not.
        if (data.kind != AnalysisKind::image && casesBeyondFrame > 0) {
            data.warnings.push_back(fmt::format(
                "the target's bounding box reaches beyond the frame in {} of the cases; "
                "what lies outside is not in the sums",
                casesBeyondFrame));
        }
        if (layersLeftOver > 0) {
            data.warnings.push_back(
                fmt::format("up to {} samples of a drawing have more than {} transparent layers, "
                            "the rest of which is left out; see render.layers",
                            layersLeftOver, data.settings.integer("render.layers")));
        }
        // Sums multiply transmissivities at each wavelength; only an image has one per surface.
        if (data.kind == AnalysisKind::image && transmissivityResidue > 1e-3) {
            data.warnings.push_back(
                fmt::format("transmissivities that vary over the band are one number in an image; "
                            "the largest relative error of that is {:.2g}",
                            transmissivityResidue));
        }
    }
};

/// The sums of an image, or one case of a sweep, as a row of the table.
void startTable(AnalysisData& data, const AnalysisPlan& plan) {
    ResultTable& table = data.table;
    switch (plan.kind) {
    case AnalysisKind::spectrum:
        for (const Quantity quantity :
             {Quantity::wavenumber, Quantity::wavelength, Quantity::spectralIntensity,
              Quantity::spectralContrastIntensity, Quantity::spectralIrradiance}) {
            table.add(quantity);
        }
        return;
    case AnalysisKind::polar:
        for (const Quantity quantity :
             {Quantity::angle, Quantity::azimuth, Quantity::elevation, Quantity::yaw}) {
            table.add(quantity);
        }
        break;
    case AnalysisKind::image:
        table.add(Quantity::range);
        break;
    case AnalysisKind::range:
    case AnalysisKind::time:
        table.add(plan.coordinate);
        break;
    }
    for (const Quantity quantity :
         {Quantity::intensity, Quantity::contrastIntensity, Quantity::irradiance}) {
        table.add(quantity);
    }
    if (plan.kind == AnalysisKind::image) {
        table.add(Quantity::totalIrradiance);
    }
    table.add(Quantity::pixels);
}

void addCaseRow(AnalysisData& data, const AnalysisPlan& plan, const AnalysisCase& one,
                const irsg::RenderReport& report) {
    std::vector<double> row;
    switch (plan.kind) {
    case AnalysisKind::polar:
        row = {one.coordinate, one.shownAzimuth_deg, one.shownElevation_deg, one.shownYaw_deg};
        break;
    case AnalysisKind::image:
        row = {one.range_m};
        break;
    default:
        row = {one.coordinate};
    }
    const irsg::ObjectRadiometry& all = report.all;
    row.insert(row.end(), {all.intensity_W_sr, all.contrastIntensity_W_sr, all.irradiance_W_m2});
    if (plan.kind == AnalysisKind::image) {
        row.push_back(report.totalIrradiance_W_m2);
    }
    row.push_back(all.coveredPixels);
    data.table.addRow(row);
}

void drawImage(AnalysisData& data, const SceneDescription& scene, ImageSource& source,
               const AnalysisPlan& plan) {
    irsg::RenderedImage rendered = source.render();
    takeReport(data, rendered.report);
    Shortcomings shortcomings;
    shortcomings.take(rendered.report);
    shortcomings.sayIn(data);
    addCaseRow(data, plan, plan.cases.front(), rendered.report);
    data.image = std::move(rendered.image);
    const std::string sentence = showQuantity(data.image, scene.sensor, data.settings);
    if (!sentence.empty()) {
        addNew(data.warnings, {sentence});
    }
}

void measureSpectrum(AnalysisData& data, ImageSource& source, const AnalysisPlan& plan) {
    // The sums of the same view say who answered for the air.
    const irsg::RenderReport report = source.measure();
    takeReport(data, report);
    Shortcomings shortcomings;
    shortcomings.take(report);
    shortcomings.sayIn(data);
    const irsg::IntensitySpectrum spectrum = source.measureSpectrum(plan.wavenumbers_cm1);
    addNew(data.warnings, spectrum.warnings);
    for (std::size_t i = 0; i < spectrum.wavenumbers_cm1.size(); ++i) {
        data.table.addRow({spectrum.wavenumbers_cm1[i], spectrum.wavelengths_um[i],
                           spectrum.intensity_W_sr_um[i], spectrum.contrastIntensity_W_sr_um[i],
                           spectrum.irradiance_W_m2_um[i]});
    }
}

std::string caseName(const AnalysisPlan& plan, const AnalysisCase& one) {
    if (plan.cases.size() == 1) {
        return name(plan.kind);
    }
    const irsg::QuantityInfo& axis = irsg::info(plan.coordinate);
    return fmt::format("{}: {} {:.6g} {}", name(plan.kind), axis.key, one.coordinate, axis.unit);
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
    startTable(data, cases);

    {
        const AnalysisCase home =
            planAnalysis(AnalysisKind::image, data.project, data.settings).cases.front();
        const SceneRestorer restore(source_, scene, home.viewpoint(referencePoint));
        const StageTimer::Scope scope(timer, "analyse");
        logInfo(cases.description);
        std::size_t done = 0;
        Shortcomings shortcomings;
        for (const AnalysisCase& one : cases.cases) {
            if (progress) {
                progress({done, cases.cases.size(), elapsed_s(), caseName(cases, one)});
            }
            if (stop.stop_requested()) {
                break;
            }
            logDebug(caseName(cases, one));

            const irsg::Pose pose = one.pose(standing, inModel.front());
            source_.setPose(0, pose);
            const irsg::Viewpoint viewpoint = one.viewpoint(referencePoint);
            source_.setViewpoint(viewpoint);
            if (reachesBeyondFrame(scene.entities.front(), pose, viewpoint, scene.sensor)) {
                ++shortcomings.casesBeyondFrame;
            }
            for (std::size_t i = 0; i < scene.entities.size(); ++i) {
                const irsg::Entity& entity = scene.entities[i];
                irsg::EntityState state = entity.state;
                state.time_s = one.time_s;
                source_.setState(i, state);
                const irsg::Pose& at = i == 0 ? pose : entity.pose;
                addNew(data.warnings,
                       heldTables(entity, state, at, at.toWorld(inModel[i]), viewpoint.position_m));
            }

            if (data.kind == AnalysisKind::image) {
                drawImage(data, scene, source_, cases);
            } else if (data.kind == AnalysisKind::spectrum) {
                measureSpectrum(data, source_, cases);
            } else {
                const irsg::RenderReport report = source_.measure();
                takeReport(data, report);
                shortcomings.take(report);
                addCaseRow(data, cases, one, report);
            }
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
