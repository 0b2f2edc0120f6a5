#include "gui/atmosphere/AtmospherePages.h"

#include "gui/atmosphere/AtmospherePage.h"
#include "gui/atmosphere/AtmosphereRecovery.h"
#include "gui/atmosphere/ImportAtmosphereDialog.h"
#include "gui/atmosphere/ProjectAtmospherePage.h"
#include "gui/widgets/NumberFormat.h"
#include "gui/widgets/Sentences.h"
#include "gui/widgets/Theme.h"
#include "gui/workbench/PageTabs.h"
#include "gui/workbench/Workbench.h"
#include "irsg/core/Errors.h"
#include "smatcore/project/AtmosphereInput.h"
#include "smatcore/settings/SettingKeys.h"

namespace smat::gui {

AtmospherePages::AtmospherePages(Workbench& workbench, Dialogs& dialogs, PageTabs& tabs)
    : QObject(&tabs), workbench_(workbench), dialogs_(dialogs), tabs_(tabs) {
    // Once the project is there: what asks would stop its opening halfway.
    connect(&workbench_, &Workbench::projectOpened, this, &AtmospherePages::offerCopiesOfProject,
            Qt::QueuedConnection);
}

void AtmospherePages::makeNew() {
    AtmospherePage& page = addPage(std::make_unique<AtmosphereDocument>(workbench_.undoStack()));
    offerCopies({}, [&page]() -> AtmospherePage& { return page; });
}

void AtmospherePages::showProjectAtmosphere() {
    for (QWidget* page : tabs_.pages())
        if (qobject_cast<ProjectAtmospherePage*>(page) != nullptr)
            return tabs_.bring(page);
    tabs_.addPage(new ProjectAtmospherePage(workbench_, dialogs_, *this), icon("air"),
                  tr("Project atmospheres"));
    offerCopiesOfProject();
    offerCopies({}, [this]() -> AtmospherePage& {
        return addPage(std::make_unique<AtmosphereDocument>(workbench_.undoStack()));
    });
}

void AtmospherePages::importTables() {
    ImportAtmosphereDialog dialog(workbench_, dialogs_, tabs_.window());
    dialogs_.run(dialog);
}

bool AtmospherePages::open(const std::filesystem::path& file) {
    if (AtmospherePage* page = pageOf(file)) {
        tabs_.bring(page);
        return true;
    }
    try {
        if (!AtmosphereDocument::isAtmosphere(file))
            throw irsg::InputError(
                {file.string(), "", "another kind of file", "parameters of an AtmosphereSmart"});
        AtmospherePage& page =
            addPage(std::make_unique<AtmosphereDocument>(file, workbench_.undoStack()));
        offerCopies(page.document().file(), [&page]() -> AtmospherePage& { return page; });
        rememberFile(file);
    } catch (const irsg::InputError& error) {
        dialogs_.tell(tabs_.window(), tr("This atmosphere cannot be opened"), sentencesOf(error));
    }
    return true;
}

AtmospherePage& AtmospherePages::addPage(std::unique_ptr<AtmosphereDocument> document) {
    auto* page = new AtmospherePage(std::move(document), workbench_, dialogs_);
    connect(page, &AtmospherePage::titleChanged, &tabs_,
            [this, page](const QString& title) { tabs_.retitle(page, title); });
    connect(page, &AtmospherePage::said, &tabs_, &PageTabs::said);
    tabs_.addPage(page, icon("air"), page->title());
    return *page;
}

void AtmospherePages::offerCopiesOfProject() {
    if (!workbench_.hasProject())
        return;
    for (const auto& listed : workbench_.settings()[key::environmentAtmospheres]) {
        if (isNoAtmosphere(listed))
            continue;
        const auto file =
            std::filesystem::absolute(workbench_.project().resolve(listed)).lexically_normal();
        if (pageOf(file) == nullptr)
            offerCopies(file, [this, &file]() -> AtmospherePage& {
                return addPage(std::make_unique<AtmosphereDocument>(file, workbench_.undoStack()));
            });
    }
}

void AtmospherePages::offerCopies(const std::filesystem::path& file,
                                  const std::function<AtmospherePage&()>& page) {
    for (const auto& copy : AtmosphereRecovery::leftBehind(file)) {
        const QString question =
            file.empty() ? tr("An atmosphere that was never saved was not closed properly. Its "
                              "changes of %1 were kept.")
                               .arg(whenWritten(copy))
                         : tr("%1 was not closed properly. Its unsaved changes of %2 were kept.")
                               .arg(textOf(file.filename()), whenWritten(copy));
        const int answer = dialogs_.ask(tabs_.window(), tr("Recover unsaved changes"), question,
                                        {tr("&Recover them"), tr("&Discard them")});
        if (answer == 1)
            RecoverySlot::remove(copy);
        if (answer != 0)
            continue;
        try {
            return page().recovery().takeOver(copy);
        } catch (const irsg::InputError& error) {
            dialogs_.tell(tabs_.window(),
                          tr("The recovery copy cannot be read; it is left where it is"),
                          sentencesOf(error));
        }
    }
}

AtmospherePage* AtmospherePages::pageOf(const std::filesystem::path& file) const {
    const auto wanted = std::filesystem::absolute(file).lexically_normal();
    for (int i = 0; i < tabs_.count(); ++i)
        if (auto* page = qobject_cast<AtmospherePage*>(tabs_.widget(i));
            page != nullptr && page->document().file() == wanted)
            return page;
    return nullptr;
}

} // namespace smat::gui

#include "moc_AtmospherePages.cpp"
