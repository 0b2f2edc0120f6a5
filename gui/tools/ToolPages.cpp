#include "gui/tools/ToolPages.h"

#include <algorithm>
#include <array>
#include <string_view>

#include <QAction>
#include <QMenu>

#include "gui/tools/CostAccuracyPage.h"
#include "gui/tools/DetectionPage.h"
#include "gui/tools/GasPage.h"
#include "gui/tools/MonteCarloPage.h"
#include "gui/tools/RadiativePage.h"
#include "gui/tools/SensorPage.h"
#include "gui/tools/TemperatureProfilePage.h"
#include "gui/widgets/Theme.h"
#include "gui/workbench/Workbench.h"
#include "smatcore/analysis/AnalysisDefinition.h"

namespace smat::gui {
namespace {

/// What the window has for a tool, beside its definition.
struct MenuEntry {
    std::string_view tool;
    const char* action;
    const char* text;       ///< of the menu, with the letter of its key
    bool queriesAtmosphere; ///< of the project: without one there is none
    QWidget* (*make)(Workbench& workbench, const Dialogs& dialogs);
};

template <typename Page>
QWidget* made(Workbench& workbench, const Dialogs& dialogs) {
    return new Page(workbench, dialogs);
}

constexpr std::array pages = {
    MenuEntry{"radiative", "radiativeOutput", QT_TR_NOOP("&Radiative output…"), true,
              made<RadiativePage>},
    MenuEntry{"temperature-profile", "temperatureProfile", QT_TR_NOOP("&Temperature profile…"),
              true, made<TemperatureProfilePage>},
    MenuEntry{"gas", "hotGas", QT_TR_NOOP("Hot &gas…"), false, made<GasPage>},
    MenuEntry{"detection", "detectionRange", QT_TR_NOOP("&Detection range…"), false,
              made<DetectionPage>},
    MenuEntry{"sensor", "sensorChain", QT_TR_NOOP("&Sensor chain…"), false, made<SensorPage>},
    MenuEntry{"montecarlo", "monteCarlo", QT_TR_NOOP("&Monte Carlo"), false, made<MonteCarloPage>},
    MenuEntry{"cost-accuracy", "frontier", QT_TR_NOOP("Time against &error"), false,
              made<CostAccuracyPage>}};

} // namespace

void addToolPages(
    QMenu& menu, Workbench& workbench, const Dialogs& dialogs,
    const std::function<void(QWidget* page, const QIcon& icon, const QString& title)>& addPage) {
    for (const AnalysisKind kind : allTools()) {
        const auto* const page =
            std::ranges::find(pages, std::string_view(kind->name), &MenuEntry::tool);
        if (page == pages.end())
            continue;
        auto* action = menu.addAction(icon(kind->icon), QObject::tr(page->text));
        action->setObjectName(page->action);
        action->setToolTip(QObject::tr(kind->help));
        QObject::connect(action, &QAction::triggered, action,
                         [&workbench, dialogs, addPage, kind, make = page->make] {
                             addPage(make(workbench, dialogs), icon(kind->icon),
                                     QObject::tr(kind->title));
                         });
        if (!page->queriesAtmosphere)
            continue;
        action->setEnabled(workbench.hasProject());
        QObject::connect(&workbench, &Workbench::projectOpened, action,
                         [action] { action->setEnabled(true); });
    }
}

} // namespace smat::gui
