#include "gui/workbench/UnsavedNote.h"

#include <QCoreApplication>
#include <QStringList>

#include "gui/workbench/Workbench.h"
#include "irsg/core/Errors.h"
#include "smatcore/project/ProjectFile.h"

namespace smat::gui {

namespace {

/// Whether the file of a project says the same as the project.
bool isSaved(const Project& project) {
    try {
        return !project.file.empty() && loadProject(project.file) == project;
    } catch (const irsg::InputError&) {
        return false;
    }
}

} // namespace

QString unsavedNote(const Workbench& workbench) {
    if (!workbench.hasProject())
        return {};
    QStringList files;
    if (!isSaved(workbench.project()))
        files << QString::fromStdString(workbench.project().displayName());
    for (const auto& [file, database] : workbench.editedDatabases())
        files << QString::fromStdString(file.filename().string());
    return files.isEmpty()
               ? QString()
               : QCoreApplication::translate("UnsavedNote",
                                             "Not saved yet: %1. The command reads the files; "
                                             "unsaved edits are not included.")
                     .arg(files.join(", "));
}

} // namespace smat::gui
