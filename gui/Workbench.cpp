#include "gui/Workbench.h"

#include <algorithm>

#include "gui/Memory.h"
#include "gui/Readable.h"
#include "gui/Sentences.h"
#include "irsg/radiometry/Errors.h"
#include "irsg/scene/model/OpenableFiles.h"
#include "irsg/signature/SignatureFile.h"
#include "smatcore/project/ProjectFile.h"
#include "smatcore/results/ResultFolder.h"
#include "smatcore/settings/SettingKeys.h"

namespace smat::gui {
namespace {

constexpr int keptFiles = 10;
constexpr int stepPause_ms = 1500; ///< after which the same setting begins a new step
constexpr int editCommandId = 0x100;

/// "Set range to 1200 m".
QString stepOf(const std::string& key, const std::string& value) {
    const SettingInfo& info = settingInfo(key);
    QString label = QString::fromStdString(info.label);
    if (label.size() < 2 || !label.at(1).isUpper())
        label.replace(0, 1, label.left(1).toLower());
    QString text = QString::fromStdString(value.empty() ? "nothing" : value);
    if (info.kind == SettingKind::boolean)
        return (value == "true" ? Workbench::tr("Switch %1 on") : Workbench::tr("Switch %1 off"))
            .arg(label);
    if (const QString unit = readableUnit(info.unit); !unit.isEmpty())
        text += (unit == "°" ? "" : " ") + unit;
    return Workbench::tr("Set %1 to %2").arg(label, text.size() > 40 ? text.left(39) + "…" : text);
}

std::vector<std::string> keysThatDiffer(const Settings& one, const Settings& other) {
    std::vector<std::string> keys;
    for (const auto& info : settingTable())
        if (one.text(info.key) != other.text(info.key))
            keys.push_back(info.key);
    return keys;
}

bool areOfCamera(const std::vector<std::string>& keys) {
    return std::all_of(keys.begin(), keys.end(),
                       [](const auto& key) { return key.starts_with("camera."); });
}

/// The name of a step between two states of the settings.
QString stepBetween(const Settings& before, const Settings& after) {
    const auto keys = keysThatDiffer(before, after);
    return keys.size() == 1    ? stepOf(keys.front(), after.text(keys.front()))
           : areOfCamera(keys) ? Workbench::tr("Move the camera")
                               : Workbench::tr("Change %1 settings").arg(keys.size());
}

/// The same project with its relative paths told from another file's folder.
Project movedTo(const Project& project, const std::filesystem::path& file) {
    if (project.file.parent_path() == file.parent_path() || project.file.empty()) {
        Project moved = project;
        moved.file = file;
        return moved;
    }
    return projectFromJson(projectToJson(project, file), file);
}

} // namespace

Workbench::Workbench(ImageSourceFactory makeSource, QObject* parent,
                     std::shared_ptr<ModelStore> models)
    : QObject(parent),
      database_(std::make_unique<DatabaseSession>(undoStack_)),
      models_(std::move(models)),
      jobs_(std::move(makeSource), ModelStore::loader(models_)) {
    connect(&jobs_, &JobQueue::started, this,
            [this](int, const QString& title) { emit jobStarted(title); });
    connect(&jobs_, &JobQueue::progressed, this,
            [this](int, const Progress& progress) { emit jobProgressed(progress); });
    connect(&jobs_, &JobQueue::ended, this, &Workbench::jobEnded);
    connect(&jobs_, &JobQueue::failed, this,
            [this](int, const QStringList& sentences, bool ourFault) {
                emit jobFailed(sentences, ourFault);
            });
    connect(&jobs_, &JobQueue::finished, this, [this](int number, const JobResult& result) {
        const auto asker = askers_.find(number);
        if (result.monteCarlo)
            results_.add(result.monteCarlo, asker != askers_.end() && !asker->second.isNull());
        else
            results_.add(result.data);
    });
    connect(&results_, &ResultStore::added, this, &Workbench::resultAdded);
    connect(&results_, &ResultStore::addedQuietly, this, &Workbench::resultAdded);
    connect(&results_, &ResultStore::removed, this, &Workbench::resultRemoved);
    connect(&results_, &ResultStore::unsavedChanged, this, &Workbench::modifiedChanged);
    stepEnd_.setSingleShot(true);
    stepEnd_.setInterval(stepPause_ms);
    connect(&stepEnd_, &QTimer::timeout, this, [this] { ++step_; });
}

Workbench::~Workbench() = default;

void Workbench::open(const std::filesystem::path& file) {
    if (!std::filesystem::is_regular_file(file))
        throw irsg::InputError({file.string(), "", "no such file", "a .smat project or a model"});
    // A model by its name alone: what is in it is read beside the window.
    if (const auto refusal = irsg::refusalOf(file.string(), irsg::FileKind::model);
        refusal && file.extension() != ".smat")
        throw irsg::InputError(
            {file.string(), "", *refusal,
             "a .smat project or " + irsg::expectationOf(irsg::FileKind::model)});
    const auto absolute = std::filesystem::absolute(file).lexically_normal();
    Project opened = file.extension() == ".smat" ? loadProject(absolute) : projectOfModel(absolute);
    take(opened, opened);
    rememberFile(absolute);
}

void Workbench::adopt(const Project& project) {
    Project saved;
    saved.file = project.file;
    try {
        if (!project.file.empty())
            saved = loadProject(project.file);
    } catch (const irsg::InputError&) {
        // The file is damaged or gone: nothing of the project is saved yet.
    }
    take(project, saved);
}

void Workbench::take(const Project& project, const Project& saved) {
    // What was opened before there was any project stays open beside it.
    if (project_)
        results_.clear();
    undoStack_.clear();
    saved_ = saved;
    project_ = project;
    settings_ = project.settings;
    project_->settings = saved_.settings;
    followDatabase(true);
    keepModels();
    results_.openProject(project.file, project.results);
    emit projectOpened();
    emit settingsChanged();
    emit modifiedChanged();
}

void Workbench::keepModels() {
    std::vector<ModelKey> keys;
    for (const ProjectModel& model : project_->models)
        keys.push_back(ModelKey::of(*project_, model));
    models_->keepOnly(keys);
}

const Project& Workbench::project() const {
    if (!project_)
        throw irsg::LogicError("no project is open");
    return *project_;
}

Project Workbench::editedProject() const {
    Project edited = project();
    edited.settings = settings_;
    return edited;
}

bool Workbench::isModified() const {
    if (!project_)
        return false;
    Project texts = *project_;
    texts.settings = saved_.settings;
    const auto keys = keysThatDiffer(settings_, saved_.settings);
    return texts != saved_ || std::any_of(keys.begin(), keys.end(), [&](const auto& key) {
               return !texts.file.empty() || !key.starts_with("camera.");
           });
}

void Workbench::useColorMap(const std::string& name) {
    if (settings_.text(key::displayColorMap) == name)
        return;
    settings_.set(key::displayColorMap, name);
    saved_.settings.set(key::displayColorMap, name);
    project_->settings = saved_.settings;
    emit settingsChanged();
}

void Workbench::save() {
    saveAs(project().file);
}

void Workbench::saveAs(const std::filesystem::path& file) {
    if (file.empty())
        throw irsg::LogicError("a project without a file is to be saved");
    const auto absolute = std::filesystem::absolute(file).lexically_normal();
    Project moved = movedTo(editedProject(), absolute);
    const bool named = !moved.results.empty() && absolute == project_->file;
    if (!named)
        moved.results = ResultFolder::usualName(absolute);
    if (!results_.holdsAny(absolute, moved.results))
        moved.results.clear();
    saveProject(moved, absolute);
    project_ = saved_ = moved;
    settings_ = moved.settings;
    followDatabase(false);
    ++step_;
    rememberFile(absolute);
    emit projectChanged();
    emit modifiedChanged();
}

/// Everything before and after; the same setting changed again becomes one with the last change.
class Workbench::EditCommand : public QUndoCommand {
  public:
    EditCommand(Workbench& workbench, Project before, Project after, std::string mergeKey)
        : workbench_(workbench),
          before_(std::move(before)),
          after_(std::move(after)),
          mergeKey_(std::move(mergeKey)),
          step_(workbench.step_) {}
    int id() const override { return editCommandId; }
    void undo() override {
        ++workbench_.step_;
        workbench_.apply(before_);
    }
    void redo() override { workbench_.apply(after_); }
    bool mergeWith(const QUndoCommand* command) override {
        const auto* later = dynamic_cast<const EditCommand*>(command);
        if (later == nullptr || later->step_ != step_ || later->mergeKey_ != mergeKey_)
            return false;
        after_ = later->after_;
        setText(stepBetween(before_.settings, after_.settings));
        setObsolete(before_ == after_);
        return true;
    }

  private:
    Workbench& workbench_;
    Project before_, after_;
    std::string mergeKey_;
    int step_;
};

void Workbench::push(const Project& after, const QString& step, const std::string& mergeKey) {
    auto command = std::make_unique<EditCommand>(*this, editedProject(), after, mergeKey);
    command->setText(step);
    undoStack_.push(command.release());
    if (!stepHeld_)
        stepEnd_.start();
}

void Workbench::apply(const Project& edited) {
    Project now = movedTo(edited, project_->file);
    const bool settingsDiffer = now.settings != settings_;
    settings_ = now.settings;
    now.settings = project_->settings;
    now.results = project_->results; // no step
    const bool projectDiffers = now != *project_;
    project_ = std::move(now);
    followDatabase(false);
    if (projectDiffers) {
        keepModels();
        emit projectChanged();
    }
    if (settingsDiffer)
        emit settingsChanged();
    emit modifiedChanged();
}

void Workbench::holdStep() {
    ++step_;
    stepHeld_ = true;
    stepEnd_.stop();
}

void Workbench::closeStep() {
    ++step_;
    stepHeld_ = false;
}

void Workbench::set(const std::string& key, const std::string& text) {
    Settings changed = settings();
    changed.set(key, text);
    set(changed);
}

void Workbench::set(const Settings& changed, const QString& step) {
    const auto keys = keysThatDiffer(settings_, changed);
    if (!project_ || keys.empty()) {
        // Set to the default or not set at all is no step of its own.
        if (settings_ != changed) {
            settings_ = changed;
            emit settingsChanged();
            emit modifiedChanged();
        }
        return;
    }
    const QString text = step.isEmpty() ? stepBetween(settings_, changed) : step;
    Project after = editedProject();
    after.settings = changed;
    if (!step.isEmpty())
        ++step_;
    push(after, text, stepHeld_ && areOfCamera(keys) ? "camera" : keys.front());
    if (!step.isEmpty())
        ++step_;
}

void Workbench::edit(const Project& project, const QString& step) {
    Project after = project;
    after.file = this->project().file;
    after.settings = settings_;
    if (after != editedProject()) {
        ++step_;
        push(after, step, "project");
        ++step_;
    }
}

std::filesystem::path Workbench::databaseFile() const {
    if (!project_ || project_->models.empty() || project_->models.front().database.empty())
        return {};
    return project_->resolve(project_->models.front().database);
}

void Workbench::followDatabase(bool anew) {
    const auto named = databaseFile();
    const auto file = named.empty() ? named : std::filesystem::absolute(named).lexically_normal();
    if (!anew && file == database_->file() && database_->isOpen())
        return;
    databaseProblem_.clear();
    changedOutside_ = false;
    if (file.empty()) {
        database_->close();
        return;
    }
    try {
        database_->open(file);
    } catch (const irsg::InputError& error) {
        databaseProblem_ << sentencesOf(error);
        try {
            changedOutside_ = !irsg::loadSignatureFile(file, irsg::OutsideChanges::accept,
                                                       irsg::LintErrors::accept)
                                   .changedOutside.empty();
        } catch (const irsg::InputError&) {
            changedOutside_ = false;
        }
        database_->close();
    }
}

void Workbench::acceptDatabaseChanges() {
    database_->open(databaseFile(), irsg::OutsideChanges::accept);
    databaseProblem_.clear();
    changedOutside_ = false;
}

void Workbench::nameDatabase(const std::filesystem::path& file) {
    Project after = editedProject();
    if (after.models.empty())
        throw irsg::LogicError("a database for a project without models");
    after.models.front().database = file;
    edit(after, tr("Use database %1").arg(QString::fromStdString(file.filename().string())));
}

void Workbench::useDatabase(const std::filesystem::path& file) {
    // Changes of another program are asked about and what is physically wrong is shown, once it is
    // that of the target; what cannot be read is refused before anything changes.
    irsg::loadSignatureFile(file, irsg::OutsideChanges::accept, irsg::LintErrors::accept);
    nameDatabase(std::filesystem::absolute(file).lexically_normal());
}

void Workbench::useNewDatabase(const std::filesystem::path& file, irsg::SignatureDatabase value) {
    const auto absolute = std::filesystem::absolute(file).lexically_normal();
    database_->create(absolute, std::move(value));
    databaseProblem_.clear();
    changedOutside_ = false;
    if (databaseFile() != absolute)
        nameDatabase(absolute);
}

void Workbench::saveDatabaseAs(const std::filesystem::path& file) {
    database_->saveAs(file);
    if (std::filesystem::absolute(databaseFile()).lexically_normal() != database_->file())
        nameDatabase(database_->file());
}

SceneBuilder::DatabaseOverrides Workbench::editedDatabases() const {
    if (!database_->isOpen() || !database_->isDirty())
        return {};
    return {{databaseFile(), database_->snapshot()}};
}

OrbitCamera Workbench::camera() const {
    const Settings& now = settings_;
    return {now[key::cameraAzimuth], now[key::cameraElevation], now[key::cameraRange]};
}

void Workbench::setCamera(const OrbitCamera& camera) {
    Settings changed = settings();
    // Rounded to what a form shows, so that view, form and file say the same.
    const auto rounded = [](double value) { return QString::number(value, 'f', 3).toStdString(); };
    changed.set(key::cameraAzimuth, rounded(camera.azimuth_deg));
    changed.set(key::cameraElevation, rounded(camera.elevation_deg));
    changed.set(key::cameraRange, rounded(camera.range_m));
    set(changed);
}

int Workbench::start(AnalysisData data) {
    return jobs_.add({std::move(data)}, editedDatabases());
}

int Workbench::start(const MonteCarloData& asked, QObject* asker) {
    const int number = jobs_.add({asked.analysis, asked.options}, editedDatabases());
    if (asker != nullptr)
        askers_[number] = asker;
    return number;
}

void Workbench::saveResults() {
    if (project().file.empty())
        throw irsg::LogicError("results are to be kept beside a project without a file");
    results_.saveWith(project().file, project().results);
}

QStringList Workbench::recentFiles() const {
    return memory().value("recentFiles").toStringList();
}

void Workbench::rememberFile(const std::filesystem::path& file) {
    QStringList files = recentFiles();
    const QString name = QString::fromStdString(file.string());
    files.removeAll(name);
    files.prepend(name);
    memory().setValue("recentFiles", QStringList(files.mid(0, keptFiles)));
}

} // namespace smat::gui
