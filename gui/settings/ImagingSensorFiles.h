#pragma once

#include <functional>

#include <QString>

#include "gui/widgets/Dialogs.h"

namespace smat::gui {

class Workbench;

/// Takes the settings of an ImagingSensor file of KARMA into the project, as one step that can be
/// undone; parameters without effect are told. `say` hears a sentence in passing.
void importImagingSensor(Workbench& workbench, Dialogs& dialogs, QWidget* window,
                         const std::function<void(const QString&)>& say);
/// Writes the settings of the project as such a file.
void exportImagingSensor(Workbench& workbench, Dialogs& dialogs, QWidget* window,
                         const std::function<void(const QString&)>& say);

} // namespace smat::gui
