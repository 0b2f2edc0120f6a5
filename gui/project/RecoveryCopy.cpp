#include "gui/project/RecoveryCopy.h"

#include "gui/start/DataFolder.h"
#include "gui/widgets/Sentences.h"
#include "gui/workbench/Workbench.h"
#include "smatcore/project/ProjectFile.h"
#include "smatcore/support/TextFile.h"

namespace smat::gui {
namespace {

/// What its copies lie beside.
std::filesystem::path baseOf(const std::filesystem::path& projectFile) {
    return placeForUnsaved(projectFile, "new-project.smat");
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
        const auto& copy = slot_.claim(baseOf(project.file));
        writeTextFile(copy, projectToJson(project, copy));
        slot_.setWritten();
        file_ = project.file;
    } catch (const std::exception&) {
        if (!std::exchange(told_, true))
            emit failed(tr("No recovery copy is kept: %1")
                            .arg(sentencesOf(std::current_exception()).join(' ')));
    }
}

void RecoveryCopy::takeOver(const std::filesystem::path& copy) {
    if (slot_.takeOver(copy))
        file_ = workbench_.project().file;
}

void RecoveryCopy::forget() {
    timer_.stop();
    slot_.forget();
}

std::filesystem::path RecoveryCopy::pathFor(const std::filesystem::path& projectFile, int number) {
    return RecoverySlot::placeOf(baseOf(projectFile), number);
}

bool RecoveryCopy::isInUse(const std::filesystem::path& projectFile) {
    return RecoverySlot::isInUse(baseOf(projectFile));
}

std::vector<std::filesystem::path>
RecoveryCopy::leftBehind(const std::filesystem::path& projectFile) {
    return RecoverySlot::leftBehind(baseOf(projectFile));
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

} // namespace smat::gui

#include "moc_RecoveryCopy.cpp"
