#pragma once

#include <optional>

#include <QObject>
#include <QPointF>
#include <QPointer>

#include "gui/plot/CrosshairOverlay.h"

class QKeyEvent;
class QMouseEvent;
class QPainter;

namespace smat::gui {

class PlotSurface;

/// The mouse and the keys of every plot: the wheel zooms at the cursor, a drag of the left button
/// zooms into its rectangle, a drag of the right button pans, a click of it opens a menu, a double
/// click or Home shows all, Backspace takes a zoom back, + and - zoom, the arrows pan. A crosshair
/// follows the cursor on a sheet of its own, so that the plot is not drawn anew.
class PlotNavigator : public QObject {
    Q_OBJECT

  public:
    /// The surface goes after its navigator.
    explicit PlotNavigator(PlotSurface& surface);
    ~PlotNavigator() override;

    void setCrosshairVisible(bool visible);
    bool handleKey(const QKeyEvent& event);

  signals:
    void readoutChanged(const QString& text);
    void menuRequested(const QPoint& globalPosition);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    bool handle(QEvent& event);
    void press(const QMouseEvent& event);
    void move(const QMouseEvent& event);
    void release(const QMouseEvent& event);
    void paint(QPainter& painter) const;

    PlotSurface& surface_;
    QPointer<QWidget> sheet_;
    QPointer<CrosshairOverlay> overlay_;
    bool crosshair_ = true;
    bool panned_ = false;
    std::optional<QPointF> cursor_, dragStart_, panStart_, pressedAt_;
};

} // namespace smat::gui
