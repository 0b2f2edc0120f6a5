#pragma once

#include <QSettings>

namespace smat::gui {

/// What the window remembers of itself from one start to the next: its layout, the last files.
inline QSettings memory() {
    return QSettings(QSettings::IniFormat, QSettings::UserScope, "smat", "workbench");
}

} // namespace smat::gui
