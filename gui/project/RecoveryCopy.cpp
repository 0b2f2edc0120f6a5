#include "gui/project/RecoveryCopy.h"

#include <algorithm>

#include <QFileInfo>
#include <QRegularExpression>
#include <QStandardPaths>

#include "gui/Workbench.h"
#include "gui/start/DataFolder.h"
#include "gui/widgets/Readable.h"
#include "gui/widgets/Sentences.h"
#include "irsg/radiometry/Errors.h"
#include "smatcore/project/ProjectFile.h"
#include "smatcore/support/TextFile.h"

namespace smat::gui {
namespace {

/// More copies of one project than anybody leaves behind.
constexpr int mostCopies = 999;

std::unique_ptr<QLockFile> lockOf(const std::filesystem::path& copy) {
    auto lock = std::make_unique<QLockFile>(textOf(copy) + ".lock");
    lock->setStaleLockTime(0); // only that of a process that is gone
    return lock;
}

bool isKept(const std::filesystem::path& copy) {
    const auto lock = lockOf(copy);
    return !lock->tryLock(0) && lock->error() == QLockFile::LockFailedError;
}

bool lies(const std::filesystem::path& file) {
    std::error_code none;
    return std::filesystem::exists(std::filesystem::symlink_status(file, none));
}

/// Every copy of a project there is, whoever wrote it, the newest first.
std::vector<std::filesystem::path> copiesOf(const std::filesystem::path& projectFile) {
    const auto first = RecoveryCopy::pathFor(projectFile);
    const QRegularExpression isOne(QRegularExpression::anchoredPattern(
        QRegularExpression::escape(textOf(first.stem())) + R"((\.\d{1,3})?\.recovery)"));
    std::vector<std::filesystem::path> copies;
    std::error_code none;
    for (const auto& entry : std::filesystem::directory_iterator(first.parent_path(), none))
        if (entry.is_regular_file(none) && isOne.match(textOf(entry.path().filename())).hasMatch())
            copies.push_back(entry.path());
    std::ranges::sort(copies, std::greater{}, [](const std::filesystem::path& copy) {
        return QFileInfo(textOf(copy)).lastModified();
    });
    return copies;
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
    try {
        if (!lock_)
            claim(project.file);
        writeTextFile(copy_, projectToJson(project, copy_));
        file_ = project.file;
        written_ = true;
    } catch (const std::exception&) {
        if (!std::exchange(told_, true))
            emit failed(tr("No recovery copy is kept: %1")
                            .arg(sentencesOf(std::current_exception()).join(' ')));
    }
}

void RecoveryCopy::claim(const std::filesystem::path& projectFile) {
    std::filesystem::create_directories(pathFor(projectFile).parent_path());
    for (int number = 1; number <= mostCopies; ++number) {
        const auto copy = pathFor(projectFile, number);
        if (lies(copy))
            continue;
        auto lock = lockOf(copy);
        if (!lock->tryLock(0)) {
            if (lock->error() == QLockFile::LockFailedError)
                continue;
            throw irsg::InputError({copy.string(), "", "a file that cannot be written",
                                    "a folder that can be written to"});
        }
        // Somebody else may have written it and gone since it was looked for.
        if (lies(copy))
            continue;
        copy_ = copy;
        lock_ = std::move(lock);
        return;
    }
    throw irsg::InputError({pathFor(projectFile).string(), "",
                            std::to_string(mostCopies) + " recovery copies that were left behind",
                            "a place for one more"});
}

void RecoveryCopy::takeOver(const std::filesystem::path& copy) {
    auto lock = lockOf(copy);
    if (!lock->tryLock(0))
        return;
    copy_ = copy;
    lock_ = std::move(lock);
    file_ = workbench_.project().file;
    written_ = true;
}

void RecoveryCopy::forget() {
    timer_.stop();
    if (written_)
        remove(copy_);
    written_ = false;
    lock_.reset();
}

std::filesystem::path RecoveryCopy::pathFor(const std::filesystem::path& projectFile, int number) {
    const std::string suffix =
        (number > 1 ? "." + std::to_string(number) : std::string()) + ".recovery";
    if (!projectFile.empty())
        return placeForUnsaved(projectFile).string() + suffix;
    const QString folder = QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation);
    return std::filesystem::path(folder.toStdString()) / "smat" / ("new-project.smat" + suffix);
}

bool RecoveryCopy::isInUse(const std::filesystem::path& projectFile) {
    return std::ranges::any_of(copiesOf(projectFile), isKept);
}

std::vector<std::filesystem::path>
RecoveryCopy::leftBehind(const std::filesystem::path& projectFile) {
    auto copies = copiesOf(projectFile);
    std::erase_if(copies, isKept);
    return copies;
}

Project RecoveryCopy::read(const std::filesystem::path& copy,
                           const std::filesystem::path& projectFile) {
    // Paths of a copy that lies beside its project are those of the project.
    Project project = loadProject(copy);
    if (!projectFile.empty() && copy.parent_path() != projectFile.parent_path())
        return projectFromJson(projectToJson(project, projectFile), projectFile);
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

void RecoveryCopy::remove(const std::filesystem::path& copy) {
    std::error_code none;
    std::filesystem::remove(copy, none);
}

} // namespace smat::gui
