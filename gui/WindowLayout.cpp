#include "gui/WindowLayout.h"

#include <algorithm>

#include <QDockWidget>
#include <QMainWindow>
#include <QScreen>

#include "gui/widgets/Memory.h"

namespace smat::gui {
namespace {

/// Of the docks there are: a layout that knows others is not taken.
constexpr int layoutVersion = 4;
constexpr QSize usualSize(1360, 840);
/// Title bar and borders of the desktop.
constexpr QSize frame(8, 40);

} // namespace

WindowLayout::WindowLayout(QMainWindow& window) : QObject(&window), window_(window) {}

QSize WindowLayout::firstSize(const QSize& screen) {
    return usualSize.boundedTo(screen - frame);
}

QString WindowLayout::key(const char* what) const {
    const QSize screen = window_.screen()->size();
    return QStringLiteral("%1-%2x%3").arg(what).arg(screen.width()).arg(screen.height());
}

void WindowLayout::restore() {
    window_.resize(firstSize(window_.screen()->availableSize()));
    const auto kept = memory();
    window_.restoreGeometry(kept.value(key("geometry")).toByteArray());
    window_.restoreState(kept.value(key("layout")).toByteArray(), layoutVersion);
}

void WindowLayout::save() {
    // Docks that one key put away come back with it, not with the next start.
    if (!hidden_.isEmpty())
        toggleDocks();
    auto kept = memory();
    kept.setValue(key("geometry"), window_.saveGeometry());
    kept.setValue(key("layout"), window_.saveState(layoutVersion));
}

void WindowLayout::toggleDocks() {
    QStringList inSight;
    for (auto* dock : window_.findChildren<QDockWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
        if (dock->isHidden() || dock->isFloating())
            continue;
        inSight << dock->objectName();
    }
    const bool collapses = !inSight.isEmpty();
    // Where each was put away by itself, all come back.
    const bool isForAll = !collapses && hidden_.isEmpty();
    for (auto* dock : window_.findChildren<QDockWidget*>(QString(), Qt::FindDirectChildrenOnly))
        if (isForAll || (collapses ? inSight : hidden_).contains(dock->objectName()))
            dock->setVisible(!collapses);
    hidden_ = collapses ? inSight : QStringList();
}

} // namespace smat::gui

#include "moc_WindowLayout.cpp"
