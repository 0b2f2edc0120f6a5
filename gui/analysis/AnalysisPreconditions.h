#pragma once

#include <QString>

namespace smat::gui {

class Workbench;

/// Why no analysis can be run now, as one sentence that says what to do; empty where one can.
QString missingPreconditions(Workbench& workbench);

} // namespace smat::gui
