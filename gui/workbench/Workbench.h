#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include <QObject>
#include <QPointer>
#include <QStringList>
#include <QUndoStack>

#include "gui/analysis/JobQueue.h"
#include "gui/analysis/ResultStore.h"
#include "gui/database/TargetDatabase.h"
#include "gui/workbench/EditSteps.h"
#include "gui/workbench/ModelStore.h"
#include "gui/workbench/OrbitCamera.h"
#include "gui/workbench/PaintedModels.h"
#include "gui/workbench/RecentFiles.h"
#include "smatcore/project/ModelFields.h"

namespace smat::gui {

/// What the window and its tests talk to: the project that is open, the jobs that run and
/// wait, and the results there are. Knows no widget.
class Workbench : public QObject {
    Q_OBJECT

  public:
    explicit Workbench(DoorMaker makeDoor = openRenderDoor, QObject* parent = nullptr,
                       std::shared_ptr<ModelStore> models = std::make_shared<ModelStore>());
    ~Workbench() override;

    /// Opens a `.smat` project, or a model with defaults as a project without a file. Forgets the
    /// steps to undo. `remarks` gets a sentence for each former name of a setting in the file (see
    /// loadProject). Throws irsg::InputError, and then everything is as it was.
    void open(const std::filesystem::path& file, std::vector<std::string>* remarks = nullptr);
    /// Takes a project that is not what its file holds: a recovered one, or a new one without a
    /// file.
    void adopt(const Project& project);
    bool hasProject() const { return project_.has_value(); }
    /// As it was edited, but with the settings that its file has; those in effect are settings().
    /// LogicError where nothing is open.
    const Project& project() const;
    /// Those of the project with what was changed in the window on top.
    const Settings& settings() const { return settings_; }
    /// The project with the settings in effect: what is saved.
    Project editedProject() const;
    /// Whether editedProject() is something else than its file has, or a model is painted otherwise
    /// than the file beside it says. Where there is no file, moving the camera alone is no change.
    bool isModified() const;
    /// The settings of a project that is begun and has no file: no change and no step.
    void beginWith(const Settings& settings);
    /// Writes the project to its file, or to another that becomes its file. Throws
    /// irsg::InputError, and then the files are as they were. LogicError where there is no file.
    void save();
    /// `withFiles`: with copies of all files that it needs beside it (collectedProject), which are
    /// its files from then on; steps before cannot be undone.
    void saveAs(const std::filesystem::path& file, bool withFiles = false);

    /// Change them as a step that can be undone; steps that change the same settings in quick
    /// succession, or while a step is held, are one. Throw irsg::InputError.
    void set(const std::string& key, const std::string& text);
    /// `step` is its name in the menu: "Change options".
    void set(const Settings& settings, const QString& step = {});
    /// Changes everything else of a project; its file and settings are not touched.
    void edit(const Project& project, const QString& step);
    /// Changes project and settings together, as a step; the file is not touched.
    void editWhole(const Project& edited, const QString& step);
    /// The models of the project, as steps: see SceneModels.h and ModelFields.h. Throw
    /// irsg::InputError, and then nothing changes.
    void addModel(const ProjectModel& model);
    void removeModel(std::size_t model);
    void renameModel(std::size_t model, const std::string& name);
    void makeTarget(std::size_t model);
    /// Changes of the same number in quick succession, or while a step is held, are one step.
    void setField(std::size_t model, const ModelField& field, const std::string& text);
    /// The same of several numbers at once: a drag.
    using FieldTexts = std::vector<std::pair<const ModelField*, std::string>>;
    void setFields(std::size_t model, const FieldTexts& texts, const QString& step);

    /// The model that is meant where one of them is: no step, and nothing of the project.
    std::size_t chosenModel() const { return chosen_; }
    void chooseModel(std::size_t model);
    /// Between the two, all changes of the same settings are one step, as long as a drag takes.
    void holdStep() { steps_.hold(); }
    void closeStep() { steps_.close(); }
    /// Every edit of this window: settings, project and signature database. Numbers that identify
    /// commands for merging begin with 0x100 for those of the workbench itself; others choose other
    /// ones.
    QUndoStack& undoStack() { return undoStack_; }

    /// The signature database of the chosen model, and the session in which it is edited.
    TargetDatabase& target() { return database_; }
    DatabaseSession& database() { return database_.session(); }
    /// See TargetDatabase::edited.
    SceneBuilder::DatabaseOverrides editedDatabases() const { return database_.edited(); }

    /// What is painted on the models, saved with the project.
    PaintedModels& painted() { return painted_; }

    /// The models of the project that is open; never null.
    const std::shared_ptr<ModelStore>& models() const { return models_; }

    OrbitCamera camera() const;
    void setCamera(const OrbitCamera& camera);

    /// Starts an analysis, or a Monte Carlo run, in the background; it waits in line where another
    /// one runs. Returns its number. An `asker` that is still there then shows the result itself.
    int start(AnalysisData data);
    int start(const MonteCarloData& asked, QObject* asker = nullptr);
    /// Time against error of a view, and ranges of detection: they come to a table of a tool.
    int start(const AnalysisData& view, const CostAccuracyStudy::Options& options,
              QObject* asker = nullptr);
    int start(const AnalysisData& view, const DetectionRequest& request, QObject* asker = nullptr);
    /// The same for the frames of a scenario, or a film of them, of which jobs().finished() tells.
    int start(SimulationJob order);
    int start(FilmOrder order);
    /// Whether a job runs or waits.
    bool isRunning() const { return jobs_.isBusy(); }
    JobQueue& jobs() { return jobs_; }
    /// The one that runs, or null.
    const AnalysisJob* job() const { return jobs_.running(); }
    /// The one that runs, answered within a moment; the next in line begins.
    void cancel() { jobs_.cancel(jobs_.runningNumber()); }

    ResultStore& resultStore() { return results_; }
    const ResultStore& resultStore() const { return results_; }
    const std::vector<ResultEntry>& results() const { return results_.entries(); }
    const ResultEntry* result(int id) const { return results_.find(id); }
    void removeResult(int id) { results_.remove(id); }
    /// Keeps the results with the project, beside its file. Throws irsg::InputError. LogicError
    /// where there is no file.
    void saveResults();

    QStringList recentFiles() const { return gui::recentFiles(); }

  signals:
    void projectOpened();
    /// Models, analyses or texts of the project were edited, or its file is another one.
    void projectChanged();
    /// Another model is meant.
    void modelChosen();
    /// isModified() may have another answer.
    void modifiedChanged();
    void settingsChanged();
    void jobStarted(const QString& title);
    void jobProgressed(const smat::Progress& progress);
    /// After every job, whatever came of it.
    void jobEnded();
    void resultAdded(int id);
    void jobFailed(const QStringList& sentences, bool ourFault);

  private:
    int start(JobOrder job, QObject* asker);
    void apply(const Project& edited);
    void take(const Project& project, const Project& saved);
    /// Lets go of models that the project no longer names.
    void keepModels();
    void followDatabase(bool anew);
    void chooseModelWith(const std::filesystem::path& database);
    /// Path of a model's database; empty where it has none.
    std::filesystem::path databaseFile(std::size_t model) const;
    void nameDatabase(const std::filesystem::path& file);

    std::optional<Project> project_;
    Settings settings_;
    Project saved_;
    std::size_t chosen_ = 0;
    QUndoStack undoStack_;
    EditSteps steps_;
    TargetDatabase database_;
    std::shared_ptr<ModelStore> models_;
    PaintedModels painted_;
    ResultStore results_;
    std::map<int, QPointer<QObject>> askers_; ///< of jobs, by number
    JobQueue jobs_;                           ///< last: its threads stop before the rest goes
};

} // namespace smat::gui
