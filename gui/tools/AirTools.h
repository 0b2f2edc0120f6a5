#pragma once

#include <functional>

#include "gui/widgets/Dialogs.h"

class QIcon;
class QMenu;
class QString;
class QWidget;

namespace smat::gui {

class Workbench;

/// Puts the tools that ask the air of the project, radiative output and temperature profile, into a
/// menu. Each opens a page, which `addPage` shows. They wait for a project.
void addAirTools(
    QMenu& menu, Workbench& workbench, const Dialogs& dialogs,
    std::function<void(QWidget* page, const QIcon& icon, const QString& title)> addPage);

} // namespace smat::gui
