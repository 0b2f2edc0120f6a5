#include "gui/widgets/BackgroundPool.h"

#include <QCoreApplication>

namespace smat::gui {
namespace {

/// More than there are cores: a few large models that are being read leave a thread for the colours
/// of an image.
constexpr int threads = 8;

QThreadPool* pool = nullptr;

void endPool() {
    delete pool; // waits for what runs
    pool = nullptr;
}

} // namespace

QThreadPool& backgroundPool() {
    if (pool == nullptr) {
        pool = new QThreadPool;
        pool->setMaxThreadCount(threads);
        qAddPostRoutine(endPool);
    }
    return *pool;
}

} // namespace smat::gui
