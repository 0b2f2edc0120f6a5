#pragma once

#include <functional>

#include "gui/widgets/Dialogs.h"

class QIcon;
class QMenu;
class QString;
class QWidget;

namespace smat::gui {

class Workbench;

/// Puts the tools that have a page (of allTools(), in their order) into a menu. Each opens its
/// page, which `addPage` shows; those that ask the air of the project wait for one. A simulation
/// has none here: it is run on the page of its scenario.
void addToolPages(
    QMenu& menu, Workbench& workbench, const Dialogs& dialogs,
    const std::function<void(QWidget* page, const QIcon& icon, const QString& title)>& addPage);

} // namespace smat::gui
