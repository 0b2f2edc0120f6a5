#include "gui/MainDialogs.h"

#include <QApplication>
#include <QMainWindow>
#include <QStatusBar>

#include "gui/HelpDialogs.h"
#include "gui/analysis/AnalysisGeneratorDialog.h"
#include "gui/analysis/ResultPage.h"
#include "gui/project/ConvertModelDialog.h"
#include "gui/project/FirstSignatureDialog.h"
#include "gui/project/NamedAnalyses.h"
#include "gui/project/ProjectFiles.h"
#include "gui/project/ProjectPropertiesDialog.h"
#include "gui/settings/ImagingSensorFiles.h"
#include "gui/settings/Preferences.h"
#include "gui/settings/SettingsDialog.h"
#include "gui/start/GuidePage.h"
#include "gui/widgets/Sentences.h"
#include "gui/widgets/Theme.h"
#include "gui/workbench/FirstScene.h"
#include "gui/workbench/ModelStore.h"
#include "gui/workbench/PageTabs.h"
#include "gui/workbench/UnsavedNote.h"
#include "gui/workbench/Workbench.h"

namespace smat::gui {

MainDialogs::MainDialogs(QMainWindow& window, Workbench& workbench, Dialogs& dialogs,
                         Preferences& preferences, ProjectFiles& files, PageTabs& tabs)
    : QObject(&window),
      window_(window),
      workbench_(workbench),
      dialogs_(dialogs),
      preferences_(preferences),
      files_(files),
      tabs_(tabs) {
    connect(&workbench_, &Workbench::resultAdded, this, [this](int id) {
        sceneRenderer_ = QString::fromStdString(workbench_.result(id)->data->renderer);
    });
}

FileChooser MainDialogs::fileChooser() {
    return [this](const QString& title, const QString& filter) {
        return dialogs_.openFile(&window_, title, {filter});
    };
}

void MainDialogs::say(const QString& sentence) {
    window_.statusBar()->showMessage(sentence, 8000);
}

void MainDialogs::newAnalysis(AnalysisKind kind, const Settings& settings, const QString& name) {
    if (!workbench_.hasProject())
        return;
    AnalysisGeneratorDialog dialog(workbench_.project(), settings, kind, fileChooser(), &window_);
    dialog.setName(name);
    dialog.setUnsavedNote(unsavedNote(workbench_));
    if (dialogs_.run(dialog))
        workbench_.start(dialog.data());
}

void MainDialogs::startAgain(const QString& name) {
    if (const auto* analysis = workbench_.project().find(name.toStdString()))
        newAnalysis(analysis->kind, workbench_.settings().with(analysis->settings), name);
}

void MainDialogs::keepShownAnalysis() {
    const auto* page = tabs_.currentResult();
    const auto* entry = page != nullptr ? workbench_.result(page->resultIds().first()) : nullptr;
    if (entry == nullptr || !workbench_.hasProject())
        return;
    workbench_.edit(withAnalysis(workbench_.project(), workbench_.settings(), *entry->data),
                    tr("Keep an analysis"));
    say(tr("Kept; find it in the scene tree and under Analysis"));
}

void MainDialogs::removeAnalysis(const QString& name) {
    workbench_.edit(withoutAnalysis(workbench_.project(), name.toStdString()),
                    tr("Remove analysis %1").arg(name));
}

void MainDialogs::convertModel() {
    ConvertModelDialog dialog(dialogs_, &window_);
    if (dialogs_.run(dialog) && !dialog.fileToOpen().isEmpty())
        files_.open(dialog.fileToOpen().toStdString());
}

void MainDialogs::showProjectProperties() {
    if (!workbench_.hasProject())
        return;
    ProjectPropertiesDialog dialog(workbench_.project(), &window_);
    if (dialogs_.run(dialog))
        workbench_.edit(dialog.project(), tr("Change project properties"));
}

void MainDialogs::makeFirstSignature() {
    if (!workbench_.hasProject() || workbench_.project().models.empty())
        return;
    FirstSignatureDialog dialog(workbench_.project(), workbench_.chosenModel(), &window_);
    if (!dialogs_.run(dialog))
        return;
    try {
        // What was framed as it was opened is framed as it is placed, 12 m long in place of 1200.
        const Project& project = workbench_.project();
        const auto model =
            workbench_.models()->model(ModelKey::of(project, project.models.front()));
        const bool isFramed =
            workbench_.chosenModel() == 0 &&
            firstScene(model->bounds(), workbench_.settings()) == workbench_.settings();
        Project edited = dialog.write();
        edited.settings = workbench_.settings();
        if (const auto bounds = dialog.bounds(); isFramed && bounds)
            edited.settings = firstScene(*bounds, edited.settings);
        workbench_.editWhole(edited, tr("Make a first signature"));
        say(tr("Codes and database were written beside the model; refine them in the database"));
    } catch (const irsg::InputError& error) {
        dialogs_.tell(&window_, tr("The first signature cannot be written"), sentencesOf(error));
    }
}

void MainDialogs::importImagingSensor() {
    if (workbench_.hasProject())
        gui::importImagingSensor(workbench_, dialogs_, &window_,
                                 [this](const QString& sentence) { say(sentence); });
}

void MainDialogs::exportImagingSensor() {
    if (workbench_.hasProject())
        gui::exportImagingSensor(workbench_, dialogs_, &window_,
                                 [this](const QString& sentence) { say(sentence); });
}

void MainDialogs::showSettings(const QString& page) {
    if (!workbench_.hasProject())
        return;
    SettingsDialog dialog(workbench_, fileChooser(), &window_);
    dialog.showPage(page);
    dialogs_.run(dialog);
}

void MainDialogs::showPreferences() {
    PreferencesDialog dialog(preferences_, &window_);
    if (!dialogs_.run(dialog))
        return;
    preferences_ = dialog.preferences();
    files_.recovery().setDelay(preferences_.recoveryDelay_s);
    applyTheme(*qApp, preferences_.theme);
    DisplayUnitsWatch::instance().set(preferences_.units);
    try {
        preferences_.save();
    } catch (const irsg::InputError& error) {
        dialogs_.tell(&window_, tr("The preferences cannot be saved"), sentencesOf(error));
    }
}

void MainDialogs::showAbout(const QString& viewRenderer) {
    AboutDialog dialog(viewRenderer, sceneRenderer_, &window_);
    dialogs_.run(dialog);
}

void MainDialogs::showGuide() {
    if (!GuidePage::isThere()) {
        dialogs_.tell(&window_, tr("The guide"),
                      {tr("The guide is not installed. The environment variable SMAT_DATA names "
                          "the folder that contains docs/user-guide.")});
        return;
    }
    tabs_.addPage(new GuidePage("first-signature.md"), icon("info"), tr("Guide"));
}

} // namespace smat::gui

#include "moc_MainDialogs.cpp"
