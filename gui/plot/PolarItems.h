#pragma once

#include <vector>

#include <QwtPolarCurve>
#include <QwtPolarItem>
#include <QwtRoundScaleDraw>

#include "gui/Theme.h"

namespace smat::gui {

/// A sample as it is drawn: the radius on the scale of the plot, and the ends of its error.
struct PolarSample {
    double angle_deg = 0.0;
    double radius = 0.0; ///< not finite for a gap
    double low = 0.0, high = 0.0;
};

/// Draws runs of finite samples one by one, so that a missing point leaves a gap; a dot for a
/// single one, and a band where the curve has errors. A radius below the scale is drawn in the
/// middle.
class GappedPolarCurve : public QwtPolarCurve {
  public:
    using QwtPolarCurve::draw;
    GappedPolarCurve(const QString& title, std::vector<PolarSample> samples, bool hasBand);

    void setBandVisible(bool visible) { bandVisible_ = visible; }
    void draw(QPainter* painter, const QwtScaleMap& azimuthMap, const QwtScaleMap& radialMap,
              const QPointF& pole, double radius, const QRectF& canvasRect) const override;

  private:
    std::vector<PolarSample> samples_;
    bool hasBand_, bandVisible_ = true;
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
