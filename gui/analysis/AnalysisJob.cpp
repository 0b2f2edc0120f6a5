#include "gui/analysis/AnalysisJob.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <QTimer>

#include "gui/widgets/Sentences.h"
#include "irsg/core/Errors.h"
#include "smatcore/analysis/AnalysisDefinition.h"
#include "smatcore/analysis/AnalysisProvenance.h"

namespace smat::gui {
namespace {

/// True where the rows of a table are the first of one that has grown from it: adaptive sweeps put
/// theirs between others.
bool growsAtItsEnd(const ResultTable& table, const ResultTable& grown) {
    const auto count = static_cast<std::ptrdiff_t>(table.rowCount());
    for (std::size_t i = 0; i < grown.columns().size(); ++i) {
        const auto &one = table.columns()[i].values, &other = grown.columns()[i].values;
        if (count > std::ssize(other) ||
            (count > 0 && one.back() != other[one.size() - 1] && !std::isnan(one.back())))
            return false;
    }
    return true;
}

/// Rows of a result that grows, without copying those that are there already.
void takeNewRows(ResultTable& table, const ResultTable& grown) {
    if (table.columns().size() != grown.columns().size() || !growsAtItsEnd(table, grown)) {
        table = grown;
        return;
    }
    for (std::size_t row = table.rowCount(); row < grown.rowCount(); ++row) {
        std::vector<double> values;
        for (const auto& column : grown.columns())
            values.push_back(column.values[row]);
        table.addRow(values, grown.warningOf(row));
    }
}

} // namespace

AnalysisJob::AnalysisJob(JobOrder order, std::shared_ptr<JobRunner> engine, QObject* parent)
    : QObject(parent), order_(std::move(order)), engine_(std::move(engine)) {
    qRegisterMetaType<smat::Progress>();
    qRegisterMetaType<smat::gui::JobResult>();
    kept_.data = order_.analysis;
}

QString AnalysisJob::titleOf(const JobOrder& order) {
    if (order.simulation)
        return tr("Scenario: %1")
            .arg(QString::fromStdString(order.simulation->scenario.displayName()));
    if (order.film)
        return tr("Film: %1").arg(QString::fromStdString(order.film->file.filename().string()));
    const AnalysisData& data = order.analysis;
    const bool unnamed = data.name.empty() || data.name == smat::name(data.kind);
    const QString what = QString::fromStdString(unnamed ? smat::title(data.kind) : data.name);
    return order.monteCarlo ? tr("Monte Carlo: %1").arg(what) : what;
}

AnalysisJob::~AnalysisJob() {
    thread_.request_stop();
    if (thread_.joinable())
        thread_.join();
}

void AnalysisJob::start() {
    clock_.start();
    working_ = true;
    thread_ = std::jthread([this](std::stop_token stop) { work(stop); });
}

void AnalysisJob::cancel() {
    if (cancelled_)
        return;
    cancelled_ = true;
    thread_.request_stop();
    QTimer::singleShot(patience_ms, this, [this] {
        if (!answered_)
            answer(keptSoFar());
    });
}

double AnalysisJob::elapsed_s() const {
    return clock_.isValid() ? static_cast<double>(clock_.elapsed()) / 1000.0 : 0.0;
}

void AnalysisJob::work(std::stop_token stop) {
    Outcome outcome;
    const CurrentStage::Listening listening(stage_);
    // A window cannot show more than some thirty states a second. The first and the last step are
    // always told: either may take its time, as the encoding of a film does.
    constexpr double leastPause_s = 0.03;
    double last_s = -1.0;
    const auto progress = [&](const Progress& now) {
        if (now.done == 0 || now.done + 1 >= now.total || now.elapsed_s - last_s > leastPause_s) {
            last_s = now.elapsed_s;
            emit progressed(now);
        }
    };
    try {
        outcome.result = order_.film           ? makeFilm(progress, stop)
                         : order_.simulation   ? simulate(progress, stop)
                         : order_.monteCarlo   ? sampleScales(progress, stop)
                         : order_.costAccuracy ? measureConfigurations(progress, stop)
                         : order_.detection    ? findRanges(progress, stop)
                                               : analyse(progress, stop);
    } catch (const irsg::InputError& error) {
        outcome.sentences << sentencesOf(error);
    } catch (const std::exception& error) {
        outcome.ourFault = true;
        outcome.sentences << QString::fromLocal8Bit(error.what());
    }
    if (outcome.sentences.isEmpty() && outcome.result.isEmpty())
        outcome.sentences << (stop.stop_requested()
                                  ? tr("Cancelled before the first case was done.")
                                  : tr("The analysis gave no result."));
    // Over to the thread of the window.
    QMetaObject::invokeMethod(
        this,
        [this, outcome = std::move(outcome)] {
            working_ = false;
            if (!answered_)
                answer(outcome);
            else if (outcome.result.monteCarlo || outcome.result.simulation ||
                     (isOfTool() && outcome.result.data))
                emit finished(outcome.result);
            emit ended();
        },
        Qt::QueuedConnection);
}

JobResult AnalysisJob::analyse(const ProgressCallback& progress, std::stop_token stop) {
    PlannedJob job;
    job.data = order_.analysis;
    job.plan = planAnalysis(job.data.kind, job.data.project, job.data.settings);
    AnalysisData& data = job.data;
    StageTimer timer;
    engine_->run(job, {.progress =
                           [&](const Progress& now) {
                               keep(data, now);
                               progress(now);
                           },
                       .stop = std::move(stop),
                       .timer = &timer,
                       .loaded =
                           [this](const SceneDescription& scene) {
                               const std::lock_guard lock(kept_.mutex);
                               kept_.scene = scene;
                           }});
    data.stages = timer.stages();
    if (data.image.empty() && data.table.empty())
        return {};
    return {std::make_shared<const AnalysisData>(std::move(data))};
}

JobResult AnalysisJob::simulate(const ProgressCallback& progress, std::stop_token stop) {
    JobResult result;
    result.simulation = std::make_shared<const SimulationFrames>(runSimulation(
        *order_.simulation, *engine_, {.progress = progress, .stop = std::move(stop)}));
    return result;
}

JobResult AnalysisJob::makeFilm(const ProgressCallback& progress,
                                const std::stop_token& stop) const {
    const FilmOrder& order = *order_.film;
    JobResult result;
    result.film = std::make_shared<const FilmOutcome>(
        FilmOutcome{filmFiles(order.file, order.strip),
                    writeFilm(order.strip, order.file, order.whose, stop, progress)});
    return result;
}

JobResult AnalysisJob::sampleScales(const ProgressCallback& progress, std::stop_token stop) {
    MonteCarloJob job;
    job.data.analysis = order_.analysis;
    job.data.options = *order_.monteCarlo;
    StageTimer timer;
    engine_->run(job, {.progress = progress, .stop = std::move(stop), .timer = &timer});
    const auto run = std::make_shared<MonteCarloData>(std::move(job.data));
    run->analysis.stages = timer.stages();
    if (run->realisations() == 0)
        return {};
    return {{run, &run->analysis}, run};
}

JobResult AnalysisJob::measureConfigurations(const ProgressCallback& progress,
                                             std::stop_token stop) {
    auto data = std::make_shared<AnalysisData>(order_.analysis);
    engine_->run(*data, *order_.costAccuracy, {.progress = progress, .stop = std::move(stop)});
    if (data->table.rowCount() == 0)
        return {};
    return {data};
}

JobResult AnalysisJob::findRanges(const ProgressCallback& progress, std::stop_token stop) {
    auto data = std::make_shared<AnalysisData>(order_.analysis);
    engine_->run(*data, *order_.detection, {.progress = progress, .stop = std::move(stop)});
    if (data->table.rowCount() == 0)
        return {};
    return {data};
}

void AnalysisJob::keep(const AnalysisData& data, const Progress& now) {
    const std::lock_guard lock(kept_.mutex);
    takeNewRows(kept_.data.table, data.table);
    kept_.data.providedBy = data.providedBy;
    kept_.data.warnings = data.warnings;
    kept_.data.renderer = data.renderer;
    kept_.progress = now;
}

AnalysisJob::Outcome AnalysisJob::keptSoFar() {
    const std::lock_guard lock(kept_.mutex);
    AnalysisData data = kept_.data;
    if (order_.simulation || order_.film || data.table.empty() ||
        data.kind->form == AnalysisForm::image)
        return {.result = {}, .sentences = {tr("Cancelled before the first case was done.")}};
    // What the run itself says of a stop between two cases.
    data.state = AnalysisState::partial;
    data.elapsed_s = elapsed_s();
    data.warnings.push_back("stopped after " + std::to_string(kept_.progress.done) + " of " +
                            std::to_string(kept_.progress.total) + " cases");
    summarise(data);
    writeProvenance(data, kept_.scene);
    return {.result = {std::make_shared<const AnalysisData>(std::move(data))}, .sentences = {}};
}

void AnalysisJob::answer(const Outcome& outcome) {
    answered_ = true;
    if (outcome.sentences.isEmpty())
        emit finished(outcome.result);
    else
        emit failed(outcome.sentences, outcome.ourFault);
}

} // namespace smat::gui

#include "moc_AnalysisJob.cpp"
