#include "gui/view/ViewOverlay.h"

namespace smat::gui {

ViewOverlay::ViewOverlay(QWidget* view, std::function<ViewHud()> seen)
    : CrosshairOverlay(view,
                       [this](QPainter& painter) {
                           painted_ = hud();
                           painted_->paint(painter);
                       }),
      seen_(std::move(seen)) {}

void ViewOverlay::setViewAxesVisible(bool on) {
    viewAxes_ = on;
    refresh();
}

void ViewOverlay::setModelAxesVisible(bool on) {
    modelAxes_ = on;
    refresh();
}

void ViewOverlay::setSunVectorVisible(bool on) {
    sunVector_ = on;
    refresh();
}

void ViewOverlay::setReadout(const QString& words) {
    if (words == readout_)
        return;
    readout_ = words;
    refresh();
}

void ViewOverlay::refresh() {
    if (painted_ != hud())
        update();
}

ViewHud ViewOverlay::hud() const {
    ViewHud hud = seen_();
    hud.viewAxes = viewAxes_;
    hud.modelAxes = modelAxes_;
    hud.sunVector = sunVector_;
    hud.readout = readout_;
    return hud;
}

} // namespace smat::gui
