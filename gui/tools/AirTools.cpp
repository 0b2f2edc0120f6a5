#include "gui/tools/AirTools.h"

#include <QAction>
#include <QMenu>

#include "gui/Theme.h"
#include "gui/Workbench.h"
#include "gui/tools/RadiativePage.h"
#include "gui/tools/TemperatureProfilePage.h"

namespace smat::gui {

void addAirTools(
    QMenu& menu, Workbench& workbench, const Dialogs& dialogs,
    std::function<void(QWidget* page, const QIcon& icon, const QString& title)> addPage) {
    const auto add = [&](const QString& name, const QString& iconName, const QString& text,
                         const QString& title, const QString& tip, const auto& make) {
        auto* action = menu.addAction(icon(iconName), text);
        action->setObjectName(name);
        action->setToolTip(tip);
        action->setEnabled(workbench.hasProject());
        QObject::connect(&workbench, &Workbench::projectOpened, action,
                         [action] { action->setEnabled(true); });
        QObject::connect(action, &QAction::triggered, action,
                         [=] { addPage(make(), icon(iconName), title); });
    };
    add("radiativeOutput", "radiative", QObject::tr("&Radiative output…"),
        QObject::tr("Radiative output"),
        QObject::tr("Spectra of the air between viewer and target"),
        [&workbench, dialogs] { return new RadiativePage(workbench, dialogs); });
    add("temperatureProfile", "thermometer", QObject::tr("&Temperature profile…"),
        QObject::tr("Temperature profile"), QObject::tr("Temperature of the air over altitude"),
        [&workbench, dialogs] { return new TemperatureProfilePage(workbench, dialogs); });
}

} // namespace smat::gui
