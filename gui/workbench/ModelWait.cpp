#include "gui/workbench/ModelWait.h"

namespace smat::gui {
namespace {

constexpr int tick_ms = 100, silent_ms = 250;

} // namespace

ModelWait::ModelWait(QObject* parent) : QObject(parent) {
    tick_.setInterval(tick_ms);
    connect(&tick_, &QTimer::timeout, this, &ModelWait::tell);
}

void ModelWait::beginWaiting(const QString& names) {
    names_ = names;
    clock_.start();
    tick_.start();
}

void ModelWait::endWaiting() {
    tick_.stop();
    emit waiting({});
}

void ModelWait::cancel() {
    if (!isBusy())
        return;
    letGo();
    endWaiting();
    emit cancelled(names_);
}

void ModelWait::tell() {
    if (clock_.elapsed() < silent_ms)
        return;
    emit waiting(tr("Reading %1, %2 s")
                     .arg(names_)
                     .arg(static_cast<double>(clock_.elapsed()) / 1000.0, 0, 'f', 1));
}

} // namespace smat::gui

#include "moc_ModelWait.cpp"
