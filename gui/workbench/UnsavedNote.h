#pragma once

#include <QString>

namespace smat::gui {

class Workbench;

/// What a command that reads the files would do without, in a sentence: models, analyses and
/// databases with edits that are not saved. Settings are no part of it, as commands say them.
/// Empty where nothing is missing.
QString unsavedNote(const Workbench& workbench);

} // namespace smat::gui
