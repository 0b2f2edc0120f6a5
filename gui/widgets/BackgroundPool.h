#pragma once

#include <QThreadPool>

namespace smat::gui {

/// The threads in which windows load, colour and convert. Not Qt's global pool: Qt paints with that
/// one, and would wait for a model that is being read. Ends before the application does, waiting
/// for what still runs. Made at the first call, which must come from the window's thread while the
/// application lives.
QThreadPool& backgroundPool();

} // namespace smat::gui
