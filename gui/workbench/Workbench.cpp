#include "gui/workbench/Workbench.h"

#include <algorithm>

#include "gui/widgets/NumberFormat.h"
#include "irsg/core/Errors.h"
#include "irsg/geometry/reading/OpenableFiles.h"
#include "smatcore/project/FileCollection.h"
#include "smatcore/project/ProjectFile.h"
#include "smatcore/project/SceneModels.h"
#include "smatcore/results/ResultFolder.h"
#include "smatcore/settings/SettingKeys.h"

namespace smat::gui {
namespace {

/// The same project with its relative paths told from another file's folder.
Project movedTo(const Project& project, const std::filesystem::path& file) {
    if (project.file.parent_path() == file.parent_path() || project.file.empty()) {
        Project moved = project;
        moved.file = file;
        return moved;
    }
    return projectFromJson(projectToJson(project, file), file);
}

/// The project at another place, its files copied beside it.
Project movedWithFiles(const Project& project, const std::filesystem::path& file) {
    FileCollection files(collectionFolder(file));
    const Project made = collectedProject(project, file, files);
    files.write();
    return projectFromJson(projectToJson(made, file), file);
}

} // namespace

Workbench::Workbench(DoorMaker makeDoor, QObject* parent, std::shared_ptr<ModelStore> models)
    : QObject(parent),
      steps_(undoStack_, [this](const Project& edited) { apply(edited); }),
      database_(undoStack_, [this](const auto& file) { nameDatabase(file); }),
      models_(std::move(models)),
      painted_(undoStack_, models_),
      jobs_(std::move(makeDoor), ModelStore::loader(models_)) {
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
        else if (result.data && (result.data->kind == CostAccuracyStudy::kind() ||
                                 result.data->kind == detectionKind()))
            results_.addTable(
                QString::fromStdString(title(result.data->kind)) +
                    (result.data->state == AnalysisState::partial ? tr(" (partial)") : QString()),
                result.data->table, asker != askers_.end() && !asker->second.isNull());
        else if (result.data)
            results_.add(result.data);
    });
    connect(&results_, &ResultStore::added, this, &Workbench::resultAdded);
    connect(&results_, &ResultStore::addedQuietly, this, &Workbench::resultAdded);
    connect(&results_, &ResultStore::unsavedChanged, this, &Workbench::modifiedChanged);
    connect(&painted_, &PaintedModels::stateChanged, this, &Workbench::modifiedChanged);
    connect(&database_.session(), &DatabaseSession::wanted, this, &Workbench::chooseModelWith);
}

Workbench::~Workbench() = default;

void Workbench::open(const std::filesystem::path& file, std::vector<std::string>* remarks) {
    if (!std::filesystem::is_regular_file(file))
        throw irsg::InputError({file.string(), "", "no such file", "a .smat project or a model"});
    // A model by its name alone: what is in it is read beside the window.
    if (const auto refusal = irsg::refusalOf(file.string(), irsg::FileKind::model);
        refusal && file.extension() != ".smat")
        throw irsg::InputError(
            {file.string(), "", *refusal,
             "a .smat project or " + irsg::expectationOf(irsg::FileKind::model)});
    const auto absolute = std::filesystem::absolute(file).lexically_normal();
    Project opened =
        file.extension() == ".smat" ? loadProject(absolute, remarks) : projectOfModel(absolute);
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
    painted_.clear();
    saved_ = saved;
    project_ = project;
    settings_ = project.settings;
    project_->settings = saved_.settings;
    chosen_ = 0;
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
    if (painted_.isDirty())
        return true;
    Project texts = *project_;
    texts.settings = saved_.settings;
    const auto keys = keysThatDiffer(settings_, saved_.settings);
    return texts != saved_ || std::any_of(keys.begin(), keys.end(), [&](const auto& key) {
               return !texts.file.empty() || !key.starts_with("camera.");
           });
}

void Workbench::beginWith(const Settings& settings) {
    if (!project().file.empty())
        throw irsg::LogicError("a project with a file begins with its own settings");
    if (settings_ == settings)
        return;
    settings_ = settings;
    saved_.settings = settings;
    project_->settings = settings;
    emit settingsChanged();
}

void Workbench::save() {
    saveAs(project().file);
}

void Workbench::saveAs(const std::filesystem::path& file, bool withFiles) {
    if (file.empty())
        throw irsg::LogicError("a project without a file is to be saved");
    const auto absolute = std::filesystem::absolute(file).lexically_normal();
    Project moved =
        withFiles ? movedWithFiles(editedProject(), absolute) : movedTo(editedProject(), absolute);
    const bool named = !moved.results.empty() && absolute == project_->file;
    if (!named)
        moved.results = ResultFolder::usualName(absolute);
    if (!results_.holdsAny(absolute, moved.results))
        moved.results.clear();
    saveProject(moved, absolute);
    project_ = saved_ = moved;
    settings_ = moved.settings;
    followDatabase(false);
    if (withFiles) {
        undoStack_.clear();
        keepModels();
    }
    steps_.separate();
    rememberFile(absolute);
    emit projectChanged();
    emit modifiedChanged();
}

void Workbench::apply(const Project& edited) {
    Project now = movedTo(edited, project_->file);
    const bool settingsDiffer = now.settings != settings_;
    settings_ = now.settings;
    now.settings = project_->settings;
    now.results = project_->results; // no step
    const bool projectDiffers = now != *project_;
    project_ = std::move(now);
    const bool isGone = chosen_ >= project_->models.size();
    if (isGone)
        chosen_ = 0;
    followDatabase(false);
    if (projectDiffers) {
        keepModels();
        emit projectChanged();
    }
    if (settingsDiffer)
        emit settingsChanged();
    if (isGone)
        emit modelChosen();
    emit modifiedChanged();
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
    const std::string kind = steps_.isHeld() && areOfCamera(keys) ? "camera" : keys.front();
    if (step.isEmpty())
        steps_.push(editedProject(), after, text, kind);
    else
        steps_.pushAlone(editedProject(), after, text, kind);
}

void Workbench::edit(const Project& project, const QString& step) {
    Project after = project;
    after.file = this->project().file;
    after.settings = settings_;
    if (const Project before = editedProject(); after != before)
        steps_.pushAlone(before, after, step, "project");
}

void Workbench::editWhole(const Project& edited, const QString& step) {
    Project after = edited;
    after.file = project().file;
    if (const Project before = editedProject(); after != before)
        steps_.pushAlone(before, after, step, "models");
}

void Workbench::addModel(const ProjectModel& model) {
    Project after = editedProject();
    after.models.push_back(model);
    after.models.back().name = freeModelName(project(), model.shownName());
    editWhole(after, tr("Add model %1").arg(textOf(after.models.back().shownName())));
    chooseModel(after.models.size() - 1);
}

void Workbench::removeModel(std::size_t model) {
    Project after = editedProject();
    const QString name = textOf(after.models.at(model).shownName());
    smat::removeModel(after, model);
    chooseModel(0);
    editWhole(after, tr("Remove model %1").arg(name));
}

void Workbench::renameModel(std::size_t model, const std::string& name) {
    Project after = project();
    ProjectModel& one = after.models.at(model);
    const QString before = textOf(one.shownName());
    one.name = name;
    edit(after, tr("Rename %1 to %2").arg(before, textOf(one.shownName())));
}

void Workbench::makeTarget(std::size_t model) {
    Project after = editedProject();
    const QString name = textOf(after.models.at(model).shownName());
    smat::makeTarget(after, model);
    editWhole(after, tr("Make %1 the target").arg(name));
    chooseModel(0);
}

void Workbench::setField(std::size_t model, const ModelField& field, const std::string& text) {
    const Project before = editedProject();
    Project after = before;
    smat::setField(after, model, field, text, field.info.label);
    if (after.settings != before.settings) {
        set(after.settings);
        return;
    }
    if (after == before)
        return;
    const QString unit = formattedUnit(field.info.unit);
    const QString value = textOf(smat::textOf(after, model, field)) +
                          (unit.isEmpty() || unit == "°" ? unit : " " + unit);
    steps_.push(before, after,
                tr("Set %1 of %2 to %3")
                    .arg(textOf(field.info.label).toLower(),
                         textOf(after.models.at(model).shownName()), value),
                "models." + std::to_string(model) + "." + field.key);
}

void Workbench::setFields(std::size_t model, const FieldTexts& texts, const QString& step) {
    const Project before = editedProject();
    Project after = before;
    for (const auto& [field, text] : texts)
        smat::setField(after, model, *field, text, field->info.label);
    if (after != before)
        steps_.push(before, after, step, "models." + std::to_string(model));
}

void Workbench::chooseModel(std::size_t model) {
    if (!project_ || model >= project_->models.size() || model == chosen_)
        return;
    chosen_ = model;
    followDatabase(false);
    emit modelChosen();
}

void Workbench::chooseModelWith(const std::filesystem::path& database) {
    for (std::size_t i = 0; project_ && i < project_->models.size(); ++i)
        if (std::filesystem::absolute(databaseFile(i)).lexically_normal() == database)
            return chooseModel(i);
}

std::filesystem::path Workbench::databaseFile(std::size_t model) const {
    if (!project_ || model >= project_->models.size() || project_->models[model].database.empty())
        return {};
    return project_->resolve(project_->models[model].database);
}

void Workbench::followDatabase(bool anew) {
    std::vector<std::filesystem::path> ofAll;
    for (std::size_t i = 0; i < project_->models.size(); ++i)
        if (const auto file = databaseFile(i); !file.empty())
            ofAll.push_back(file);
    database_.follow(databaseFile(chosen_), ofAll, anew);
}

void Workbench::nameDatabase(const std::filesystem::path& file) {
    Project after = editedProject();
    if (after.models.empty())
        throw irsg::LogicError("a database for a project without models");
    after.models.at(chosen_).database = file;
    edit(after, tr("Use database %1").arg(QString::fromStdString(file.filename().string())));
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
    return jobs_.add({std::move(data)}, database_.edited());
}

int Workbench::start(JobOrder job, QObject* asker) {
    const int number = jobs_.add(std::move(job), database_.edited());
    if (asker != nullptr)
        askers_[number] = asker;
    return number;
}

int Workbench::start(const MonteCarloData& asked, QObject* asker) {
    return start(JobOrder{asked.analysis, asked.options}, asker);
}

int Workbench::start(const AnalysisData& view, const DetectionRequest& request, QObject* asker) {
    JobOrder job{view};
    job.detection = request;
    return start(std::move(job), asker);
}

int Workbench::start(const AnalysisData& view, const CostAccuracyStudy::Options& options,
                     QObject* asker) {
    JobOrder job{view};
    job.costAccuracy = options;
    return start(std::move(job), asker);
}

int Workbench::start(SimulationJob order) {
    // Frames are those that a terminal gives: of databases as they are saved.
    JobOrder job;
    job.simulation = std::make_shared<const SimulationJob>(std::move(order));
    return jobs_.add(std::move(job), {});
}

int Workbench::start(FilmOrder order) {
    JobOrder job;
    job.film = std::make_shared<const FilmOrder>(std::move(order));
    return jobs_.add(std::move(job), {});
}

void Workbench::saveResults() {
    if (project().file.empty())
        throw irsg::LogicError("results are to be kept beside a project without a file");
    results_.saveWith(project().file, project().results);
}

} // namespace smat::gui

#include "moc_Workbench.cpp"
