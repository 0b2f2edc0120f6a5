#include "gui/Workbench.h"

#include <algorithm>

#include <QSettings>

#include "irsg/radiometry/Errors.h"
#include "smatcore/project/ProjectFile.h"

namespace smat::gui {
namespace {

QSettings memory() {
    return QSettings(QSettings::IniFormat, QSettings::UserScope, "smat", "workbench");
}
constexpr int keptFiles = 10;

} // namespace

Workbench::Workbench(ImageSourceFactory makeSource, QObject* parent)
    : QObject(parent), engine_(std::make_shared<AnalysisEngine>()) {
    engine_->makeSource = std::move(makeSource);
}

Workbench::~Workbench() {
    if (job_)
        job_->disconnect(this);
}

void Workbench::open(const std::filesystem::path& file) {
    if (!std::filesystem::is_regular_file(file))
        throw irsg::InputError({file.string(), "", "no such file", "a .smat project or a model"});
    const auto absolute = std::filesystem::absolute(file).lexically_normal();
    Project opened = file.extension() == ".smat" ? loadProject(absolute) : projectOfModel(absolute);
    project_ = std::move(opened);
    settings_ = project_->settings;
    rememberFile(absolute);
    emit projectOpened();
    emit settingsChanged();
}

const Project& Workbench::project() const {
    if (!project_)
        throw irsg::LogicError("no project is open");
    return *project_;
}

void Workbench::set(const std::string& key, const std::string& text) {
    Settings changed = settings();
    changed.set(key, text);
    set(changed);
}

void Workbench::set(const Settings& changed) {
    if (changed == settings())
        return;
    settings_ = changed;
    emit settingsChanged();
}

OrbitCamera Workbench::camera() const {
    const Settings& now = settings_;
    return {now.real("camera.azimuth"), now.real("camera.elevation"), now.real("camera.range")};
}

void Workbench::setCamera(const OrbitCamera& camera) {
    Settings changed = settings();
    // Rounded to what a form shows, so that view, form and file say the same.
    const auto rounded = [](double value) { return QString::number(value, 'f', 3).toStdString(); };
    changed.set("camera.azimuth", rounded(camera.azimuth_deg));
    changed.set("camera.elevation", rounded(camera.elevation_deg));
    changed.set("camera.range", rounded(camera.range_m));
    set(changed);
}

void Workbench::start(AnalysisData data) {
    if (job_)
        throw irsg::LogicError("an analysis is running");
    job_ = std::make_unique<AnalysisJob>(std::move(data), engine_);
    connect(job_.get(), &AnalysisJob::progressed, this, &Workbench::jobProgressed);
    connect(job_.get(), &AnalysisJob::finished, this, &Workbench::onFinished);
    connect(job_.get(), &AnalysisJob::failed, this,
            [this](const QStringList& sentences, bool ourFault) {
                const bool cancelled = job_->isCancelled() && !ourFault;
                endJob();
                if (!cancelled)
                    emit jobFailed(sentences, ourFault);
            });
    emit jobStarted(QString::fromStdString(title(job_->asked().kind)));
    job_->start();
}

void Workbench::cancel() {
    if (job_)
        job_->cancel();
}

void Workbench::onFinished(const AnalysisData& data) {
    const int id = nextId_++;
    QString what = QString::fromStdString(
        data.name.empty() || data.name == name(data.kind) ? title(data.kind) : data.name);
    if (data.state == AnalysisState::partial)
        what += tr(" (partial)");
    results_.push_back({id, QStringLiteral("%1  %2").arg(id).arg(what), data});
    endJob();
    emit resultAdded(id);
}

void Workbench::endJob() {
    job_.reset();
    emit jobEnded();
}

const ResultEntry* Workbench::result(int id) const {
    const auto found = std::find_if(results_.begin(), results_.end(),
                                    [id](const ResultEntry& entry) { return entry.id == id; });
    return found == results_.end() ? nullptr : &*found;
}

void Workbench::removeResult(int id) {
    if (std::erase_if(results_, [id](const ResultEntry& entry) { return entry.id == id; }) > 0)
        emit resultRemoved(id);
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
