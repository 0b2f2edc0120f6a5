#include "gui/tools/AirTools.h"

#include <QAction>
#include <QMenu>

#include "gui/tools/RadiativePage.h"
#include "gui/tools/TemperatureProfilePage.h"
#include "gui/widgets/Theme.h"
#include "gui/workbench/Workbench.h"
#include "smatcore/analysis/AnalysisDefinition.h"

namespace smat::gui {

void addAirTools(
    QMenu& menu, Workbench& workbench, const Dialogs& dialogs,
    std::function<void(QWidget* page, const QIcon& icon, const QString& title)> addPage) {
    const auto add = [&](const QString& name, AnalysisKind kind, const QString& text,
                         const auto& make) {
        const QString title = QObject::tr(kind->title);
        auto* action = menu.addAction(icon(kind->icon), text);
        action->setObjectName(name);
        action->setToolTip(QObject::tr(kind->help));
        action->setEnabled(workbench.hasProject());
        QObject::connect(&workbench, &Workbench::projectOpened, action,
                         [action] { action->setEnabled(true); });
        QObject::connect(action, &QAction::triggered, action,
                         [=] { addPage(make(), icon(kind->icon), title); });
    };
    add("radiativeOutput", AnalysisKind::radiative, QObject::tr("&Radiative output…"),
        [&workbench, dialogs] { return new RadiativePage(workbench, dialogs); });
    add("temperatureProfile", AnalysisKind::temperatureProfile,
        QObject::tr("&Temperature profile…"),
        [&workbench, dialogs] { return new TemperatureProfilePage(workbench, dialogs); });
}

} // namespace smat::gui
