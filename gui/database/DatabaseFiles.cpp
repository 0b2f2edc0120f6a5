#include "gui/database/DatabaseFiles.h"

#include <QObject>

#include "gui/database/QuestionDialog.h"
#include "gui/start/DataFolder.h"
#include "gui/widgets/Sentences.h"
#include "irsg/radiometry/Errors.h"
#include "irsg/scene/model/Model.h"
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
    const ModelKey key = ModelKey::of(project, project.models.front());
    const auto& model = key.file;
    const QString file = context_.dialogs().saveFile(
        context_.window, tr("New signature database"), databaseFilters(),
        QString::fromStdString(std::filesystem::path(model).replace_extension(".sigdb").string()));
    if (file.isEmpty())
        return;
    context_.attempt(tr("This model cannot be read"), [&] {
        const auto target = workbench.models()->model(key);
        irsg::SignatureDatabase database;
        database.title = model.stem().string();
        for (const auto& [pair, use] : target->codes()) {
            irsg::TemperatureEntry& entry = database.temperatures[pair.temperature];
            entry.name = "temperature " + std::to_string(pair.temperature);
            entry.terms = irsg::TemperatureTerms::ofAmbient();
            database.materials[pair.material].name = "material " + std::to_string(pair.material);
        }
        workbench.target().useNew(file.toStdString(), std::move(database));
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
                                {tr("Save mine over it"), tr("Take the file's version")},
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
    const auto& models = context_.workbench().project().models;
    if (models.empty() || isOfSample(context_.workbench().project().resolve(models.front().file)))
        return;
    context_.attempt(tr("The scaling files cannot be written"), [&] {
        const auto& project = context_.workbench().project();
        irsg::createScalingFiles(project.resolve(models.front().file), context_.session().value());
    });
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
