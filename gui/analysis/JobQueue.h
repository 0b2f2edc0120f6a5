#pragma once

#include <deque>
#include <memory>
#include <vector>

#include <QObject>

#include "gui/analysis/AnalysisJob.h"

namespace smat::gui {

/// The jobs that were asked for: one runs, the others wait in line and are begun in their order.
/// Knows no widget. Destroying it asks all to stop and waits for the drawing under way.
class JobQueue : public QObject {
    Q_OBJECT

  public:
    struct Waiting {
        int number = 0;
        JobOrder order;
        SceneBuilder::DatabaseOverrides databases; ///< as they were edited when it was asked for
    };

    /// Scenes have their models from `models`; without, each job reads them itself.
    explicit JobQueue(DoorMaker makeDoor, SceneBuilder::ModelLoader models = {},
                      QObject* parent = nullptr);
    ~JobQueue() override;

    /// Begins it at once where nothing runs. Returns its number, from 1.
    int add(JobOrder order, SceneBuilder::DatabaseOverrides databases);
    bool isBusy() const { return job_ != nullptr; }
    /// Whether any thread is at work, if only to end the drawing of a job that was cancelled.
    bool isWorking() const;
    /// Null while nothing runs.
    const AnalysisJob* running() const { return job_.get(); }
    /// Of the job that runs; 0 while nothing does.
    int runningNumber() const { return job_ ? number_ : 0; }
    const std::deque<Waiting>& waiting() const { return waiting_; }
    /// Whether a job runs or waits.
    bool holds(int number) const;

    /// Stops one, or takes it out of the line. Answered within a moment; a drawing under way ends
    /// by itself, and meanwhile the next job has a renderer of its own.
    void cancel(int number);
    void cancelAll();

  signals:
    void started(int number, const QString& title);
    void progressed(int number, const smat::Progress& progress);
    /// What came of it: one of the two, or neither where it was cancelled before anything was done.
    /// A Monte Carlo run that was cancelled while it drew may finish after it has ended.
    void finished(int number, const smat::gui::JobResult& result);
    void failed(int number, const QStringList& sentences, bool ourFault);
    /// It runs no longer.
    void ended(int number);
    void waitingChanged();

  private:
    std::shared_ptr<JobRunner> freshEngine() const;
    void begin(Waiting next);
    void end();
    void beginNext();
    void forget(AnalysisJob* job);

    DoorMaker makeDoor_;
    SceneBuilder::ModelLoader models_;
    std::shared_ptr<JobRunner> engine_;
    std::deque<Waiting> waiting_;
    int number_ = 0, lastNumber_ = 0;
    std::unique_ptr<AnalysisJob> job_;
    std::vector<std::unique_ptr<AnalysisJob>> leaving_; ///< answered, their drawing not yet ended
};

} // namespace smat::gui
