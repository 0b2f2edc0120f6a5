#pragma once

#include <optional>

#include "gui/plot/CrosshairOverlay.h"
#include "gui/view/ViewHud.h"

namespace smat::gui {

/// The sheet over a view with its frame, axes and words, painted anew where they differ.
class ViewOverlay : public CrosshairOverlay {
  public:
    /// `seen` is asked for all that is not set here.
    ViewOverlay(QWidget* view, std::function<ViewHud()> seen);

    void setViewAxesVisible(bool on);
    void setModelAxesVisible(bool on);
    void setSunVectorVisible(bool on);
    /// Of what is under the mouse.
    void setReadout(const QString& words);
    void refresh();

  private:
    ViewHud hud() const;

    std::function<ViewHud()> seen_;
    bool viewAxes_ = true, modelAxes_ = false, sunVector_ = false;
    QString readout_;
    std::optional<ViewHud> painted_;
};

} // namespace smat::gui
