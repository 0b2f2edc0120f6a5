#include "gui/analysis/JobQueue.h"

#include <algorithm>

namespace smat::gui {

JobQueue::JobQueue(DoorMaker makeDoor, SceneBuilder::ModelLoader models, QObject* parent)
    : QObject(parent),
      makeDoor_(std::move(makeDoor)),
      models_(std::move(models)),
      engine_(freshEngine()) {}

std::shared_ptr<JobRunner> JobQueue::freshEngine() const {
    return std::make_shared<JobRunner>(makeDoor_, models_);
}

JobQueue::~JobQueue() {
    // All are asked to stop before the first is waited for.
    if (job_) {
        job_->disconnect(this);
        job_->cancel();
    }
    for (const auto& job : leaving_)
        job->disconnect(this);
}

int JobQueue::add(JobOrder order, SceneBuilder::DatabaseOverrides databases) {
    Waiting next{++lastNumber_, std::move(order), std::move(databases)};
    const int number = next.number;
    if (job_) {
        waiting_.push_back(std::move(next));
        emit waitingChanged();
    } else {
        begin(std::move(next));
    }
    return number;
}

bool JobQueue::isWorking() const {
    return (job_ && job_->isWorking()) ||
           std::ranges::any_of(leaving_, [](const auto& job) { return job->isWorking(); });
}

bool JobQueue::holds(int number) const {
    return runningNumber() == number || std::ranges::any_of(waiting_, [number](const auto& one) {
               return one.number == number;
           });
}

void JobQueue::begin(Waiting next) {
    // A drawing that was left still has its renderer.
    const auto working = [this](const auto& job) {
        return job->isWorking() && job->engine() == engine_;
    };
    if (std::ranges::any_of(leaving_, working))
        engine_ = freshEngine();
    // No job works with this builder: nobody else uses it.
    engine_->scenes().setDatabaseOverrides(std::move(next.databases));
    const int number = number_ = next.number;
    job_ = std::make_unique<AnalysisJob>(std::move(next.order), engine_);
    auto* job = job_.get();
    connect(job, &AnalysisJob::progressed, this, [this, job, number](const Progress& progress) {
        if (job == job_.get())
            emit progressed(number, progress);
    });
    connect(job, &AnalysisJob::finished, this, [this, job, number](const JobResult& result) {
        if (job == job_.get())
            end();
        emit finished(number, result);
        beginNext();
    });
    connect(job, &AnalysisJob::failed, this,
            [this, job, number](const QStringList& sentences, bool ourFault) {
                const bool cancelled = job->isCancelled() && !ourFault;
                end();
                if (!cancelled)
                    emit failed(number, sentences, ourFault);
                beginNext();
            });
    connect(job, &AnalysisJob::ended, this, [this, job] { forget(job); });
    emit started(number, job->title());
    job->start();
}

void JobQueue::end() {
    leaving_.push_back(std::move(job_));
    emit ended(number_);
}

void JobQueue::beginNext() {
    if (job_ || waiting_.empty())
        return;
    Waiting next = std::move(waiting_.front());
    waiting_.pop_front();
    emit waitingChanged();
    begin(std::move(next));
}

void JobQueue::cancel(int number) {
    if (job_ && number == number_)
        job_->cancel();
    else if (std::erase_if(waiting_, [number](const auto& one) { return one.number == number; }))
        emit waitingChanged();
}

void JobQueue::cancelAll() {
    waiting_.clear();
    emit waitingChanged();
    if (job_)
        job_->cancel();
}

void JobQueue::forget(AnalysisJob* job) {
    // The renderer with its loaded models is better than one that nobody has used yet.
    if (!job_ && !engine_->hasDoor() && job->engine() != engine_)
        engine_ = job->engine();
    // Not while the job is still in its signal.
    QMetaObject::invokeMethod(
        this,
        [this, job] { std::erase_if(leaving_, [job](const auto& it) { return it.get() == job; }); },
        Qt::QueuedConnection);
}

} // namespace smat::gui

#include "moc_JobQueue.cpp"
