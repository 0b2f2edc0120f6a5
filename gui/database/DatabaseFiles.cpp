#include "gui/database/DatabaseFiles.h"

#include <QObject>

#include "gui/database/QuestionDialog.h"
#include "gui/start/DataFolder.h"
#include "gui/widgets/Sentences.h"
#include "irsg/core/Errors.h"
#include "irsg/geometry/model/Model.h"
#include "irsg/signature/ScalingXml.h"

namespace smat::gui {

QStringList databaseFilters() {
    return {QObject::tr("Signature databases (*.sigdb)"), QObject::tr("All files (*)")};
}

bool DatabaseFiles::mayClose() {
    auto& session = context_.session();
    if (!session.isOpen() || !session.isDirty())
        return true;
    QuestionDialog question(tr("Unsaved database"),
                            tr("%1 has edits that are not saved.")
                                .arg(QString::fromStdString(session.file().filename().string())),
                            {tr("Save"), tr("Discard")}, context_.window);
    if (!context_.dialogs().run(question))
        return false;
    if (question.answer() == 0)
        save();
    else
        session.discard();
    return !session.isDirty();
}

bool DatabaseFiles::mayCloseAll() {
    for (;;) {
        if (!mayClose())
            return false;
        const auto edited = context_.workbench().editedDatabases();
        if (edited.empty())
            return true;
        // It comes to sight first: nobody decides on what is hidden.
        const auto file = std::filesystem::absolute(edited.begin()->first).lexically_normal();
        emit context_.session().wanted(file);
        if (context_.session().file() != file)
            throw irsg::LogicError("the database of a model cannot be shown: " + file.string());
    }
}

void DatabaseFiles::open() {
    if (!context_.workbench().hasProject() || !mayClose())
        return;
    const QString file = context_.dialogs().openFile(
        context_.window, tr("Open a signature database"), databaseFilters());
    if (!file.isEmpty())
        context_.attempt(tr("This database cannot be opened"),
                         [&] { context_.workbench().target().use(file.toStdString()); });
}

void DatabaseFiles::makeNew() {
    auto& workbench = context_.workbench();
    if (!workbench.hasProject() || !mayClose())
        return;
    if (context_.isReadingModel()) {
        context_.dialogs().tell(context_.window, tr("The model is still being read"),
                                {tr("A new database has an entry for every index of the model. "
                                    "Try again in a moment.")});
        return;
    }
    const Project& project = workbench.project();
    const ModelKey key = ModelKey::of(project, project.models.at(workbench.chosenModel()));
    const auto& model = key.file;
    const QString file = context_.dialogs().saveFile(
        context_.window, tr("New signature database"), databaseFilters(),
        QString::fromStdString(std::filesystem::path(model).replace_extension(".sigdb").string()));
    if (file.isEmpty())
        return;
    context_.attempt(tr("This model cannot be read"), [&] {
        const auto target = workbench.models()->model(key);
        // The model's own names of what has an index take another reading of its file.
        naming_.run<irsg::IndexNames>(
            [model, codes = target->codesBeside()] {
                return irsg::IndexNames(irsg::namesOf(model, *codes).names);
            },
            [this, key, target, file](const irsg::IndexNames& names) {
                useNew(key, *target, file.toStdString(), names);
            },
            [this](const std::exception_ptr& thrown) {
                context_.dialogs().tell(context_.window, tr("This model cannot be read"),
                                        sentencesOf(thrown));
            });
    });
}

void DatabaseFiles::useNew(const ModelKey& key, const irsg::Model& model,
                           const std::filesystem::path& file, const irsg::IndexNames& names) {
    auto& workbench = context_.workbench();
    if (!workbench.hasProject())
        return;
    const Project& project = workbench.project();
    if (ModelKey::of(project, project.models.at(workbench.chosenModel())) != key)
        return; // another model is meant by now
    context_.attempt(tr("This database cannot be made"), [&] {
        workbench.target().useNew(
            file, irsg::blackDatabase(model.codes(), names, key.file.stem().string()));
    });
}

void DatabaseFiles::save() {
    auto& session = context_.session();
    if (!session.isOpen())
        return;
    if (isOfSample(session.file())) {
        saveAs();
        return;
    }
    QStringList problem;
    if (!session.isChangedOnDisk()) {
        try {
            session.save();
        } catch (const irsg::InputError& error) {
            problem = sentencesOf(error);
        }
    }
    // It may have changed a moment ago, while the save began.
    if (session.isChangedOnDisk()) {
        QuestionDialog question(tr("The file has changed"),
                                tr("Another program has changed this file since it was read."),
                                {tr("Replace it with mine"), tr("Take the file's version")},
                                context_.window);
        if (!context_.dialogs().run(question))
            return;
        if (question.answer() == 0)
            overwrite();
        else
            context_.attempt(tr("The signature database"), [&] { session.reload(); });
        return;
    }
    if (!problem.isEmpty())
        context_.dialogs().tell(context_.window, tr("This database cannot be saved"), problem);
    if (!session.isDirty())
        createScalings();
}

void DatabaseFiles::overwrite() {
    context_.attempt(tr("This database cannot be saved"), [this] {
        context_.session().overwrite();
        createScalings();
    });
}

void DatabaseFiles::createScalings() {
    // Each only where it is not there: what somebody wrote is never touched.
    const auto& project = context_.workbench().project();
    if (project.models.empty())
        return;
    const auto model = project.resolve(project.models.at(context_.workbench().chosenModel()).file);
    if (isOfSample(model))
        return;
    context_.attempt(tr("The scaling files cannot be written"),
                     [&] { irsg::createScalingFiles(model, context_.session().value()); });
}

void DatabaseFiles::saveAs() {
    auto& session = context_.session();
    if (!session.isOpen())
        return;
    const auto& project = context_.workbench().project().file;
    const bool besideProject =
        isOfSample(session.file()) && !project.empty() && !isOfSample(project);
    const auto suggestion = besideProject ? project.parent_path() / session.file().filename()
                                          : ownPlaceOf(session.file());
    const QString file =
        context_.dialogs().saveFile(context_.window, tr("Save the signature database as"),
                                    databaseFilters(), QString::fromStdString(suggestion.string()));
    if (!file.isEmpty())
        context_.attempt(tr("This database cannot be saved"), [&] {
            context_.workbench().target().saveAs(file.toStdString());
            createScalings();
        });
}

} // namespace smat::gui
