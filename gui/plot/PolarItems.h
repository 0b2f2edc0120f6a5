#pragma once

#include <array>
#include <utility>
#include <vector>

#include <QwtPolarCurve>
#include <QwtPolarItem>
#include <QwtRoundScaleDraw>

#include "gui/plot/CurveDrawing.h"
#include "gui/plot/CurveItem.h"
#include "gui/plot/PlotLook.h"
#include "gui/widgets/Theme.h"

namespace smat::gui {

/// A sample as it is drawn: the radius on the scale of the plot, and the ends of its error.
struct PolarSample {
    double angle_deg = 0.0;
    double radius = 0.0; ///< not finite for a gap
    double low = 0.0, high = 0.0;
    bool isHollow = false; ///< warns of something
};

/// Draws runs of finite samples one by one, so that a missing point leaves a gap; a dot for a
/// single one, and a band where the curve has errors or is a layer of a stack. A radius below the
/// scale is drawn in the middle.
class GappedPolarCurve : public CurveItemOf<QwtPolarCurve> {
  public:
    using QwtPolarCurve::draw;
    enum class Band { none, error, layer };
    GappedPolarCurve(const QString& title, std::vector<PolarSample> samples, Band band);

    void draw(QPainter* painter, const QwtScaleMap& azimuthMap, const QwtScaleMap& radialMap,
              const QPointF& pole, double radius, const QRectF& canvasRect) const override;

  private:
    /// How near to the middle lines and bands of a run come, and how far out the line goes, in
    /// pixels of the canvas.
    std::pair<double, double> radiiOf(const SampleRun& run, const QwtScaleMap& radialMap,
                                      bool withBand) const;
    /// Where on the canvas each sample lies from the middle, at the distance 1.
    const std::vector<QPointF>& directionsFor(const QwtScaleMap& azimuthMap) const;

    std::vector<PolarSample> samples_;
    Band band_;
    mutable std::array<double, 4> turn_{}; ///< ends of the map that the directions are of
    mutable std::vector<QPointF> directions_;
};

/// The numbers along the radius: where circles are closer than their numbers are wide every second
/// one has none, or every third; the outermost always has one.
class RadiusLabels : public NumberLabels {
  public:
    void draw(QPainter* painter, const QPalette& palette) const override;

  protected:
    void drawLabel(QPainter* painter, double value) const override;

  private:
    mutable QList<double> numbered_;
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
