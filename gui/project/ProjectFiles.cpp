#include "gui/project/ProjectFiles.h"

#include <algorithm>

#include <QApplication>
#include <QDateTime>
#include <QFileInfo>
#include <QTimer>
#include <QWidget>

#include "gui/project/NewProjectDialog.h"
#include "gui/settings/Preferences.h"
#include "gui/start/DataFolder.h"
#include "gui/widgets/NumberFormat.h"
#include "gui/widgets/Sentences.h"
#include "gui/workbench/FirstScene.h"
#include "gui/workbench/Workbench.h"
#include "irsg/geometry/reading/OpenableFiles.h"
#include "smatcore/project/FileCollection.h"
#include "smatcore/project/ProjectFile.h"
#include "smatcore/settings/SettingKeys.h"

namespace smat::gui {
namespace {

/// Models up to this size are read within a moment.
constexpr std::uintmax_t quickModel_bytes = 4'000'000;
/// How often a large model that was read looks whether the dialog in its way is gone.
constexpr int dialogPause_ms = 100;

/// Of a model; nothing for other files.
std::optional<std::uintmax_t> modelBytes(const std::filesystem::path& file) {
    std::error_code failure;
    const auto bytes = std::filesystem::file_size(file, failure);
    if (failure || file.extension() == ".smat" ||
        irsg::refusalOf(file.string(), irsg::FileKind::model))
        return std::nullopt;
    return bytes;
}

/// What a project without a file is known by.
QString wordsOf(const Project& project) {
    QStringList models;
    for (const auto& model : project.models)
        models << QString::fromStdString(model.file.filename().string());
    return project.title.empty() ? models.join(", ") : QString::fromStdString(project.title);
}

} // namespace

ProjectFiles::ProjectFiles(Workbench& workbench, Dialogs& dialogs, const Preferences& preferences,
                           QWidget* window)
    : QObject(window),
      workbench_(workbench),
      dialogs_(dialogs),
      preferences_(preferences),
      window_(window),
      recovery_(workbench, preferences.recoveryDelay_s),
      opening_(workbench.models()) {
    connect(&recovery_, &RecoveryCopy::failed, this, &ProjectFiles::said);
    connect(&opening_, &ModelOpening::wasRead, this, &ProjectFiles::openRead);
    connect(&opening_, &ModelOpening::failed, this, [this](const QStringList& sentences) {
        dialogs_.tell(window_, tr("This file cannot be opened"), sentences);
    });
    // Who opens something else in the meantime has changed his mind.
    connect(&workbench_, &Workbench::projectOpened, this, [this] {
        opening_.cancel();
        read_.clear();
    });
}

QString ProjectFiles::modelPatterns() {
    return QString::fromStdString(irsg::filterOf(irsg::FileKind::model));
}

QString ProjectFiles::modelFilter() {
    return tr("Models (%1)").arg(modelPatterns());
}

QString ProjectFiles::displayName() const {
    return QString::fromStdString(workbench_.project().displayName());
}

void ProjectFiles::addSettler(std::function<bool()> settle) {
    settlers_.push_back(std::move(settle));
}

bool ProjectFiles::settle() {
    for (const auto& other : settlers_)
        if (!other())
            return false;
    const QStringList unsaved = unsavedWords();
    if (unsaved.isEmpty())
        return true;
    if (!workbench_.hasProject())
        return dialogs_.ask(window_, tr("Unsaved results"),
                            tr("%1 Without a project they are saved one by one, in the results.")
                                .arg(unsaved.join(' ')),
                            {tr("&Discard")}) == 0;
    switch (dialogs_.ask(window_, tr("Unsaved changes"), unsaved.join(' '),
                         {tr("&Save"), tr("&Discard")})) {
    case 0:
        return save();
    case 1:
        recovery_.forget();
        workbench_.painted().discard();
        return true;
    default:
        return false;
    }
}

QStringList ProjectFiles::unsavedWords() const {
    QStringList sentences;
    for (const QString& model : workbench_.painted().unsaved())
        sentences << tr("Painted codes of %1 are not saved.").arg(model);
    if (workbench_.isModified())
        sentences << tr("%1 has changes that are not saved.").arg(displayName());
    if (const int results = workbench_.resultStore().unsavedCount(); results > 0)
        sentences << (results == 1 ? tr("One result is not saved.")
                                   : tr("%1 results are not saved.").arg(results));
    return sentences;
}

bool ProjectFiles::newProject() {
    if (!settle())
        return false;
    NewProjectDialog dialog(dialogs_, window_);
    if (!dialogs_.run(dialog))
        return false;
    Project project = dialog.project();
    project.settings = firstSettings(project.settings, dialog.bounds());
    workbench_.adopt(project);
    remember();
    return true;
}

Settings ProjectFiles::firstSettings(Settings usual,
                                     const std::optional<irsg::BoundingBox>& bounds) const {
    usual.set(key::displayColorMap, preferences_.colorMap);
    return bounds ? firstScene(*bounds, usual) : usual;
}

bool ProjectFiles::chooseModel() {
    const QString file =
        dialogs_.openFile(window_, tr("Open a model"), {modelFilter(), tr("All files (*)")});
    return !file.isEmpty() && open(file.toStdString());
}

bool ProjectFiles::open(const std::filesystem::path& file) {
    const auto absolute = std::filesystem::absolute(file).lexically_normal();
    if (modelBytes(absolute).value_or(0) > quickModel_bytes) {
        opening_.read(absolute);
        return true;
    }
    if (!settle())
        return false;
    if (absolute.extension() == ".smat") {
        if (RecoveryCopy::isInUse(absolute))
            emit said(tr("%1 has unsaved changes in another window").arg(textOf(absolute)));
        const Recovery recovery = recover(absolute);
        if (recovery != Recovery::none)
            return recovery == Recovery::taken;
    }
    return load(absolute);
}

bool ProjectFiles::load(const std::filesystem::path& file) {
    std::vector<std::string> remarks;
    try {
        requireReadable(file);
        workbench_.open(file, &remarks);
    } catch (const irsg::InputError& error) {
        dialogs_.tell(window_, tr("This file cannot be opened"), sentencesOf(error));
        return false;
    }
    if (workbench_.project().file.empty()) {
        const Project& begun = workbench_.project();
        const auto model = workbench_.models()->model(ModelKey::of(begun, begun.models.front()));
        workbench_.beginWith(firstSettings(workbench_.settings(), model->bounds()));
    }
    remember();
    QStringList unknown;
    for (const auto& key : unknownKeys(workbench_.project()))
        unknown << QString::fromStdString(key);
    if (!unknown.isEmpty())
        emit remarked(tr("Not known to this version, and kept: %1").arg(unknown.join(", ")));
    for (const std::string& remark : remarks)
        emit remarked(tr("Former name, saved as of today: %1").arg(QString::fromStdString(remark)));
    recoverPaint();
    return true;
}

void ProjectFiles::recoverPaint() {
    for (const ProjectModel& model : workbench_.project().models) {
        const auto file = ModelKey::of(workbench_.project(), model).file;
        const auto copy = PaintedModels::leftBehind(file);
        if (!copy)
            continue;
        const int answer =
            dialogs_.ask(window_, tr("Recover unsaved changes"),
                         tr("Painted codes of %1 were not saved. A copy of %2 was kept.")
                             .arg(textOf(file.filename()), whenWritten(*copy)),
                         {tr("&Recover it"), tr("&Discard it")});
        if (answer == 1)
            RecoverySlot::remove(*copy);
        if (answer != 0)
            continue;
        try {
            workbench_.painted().recover(file, *copy);
        } catch (const irsg::InputError& error) {
            dialogs_.tell(window_, tr("The recovery copy cannot be read; it is left where it is"),
                          sentencesOf(error));
        }
    }
}

bool ProjectFiles::savePaint() {
    const auto changed = workbench_.painted().changedOutside();
    for (const auto& file : changed)
        if (dialogs_.ask(
                window_, tr("Changed by another program"),
                tr("The painted codes in %1 were changed by another program.").arg(textOf(file)),
                {tr("&Replace it")}) != 0)
            return false;
    try {
        workbench_.painted().save();
    } catch (const irsg::InputError& error) {
        dialogs_.tell(window_, tr("The painted codes cannot be saved"), sentencesOf(error));
        return false;
    }
    return true;
}

void ProjectFiles::openRead(const std::filesystem::path& file) {
    read_ = file;
    // A dialog may be at work on what is open.
    if (QApplication::activeModalWidget() != nullptr)
        QTimer::singleShot(dialogPause_ms, this, [this, file] {
            if (read_ == file)
                openRead(file);
        });
    else if (settle())
        load(file);
}

void ProjectFiles::requireReadable(const std::filesystem::path& file) const {
    const auto bytes = modelBytes(file);
    if (!bytes || *bytes > quickModel_bytes)
        return;
    const Project opened = projectOfModel(file);
    workbench_.models()->model(ModelKey::of(opened, opened.models.front()));
}

ProjectFiles::Recovery ProjectFiles::recover(const std::filesystem::path& file) {
    const auto copies = RecoveryCopy::leftBehind(file);
    bool left = false;
    for (std::size_t number = 1; number <= copies.size(); ++number) {
        const auto& copy = copies[number - 1];
        Project recovered;
        try {
            recovered = RecoveryCopy::read(copy, file);
        } catch (const irsg::InputError& error) {
            dialogs_.tell(window_,
                          file.empty()
                              ? tr("The recovery copy cannot be read; it is left where it is")
                              : tr("The recovery copy cannot be read; the saved project is opened"),
                          sentencesOf(error));
            continue;
        }
        QString question =
            (file.empty() ? tr("A project that was never saved (%1) was not closed properly. Its "
                               "changes of %2 were kept.")
                                .arg(wordsOf(recovered), whenWritten(copy))
                          : tr("%1 was not closed properly. Its unsaved changes of %2 were kept.")
                                .arg(textOf(file.filename()), whenWritten(copy)));
        if (copies.size() > 1)
            question += tr(" (%1 of %2)").arg(number).arg(copies.size());
        const int answer = dialogs_.ask(window_, tr("Recover unsaved changes"), question,
                                        {tr("&Recover them"), tr("&Discard them")});
        if (answer == 0) {
            adopt(recovered, copy);
            return Recovery::taken;
        }
        if (answer == 1)
            RecoverySlot::remove(copy);
        else
            left = true;
    }
    return left ? Recovery::left : Recovery::none;
}

void ProjectFiles::adopt(const Project& recovered, const std::filesystem::path& copy) {
    workbench_.adopt(recovered);
    recovery_.takeOver(copy);
    remember();
    recoverPaint();
}

bool ProjectFiles::begin(const std::filesystem::path& file) {
    if (file.extension() == ".smat")
        return open(file);
    if (recover({}) == Recovery::taken) {
        if (!file.empty())
            emit said(tr("%1 is not opened: the recovered project is").arg(textOf(file)));
        return true;
    }
    return file.empty() ? offerRecentProject() : open(file);
}

bool ProjectFiles::offerRecentProject() {
    std::vector<std::pair<QDateTime, std::filesystem::path>> projects;
    for (const auto& recent : workbench_.recentFiles()) {
        const std::filesystem::path file = recent.toStdString();
        if (file.extension() != ".smat")
            continue;
        const auto copies = RecoveryCopy::leftBehind(file);
        if (!copies.empty())
            projects.emplace_back(QFileInfo(textOf(copies.front())).lastModified(), file);
    }
    std::ranges::stable_sort(projects, std::greater{}, [](const auto& it) { return it.first; });
    for (const auto& [when, file] : projects) {
        const auto copy = RecoveryCopy::leftBehind(file).front();
        Project recovered;
        try {
            recovered = RecoveryCopy::read(copy, file);
        } catch (const irsg::InputError&) {
            continue; // told when its project is opened
        }
        if (dialogs_.ask(
                window_, tr("Recover unsaved changes"),
                tr("%1 has unsaved changes of an earlier run, of %2. Until they are opened "
                   "they are kept beside the file.")
                    .arg(textOf(file.filename()), whenWritten(copy)),
                {tr("&Open with them")}) != 0)
            return false;
        adopt(recovered, copy);
        return true;
    }
    return false;
}

void ProjectFiles::remember() {
    written_ = irsg::stampOf(workbench_.project().file);
}

bool ProjectFiles::save() {
    if (!workbench_.hasProject())
        return false;
    const auto file = workbench_.project().file;
    if (file.empty() || isOfSample(file))
        return saveAs();
    const auto now = irsg::stampOf(file);
    if (now && now != written_) {
        const int answer = dialogs_.ask(
            window_, tr("Changed by another program"),
            tr("%1 was written by another program after it was opened here.").arg(textOf(file)),
            {tr("&Replace it"), tr("Save &as…")});
        if (answer != 0)
            return answer == 1 && saveAs();
    }
    return saveTo(file);
}

bool ProjectFiles::saveAs() {
    if (!workbench_.hasProject())
        return false;
    const Project& project = workbench_.project();
    std::filesystem::path suggestion = project.file;
    if (suggestion.empty() && !project.models.empty())
        suggestion = std::filesystem::path(project.models.front().file).replace_extension(".smat");
    const QString file = dialogs_.saveFile(
        window_, tr("Save the project"), {tr("Projects (*.smat)")}, textOf(ownPlaceOf(suggestion)));
    if (file.isEmpty())
        return false;
    const auto place = std::filesystem::absolute(file.toStdString()).lexically_normal();
    bool withFiles = false;
    if (place.parent_path() != project.file.parent_path() &&
        refersElsewhere(workbench_.editedProject(), place.parent_path())) {
        const int answer = dialogs_.ask(
            window_, tr("Save the project elsewhere"),
            tr("It needs files that lie outside of %1: models, databases or atmospheres.")
                .arg(textOf(place.parent_path())),
            {tr("&Use them where they are"), tr("&Copy them beside it")});
        withFiles = answer == 1;
        if (withFiles && !mayCopyFiles())
            return false;
    }
    return saveTo(place, withFiles);
}

bool ProjectFiles::mayCopyFiles() {
    QStringList unsaved;
    if (workbench_.database().isDirty())
        unsaved << tr("The database has changes that are not saved; copies are made of files.");
    if (workbench_.painted().isDirty())
        unsaved << tr("Painted codes of a model are not saved, and copies are made from files.");
    if (!unsaved.isEmpty())
        dialogs_.tell(window_, tr("Save these first"), unsaved);
    return unsaved.isEmpty();
}

bool ProjectFiles::collect() {
    if (!workbench_.hasProject() || !mayCopyFiles())
        return false;
    const QString file = dialogs_.saveFile(window_, tr("Collect files"), {tr("Projects (*.smat)")},
                                           textOf(ownPlaceOf(workbench_.project().file)));
    if (file.isEmpty())
        return false;
    try {
        const std::filesystem::path place = file.toStdString();
        requireOwnPlace(place);
        if (std::filesystem::absolute(place).lexically_normal() == workbench_.project().file)
            throw irsg::InputError({place.string(), "", "the project that is open",
                                    "another place, which the copy is for"});
        FileCollection files(collectionFolder(place));
        collectProject(workbench_.editedProject(), place, &files);
        emit said(tr("Copied the project with %1 files (%2 MB) to %3")
                      .arg(files.copies().size())
                      .arg(1e-6 * static_cast<double>(files.size_B()), 0, 'f', 1)
                      .arg(file));
    } catch (const irsg::InputError& error) {
        dialogs_.tell(window_, tr("The files cannot be collected"), sentencesOf(error));
        return false;
    }
    return true;
}

bool ProjectFiles::saveTo(const std::filesystem::path& file, bool withFiles) {
    try {
        requireOwnPlace(file);
        workbench_.saveAs(file, withFiles);
    } catch (const irsg::InputError& error) {
        dialogs_.tell(window_, tr("The project cannot be saved"), sentencesOf(error));
        return false;
    }
    remember();
    if (!savePaint())
        return false;
    try {
        workbench_.saveResults();
    } catch (const irsg::InputError& error) {
        dialogs_.tell(window_, tr("Not all results can be kept with the project"),
                      sentencesOf(error));
        return false;
    }
    emit said(tr("Saved %1").arg(textOf(workbench_.project().file)));
    return true;
}

bool ProjectFiles::chooseModelFile(std::size_t model) {
    const QString file =
        dialogs_.openFile(window_, tr("File of the model"), {modelFilter(), tr("All files (*)")});
    if (file.isEmpty())
        return false;
    Project changed = workbench_.project();
    changed.models.at(model).file = file.toStdString();
    workbench_.edit(changed, tr("Take model %1").arg(QFileInfo(file).fileName()));
    return true;
}

} // namespace smat::gui

#include "moc_ProjectFiles.cpp"
