#pragma once

#include <optional>

#include "gui/scenario/ScenarioDocument.h"
#include "gui/widgets/Dialogs.h"

class QWidget;

namespace smat::gui {

/// The settings of a scenario, or of one of its sensors on top of them, in a dialog of their pages;
/// each Apply and OK is a step to undo. A setting that becomes what would hold without it is no
/// longer set.
void editScenarioSettings(ScenarioDocument& document, std::optional<std::size_t> sensor,
                          Dialogs& dialogs, QWidget* parent);

} // namespace smat::gui
