#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include <QObject>
#include <QStringList>

#include "gui/analysis/AnalysisJob.h"
#include "gui/view/OrbitCamera.h"

namespace smat::gui {

/// A result of this session.
struct ResultEntry {
    int id = 0;
    QString title; ///< "1  Polar plot"
    AnalysisData data;
};

/// What the window and its tests talk to: the project that is open, the job that runs and the
/// results there are. Knows no widget.
class Workbench : public QObject {
    Q_OBJECT

  public:
    explicit Workbench(ImageSourceFactory makeSource = makeIrsgImageSource,
                       QObject* parent = nullptr);
    ~Workbench() override;

    /// Opens a `.smat` project, or a model with defaults. Throws irsg::InputError, and then
    /// everything is as it was.
    void open(const std::filesystem::path& file);
    bool hasProject() const { return project_.has_value(); }
    /// As its file has it. LogicError where nothing is open.
    const Project& project() const;
    /// Those of the project with what was changed in the window on top.
    const Settings& settings() const { return settings_; }
    /// Changes them in memory. Throws irsg::InputError.
    void set(const std::string& key, const std::string& text);
    void set(const Settings& settings);

    OrbitCamera camera() const;
    void setCamera(const OrbitCamera& camera);

    /// Starts an analysis in the background. LogicError while another one runs.
    void start(AnalysisData data);
    bool isRunning() const { return job_ != nullptr; }
    const AnalysisJob* job() const { return job_.get(); }
    void cancel();

    const std::vector<ResultEntry>& results() const { return results_; }
    const ResultEntry* result(int id) const;
    void removeResult(int id);

    /// Files opened before, the last one first, at most ten.
    QStringList recentFiles() const;

  signals:
    void projectOpened();
    void settingsChanged();
    void jobStarted(const QString& title);
    void jobProgressed(const smat::Progress& progress);
    /// After every job, whatever came of it.
    void jobEnded();
    void resultAdded(int id);
    void resultRemoved(int id);
    void jobFailed(const QStringList& sentences, bool ourFault);

  private:
    void onFinished(const AnalysisData& data);
    void endJob();
    void rememberFile(const std::filesystem::path& file);

    std::optional<Project> project_;
    Settings settings_;
    std::shared_ptr<AnalysisEngine> engine_;
    std::unique_ptr<AnalysisJob> job_;
    std::vector<ResultEntry> results_;
    int nextId_ = 1;
};

} // namespace smat::gui
