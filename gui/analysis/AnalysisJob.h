#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include <QElapsedTimer>
#include <QObject>

#include "smatcore/analysis/AnalysisData.h"
#include "smatcore/analysis/AnalysisGenerator.h"
#include "smatcore/project/SceneBuilder.h"

namespace smat::gui {

/// Makes the renderer of the jobs: the infrared scene generator, or a test's own.
using ImageSourceFactory = std::function<std::unique_ptr<ImageSource>()>;

/// What jobs share: one renderer and the models it has loaded, used by one job at a time.
struct AnalysisEngine {
    ImageSourceFactory makeSource;
    std::unique_ptr<ImageSource> source; ///< made by the first job, in its thread
    SceneBuilder scenes;
};

/// One run of AnalysisGenerator in a thread of its own. Its signals arrive in the thread that made
/// it. Destroying it asks it to stop and waits for the drawing under way.
class AnalysisJob : public QObject {
    Q_OBJECT

  public:
    AnalysisJob(AnalysisData data, std::shared_ptr<AnalysisEngine> engine,
                QObject* parent = nullptr);
    ~AnalysisJob() override;

    void start();
    /// What is done so far is kept; the drawing under way is finished first.
    void cancel();
    bool isCancelled() const { return cancelled_; }
    double elapsed_s() const;
    const AnalysisData& asked() const { return asked_; }

  signals:
    void progressed(const smat::Progress& progress);
    /// Complete, or partial after a cancel with at least one case done.
    void finished(const smat::AnalysisData& data);
    /// Nothing came out: refused (a sentence an offence), failed, or cancelled before the first
    /// case.
    void failed(const QStringList& sentences, bool ourFault);

  private:
    void work(std::stop_token stop);

    AnalysisData asked_;
    std::shared_ptr<AnalysisEngine> engine_;
    QElapsedTimer clock_;
    bool cancelled_ = false;
    std::jthread thread_; ///< last: stops before the rest goes
};

} // namespace smat::gui
