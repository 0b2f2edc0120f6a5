#include "gui/project/RecoveryCopy.h"

#include <QDir>
#include <QStandardPaths>

#include "gui/Workbench.h"
#include "irsg/radiometry/Errors.h"
#include "smatcore/project/ProjectFile.h"
#include "smatcore/support/TextFile.h"

namespace smat::gui {
namespace {

QString lockOf(const std::filesystem::path& copy) {
    return QString::fromStdString(copy.string() + ".lock");
}

} // namespace

RecoveryCopy::RecoveryCopy(Workbench& workbench, int delay_s, QObject* parent)
    : QObject(parent), workbench_(workbench) {
    timer_.setSingleShot(true);
    setDelay(delay_s);
    connect(&timer_, &QTimer::timeout, this, &RecoveryCopy::write);
    connect(&workbench_, &Workbench::projectOpened, this, [this] {
        // The changes of the one before were saved or given up before this one was opened.
        forget();
        file_.reset();
        told_ = false;
    });
    connect(&workbench_, &Workbench::projectChanged, this, &RecoveryCopy::onProjectChanged);
    connect(&workbench_, &Workbench::modifiedChanged, this, &RecoveryCopy::onModifiedChanged);
}

RecoveryCopy::~RecoveryCopy() = default;

void RecoveryCopy::setDelay(int delay_s) {
    timer_.setInterval(delay_s * 1000);
}

void RecoveryCopy::onProjectChanged() {
    if (file_ && *file_ != workbench_.project().file)
        forget();
}

void RecoveryCopy::onModifiedChanged() {
    if (!workbench_.isModified())
        forget();
    else if (!timer_.isActive())
        timer_.start();
}

void RecoveryCopy::writeNow() {
    if (workbench_.isModified())
        write();
}

void RecoveryCopy::write() {
    if (!workbench_.isModified())
        return;
    const Project project = workbench_.editedProject();
    const auto copy = pathFor(project.file);
    try {
        std::filesystem::create_directories(copy.parent_path());
        if (!lock_) {
            auto lock = std::make_unique<QLockFile>(lockOf(copy));
            lock->setStaleLockTime(0);
            if (!lock->tryLock(0))
                throw irsg::InputError({copy.string(), "",
                                        "a recovery copy that another window keeps",
                                        "a project with unsaved changes in one window only"});
            lock_ = std::move(lock);
        }
        writeTextFile(copy, projectToJson(project, copy));
        file_ = project.file;
        written_ = true;
    } catch (const std::exception& problem) {
        if (!std::exchange(told_, true))
            emit failed(tr("No recovery copy is kept: %1").arg(problem.what()));
    }
}

void RecoveryCopy::forget() {
    timer_.stop();
    if (written_)
        remove(*file_);
    written_ = false;
    lock_.reset();
}

std::filesystem::path RecoveryCopy::pathFor(const std::filesystem::path& projectFile) {
    if (!projectFile.empty())
        return projectFile.string() + ".recovery";
    const QString folder = QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation);
    return std::filesystem::path(folder.toStdString()) / "smat" / "new-project.smat.recovery";
}

bool RecoveryCopy::isInUse(const std::filesystem::path& projectFile) {
    const auto copy = pathFor(projectFile);
    std::error_code none;
    if (!std::filesystem::is_regular_file(copy, none))
        return false;
    QLockFile lock(lockOf(copy));
    lock.setStaleLockTime(0);
    return !lock.tryLock(0) && lock.error() == QLockFile::LockFailedError;
}

bool RecoveryCopy::isLeftBehind(const std::filesystem::path& projectFile) {
    std::error_code none;
    return std::filesystem::is_regular_file(pathFor(projectFile), none) && !isInUse(projectFile);
}

Project RecoveryCopy::read(const std::filesystem::path& projectFile) {
    const auto copy = pathFor(projectFile);
    // Paths of a copy that lies beside its project are those of the project.
    Project project = loadProject(copy);
    if (projectFile.empty()) {
        for (auto& model : project.models) {
            model.file = project.resolve(model.file);
            if (!model.database.empty())
                model.database = project.resolve(model.database);
        }
    }
    project.file = projectFile;
    return project;
}

void RecoveryCopy::remove(const std::filesystem::path& projectFile) {
    std::error_code none;
    std::filesystem::remove(pathFor(projectFile), none);
}

} // namespace smat::gui
