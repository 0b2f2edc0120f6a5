#pragma once

#include <QPointF>
#include <QRectF>
#include <QString>

#include "gui/widgets/Theme.h"

class QPainter;
class QWidget;

namespace smat::gui {

/// What every plot can do whatever its coordinates: the mouse, the toolbar and the menu ask for
/// this alone. Points and lengths are in pixels of the canvas.
class PlotSurface {
  public:
    virtual ~PlotSurface() = default;

    virtual QWidget* widget() = 0;
    /// The canvas: what the mouse works on.
    virtual QWidget* sheet() const = 0;
    virtual const PlotStyle& look() const = 0;

    /// Shows `factor` of what is seen, about a point that stays where it is; more than all where
    /// the coordinates allow it.
    virtual void zoomAt(const QPointF& point, double factor) = 0;
    virtual void zoomTo(const QRectF& part) = 0;
    virtual void panBy(const QPointF& offset) = 0;
    virtual void resetView() = 0;
    /// Keeps the view for undoZoom; the mouse asks for it before it changes anything.
    virtual void rememberView() = 0;
    virtual bool canUndoZoom() const = 0;
    virtual void undoZoom() = 0;

    virtual int curveCount() const = 0;
    virtual void setCurveVisible(int curve, bool visible) = 0;
    virtual bool isCurveVisible(int curve) const = 0;
    virtual bool hasErrors() const = 0;
    virtual void setErrorBandsVisible(bool visible) = 0;

    /// Every visible curve under a point; empty outside.
    virtual QString readoutAt(const QPointF& point) const = 0;
    virtual void paintCrosshair(QPainter& painter, const QPointF& point) const = 0;
};

} // namespace smat::gui
