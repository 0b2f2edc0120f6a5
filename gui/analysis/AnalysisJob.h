#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include <QElapsedTimer>
#include <QObject>
#include <QStringList>

#include "gui/scenario/SimulationFrames.h"
#include "smatcore/jobs/AnalysisJobs.h"
#include "smatcore/support/CurrentStage.h"

namespace smat::gui {

/// What is asked of a job: an analysis and, with options, its Monte Carlo run, time against error
/// of its view, or ranges of detection; the frames of a scenario, or a film of them.
struct JobOrder {
    AnalysisData analysis;
    std::optional<MonteCarloOptions> monteCarlo = {};
    std::optional<CostAccuracyStudy::Options> costAccuracy = {};
    std::optional<DetectionRequest> detection = {};
    std::shared_ptr<const SimulationJob> simulation = {};
    std::shared_ptr<const FilmOrder> film = {};
};

/// What came of one: `simulation`, `film`, or `data`, which `monteCarlo` holds where it was such a
/// run.
struct JobResult {
    std::shared_ptr<const AnalysisData> data = {};
    std::shared_ptr<const MonteCarloData> monteCarlo = {};
    std::shared_ptr<const SimulationFrames> simulation = {};
    std::shared_ptr<const FilmOutcome> film = {};
    bool isEmpty() const { return !data && !simulation && !film; }
};

/// One run of a JobRunner in a thread of its own, which jobs use one after the other. Its signals
/// arrive in the
/// thread that made it. A cancel is answered within a moment: by the run itself where a case ends
/// in that time, else by the cases done so far, and the drawing under way is left to end by itself;
/// its engine is then not free before `ended`. What a Monte Carlo run, a scenario or time against
/// error had until then comes with another `finished`, after its answer. Destroying a job asks it
/// to stop and waits for the drawing under way.
class AnalysisJob : public QObject {
    Q_OBJECT

  public:
    /// How long a cancel waits for the drawing under way, ms.
    static constexpr int patience_ms = 100;

    AnalysisJob(JobOrder order, std::shared_ptr<JobRunner> engine, QObject* parent = nullptr);
    ~AnalysisJob() override;

    void start();
    /// What is done so far is kept.
    void cancel();
    bool isCancelled() const { return cancelled_; }
    /// Until the engine is free again.
    bool isWorking() const { return working_; }
    double elapsed_s() const;
    /// What the renderer is doing, with its share: "inter-reflection: pairs, 43 %"; empty between
    /// stages.
    QString stage() const { return QString::fromStdString(stage_.text()); }
    /// "Polar plot", or what the analysis is called.
    QString title() const { return titleOf(order_); }
    static QString titleOf(const JobOrder& order);
    const std::shared_ptr<JobRunner>& engine() const { return engine_; }

  signals:
    void progressed(const smat::Progress& progress);
    /// The answer, one of these two: complete, or partial after a cancel with at least one case
    /// done.
    void finished(const smat::gui::JobResult& result);
    /// Nothing came out: refused (a sentence a diagnostic), failed, or cancelled before the first
    /// case.
    void failed(const QStringList& sentences, bool ourFault);
    /// The last signal: the engine is free again.
    void ended();

  private:
    struct Outcome {
        JobResult result;
        QStringList sentences;
        bool ourFault = false;
    };
    /// What is done so far, shared with the thread that works.
    struct Kept {
        std::mutex mutex;
        AnalysisData data;
        SceneDescription scene;
        Progress progress;
    };
    void work(std::stop_token stop);
    JobResult analyse(const ProgressCallback& progress, std::stop_token stop);
    JobResult simulate(const ProgressCallback& progress, std::stop_token stop);
    JobResult makeFilm(const ProgressCallback& progress, const std::stop_token& stop) const;
    JobResult measureConfigurations(const ProgressCallback& progress, std::stop_token stop);
    JobResult findRanges(const ProgressCallback& progress, std::stop_token stop);
    bool isOfTool() const { return order_.costAccuracy || order_.detection; }
    JobResult sampleScales(const ProgressCallback& progress, std::stop_token stop);
    void keep(const AnalysisData& data, const Progress& now);
    Outcome keptSoFar();
    void answer(const Outcome& outcome);

    JobOrder order_;
    std::shared_ptr<JobRunner> engine_;
    Kept kept_;
    CurrentStage stage_;
    QElapsedTimer clock_;
    bool cancelled_ = false, answered_ = false, working_ = false;
    std::jthread thread_; ///< last: stops before the rest goes
};

} // namespace smat::gui
