#include "gui/scenario/ScenarioPages.h"

#include "gui/scenario/ScenarioPage.h"
#include "gui/scenario/TimeLine.h"
#include "gui/start/DataFolder.h"
#include "gui/widgets/NumberFormat.h"
#include "gui/widgets/Sentences.h"
#include "gui/widgets/Theme.h"
#include "gui/workbench/PageTabs.h"
#include "gui/workbench/Workbench.h"
#include "irsg/core/Errors.h"
#include "irsg/geometry/Entity.h"
#include "irsg/signature/SignatureFile.h"
#include "smatcore/data/RenderDoor.h"
#include "smatcore/simulate/NewScenario.h"
#include "smatcore/simulate/ScenarioFile.h"

namespace smat::gui {

ScenarioPages::ScenarioPages(Workbench& workbench, Dialogs& dialogs, PageTabs& tabs)
    : QObject(&tabs), workbench_(workbench), dialogs_(dialogs), tabs_(tabs) {}

bool ScenarioPages::open(const std::filesystem::path& file) {
    if (!isScenarioFile(file))
        return false;
    if (ScenarioPage* page = pageOf(file)) {
        tabs_.bring(page);
        return true;
    }
    try {
        auto document = std::make_unique<ScenarioDocument>(file, workbench_.undoStack());
        rememberFile(document->file());
        auto* page = new ScenarioPage(std::move(document), workbench_, dialogs_);
        connect(page, &ScenarioPage::titleChanged, &tabs_,
                [this, page](const QString& title) { tabs_.retitle(page, title); });
        connect(page, &ScenarioPage::said, &tabs_, &PageTabs::said);
        tabs_.addPage(page, icon("scenario"), page->title());
        page->timeLine().takeFocus();
    } catch (const irsg::InputError& error) {
        dialogs_.tell(tabs_.window(), tr("This scenario cannot be opened"), sentencesOf(error));
    }
    return true;
}

namespace {

/// Of the target, in its own axes, as the renderer takes it.
irsg::Vec3 referencePointOf(Workbench& workbench) {
    const Project& project = workbench.project();
    const ProjectModel& model = project.models.front();
    irsg::Entity target;
    target.model = workbench.models()->model(ModelKey::of(project, model));
    target.database = std::make_shared<const irsg::SignatureDatabase>(
        irsg::loadSignatureFile(project.resolve(model.database)).database);
    target.referencePoint_m = model.referencePoint_m;
    target.fallbackMaterial = model.fallbackMaterial;
    return openRenderDoor().referencePoint(target);
}

} // namespace

void ScenarioPages::begin() {
    if (!workbench_.hasProject())
        return;
    try {
        const Project project = workbench_.editedProject();
        scenarioOf(project, {}); // refuses before anything is read
        const Scenario scenario = scenarioOf(project, referencePointOf(workbench_));
        auto suggested = ownPlaceOf(std::filesystem::absolute(
            project.file.empty() ? project.models.front().file : project.file));
        suggested.replace_filename(suggested.stem().string() + "-scenario.json");
        const QString file = dialogs_.saveFile(tabs_.window(), tr("New scenario"),
                                               {tr("Scenarios (*.json)")}, textOf(suggested));
        if (!file.isEmpty())
            write(scenario, file.toStdString());
    } catch (const irsg::InputError& error) {
        dialogs_.tell(tabs_.window(), tr("There is no scenario of this project yet"),
                      sentencesOf(error));
    }
}

void ScenarioPages::write(const Scenario& scenario, const std::filesystem::path& file) {
    requireOwnPlace(file);
    if (pageOf(file) != nullptr)
        throw irsg::InputError(
            {textOf(file).toStdString(), "", "a scenario that is open", "another file"});
    saveScenario(scenario, file);
    open(file);
}

ScenarioPage* ScenarioPages::pageOf(const std::filesystem::path& file) const {
    const auto wanted = std::filesystem::absolute(file).lexically_normal();
    for (QWidget* one : tabs_.pages())
        if (auto* page = qobject_cast<ScenarioPage*>(one);
            page != nullptr && page->document().file() == wanted)
            return page;
    return nullptr;
}

} // namespace smat::gui

#include "moc_ScenarioPages.cpp"
