#pragma once

#include <vector>

#include <QwtGraphic>
#include <QwtPlotCurve>

#include "gui/plot/CurveDrawing.h"
#include "gui/plot/CurveItem.h"
#include "gui/plot/PlotData.h"

namespace smat::gui {

/// Runs of samples of a curve that are numbers.
std::vector<SampleRun> numbersOf(const Curve& curve);

/// Draws the samples of a Curve: nothing for missing points, a dot for one between gaps, a band
/// where the curve has errors, a hollow point where it warns of something.
class SampledCurve : public CurveItemOf<QwtPlotCurve> {
  public:
    /// Keeps a reference to `curve`, which outlives it.
    explicit SampledCurve(const Curve& curve);

    void drawSeries(QPainter* painter, const QwtScaleMap& xMap, const QwtScaleMap& yMap,
                    const QRectF& canvasRect, int from, int to) const override;
    /// A dot where there are dots alone, else a line.
    QwtGraphic legendIcon(int index, const QSizeF& size) const override;

  private:
    void drawBand(QPainter& painter, const QwtScaleMap& xMap, const QwtScaleMap& yMap,
                  const QRectF& area, int from, int to, double column) const;

    const Curve& curve_;
};

} // namespace smat::gui
