#include <QApplication>
#include <QStatusBar>

#include "gui/HelpDialogs.h"
#include "gui/MainWindow.h"
#include "gui/Sentences.h"
#include "gui/analysis/ResultPage.h"
#include "gui/project/ConvertModelDialog.h"
#include "gui/project/NamedAnalyses.h"
#include "gui/project/ProjectFiles.h"
#include "gui/project/ProjectPropertiesDialog.h"
#include "gui/settings/SettingsDialog.h"
#include "gui/view/SceneView.h"

namespace smat::gui {

void MainWindow::convertModel() {
    ConvertModelDialog dialog(dialogs_, this);
    if (dialogs_.run(dialog) && !dialog.fileToOpen().isEmpty())
        open(dialog.fileToOpen().toStdString());
}

void MainWindow::showProjectProperties() {
    if (!workbench_.hasProject())
        return;
    ProjectPropertiesDialog dialog(workbench_.project(), this);
    if (dialogs_.run(dialog))
        workbench_.edit(dialog.project(), tr("Change project properties"));
}

void MainWindow::keepShownAnalysis() {
    const auto* page = currentPage();
    const auto* entry = page != nullptr ? workbench_.result(page->resultIds().first()) : nullptr;
    if (entry == nullptr || !workbench_.hasProject())
        return;
    workbench_.edit(withAnalysis(workbench_.project(), workbench_.settings(), *entry->data),
                    tr("Keep an analysis"));
    statusBar()->showMessage(tr("Kept; find it in the scene tree and under Analysis"), 8000);
}

void MainWindow::showPreferences() {
    PreferencesDialog dialog(preferences_, this);
    if (!dialogs_.run(dialog))
        return;
    preferences_ = dialog.preferences();
    files_->recovery().setDelay(preferences_.recoveryDelay_s);
    applyTheme(*qApp, preferences_.theme);
    try {
        preferences_.save();
    } catch (const irsg::InputError& error) {
        dialogs_.tell(this, tr("The preferences cannot be kept"), sentencesOf(error));
    }
}

void MainWindow::showSettings(const QString& page) {
    if (!workbench_.hasProject())
        return;
    SettingsDialog dialog(workbench_, fileChooser(), this);
    dialog.showPage(page);
    dialogs_.run(dialog);
}

void MainWindow::tellInternalError(const QString& what) {
    files_->recovery().writeNow();
    dialogs_.tell(this, tr("Internal error"),
                  {what, tr("Your unsaved changes were kept in a recovery copy.")});
}

void MainWindow::showAbout() {
    AboutDialog dialog(view_ != nullptr ? view_->renderer() : tr("no OpenGL on this desktop"),
                       sceneRenderer_, this);
    dialogs_.run(dialog);
}

} // namespace smat::gui
