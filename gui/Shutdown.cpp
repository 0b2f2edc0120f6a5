#include "gui/Shutdown.h"

#include <iostream>

#include <QCoreApplication>
#include <QDeadlineTimer>
#include <QThread>
#include <unistd.h>

#include "gui/widgets/BackgroundPool.h"
#include "gui/workbench/Workbench.h"

namespace smat::gui {
namespace {

constexpr int patience_ms = 300, pause_ms = 5;

} // namespace

void shutDown(Workbench& workbench, int code) {
    backgroundPool().clear();
    workbench.jobs().cancelAll();
    const auto rests = [&] {
        return backgroundPool().activeThreadCount() == 0 && !workbench.jobs().isWorking();
    };
    for (const QDeadlineTimer end(patience_ms); !rests() && !end.hasExpired();) {
        QThread::msleep(pause_ms);
        QCoreApplication::processEvents();
    }
    if (rests())
        return;
    // What destructors would have kept.
    if (workbench.database().isDirty())
        workbench.database().writeRecoveryNow();
    std::cout.flush();
    std::cerr.flush();
    // No destructor of a library may run beside threads that use it.
    _exit(code);
}

} // namespace smat::gui
