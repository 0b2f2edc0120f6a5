#pragma once

#include <QwtPolarCurve>
#include <QwtPolarItem>
#include <QwtRoundScaleDraw>

#include "gui/Theme.h"

namespace smat::gui {

/// Draws runs of finite samples one by one, so that a missing point leaves a gap.
class GappedPolarCurve : public QwtPolarCurve {
  public:
    using QwtPolarCurve::draw;
    using QwtPolarCurve::QwtPolarCurve;
    void draw(QPainter* painter, const QwtScaleMap& azimuthMap, const QwtScaleMap& radialMap,
              const QPointF& pole, double radius, const QRectF& canvasRect) const override;
};

/// "0°" to "330°"; 360 is 0.
class AngleLabels : public QwtRoundScaleDraw {
  public:
    QwtText label(double value) const override;
};

/// The words in the corners of the canvas, with an arrow that turns the way the angle grows, and a
/// heavier circle where the radius is 0 on an axis that begins below.
class PolarNotes : public QwtPolarItem {
  public:
    PolarNotes(const PlotStyle& style, QString direction, bool clockwise, QString radius);
    void draw(QPainter* painter, const QwtScaleMap& azimuthMap, const QwtScaleMap& radialMap,
              const QPointF& pole, double radius, const QRectF& canvasRect) const override;
    /// Keeps room below the circle for the words.
    int marginHint() const override;
    /// Below every radius: Qwt clips to the circle what may reach beyond it.
    QwtInterval boundingInterval(int scale) const override;

  private:
    void drawTurnArrow(QPainter& painter, const QPointF& centre, double size) const;

    PlotStyle style_;
    QString direction_, radius_;
    bool clockwise_;
};

} // namespace smat::gui
