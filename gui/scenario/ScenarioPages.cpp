#include "gui/scenario/ScenarioPages.h"

#include "gui/scenario/ScenarioPage.h"
#include "gui/scenario/TimeLine.h"
#include "gui/widgets/Sentences.h"
#include "gui/widgets/Theme.h"
#include "gui/workbench/PageTabs.h"
#include "gui/workbench/Workbench.h"
#include "irsg/core/Errors.h"
#include "smatcore/simulate/ScenarioFile.h"

namespace smat::gui {

ScenarioPages::ScenarioPages(Workbench& workbench, Dialogs& dialogs, PageTabs& tabs)
    : QObject(&tabs), workbench_(workbench), dialogs_(dialogs), tabs_(tabs) {}

bool ScenarioPages::open(const std::filesystem::path& file) {
    if (!isScenarioFile(file))
        return false;
    if (ScenarioPage* page = pageOf(file)) {
        tabs_.setCurrentWidget(page);
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

ScenarioPage* ScenarioPages::pageOf(const std::filesystem::path& file) const {
    const auto wanted = std::filesystem::absolute(file).lexically_normal();
    for (int i = 0; i < tabs_.count(); ++i)
        if (auto* page = qobject_cast<ScenarioPage*>(tabs_.widget(i));
            page != nullptr && page->document().file() == wanted)
            return page;
    return nullptr;
}

} // namespace smat::gui

#include "moc_ScenarioPages.cpp"
