#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <QwtPolarPlot>

#include "gui/Theme.h"
#include "gui/plot/PlotData.h"

namespace smat::gui {

class CrosshairOverlay;

enum class RadiusScale {
    linear,
    decibel ///< 10 log10 of the value over the largest one; values that are not positive are gaps
};

/// Curves around a model: 0 degrees (the nose) at the top, a grid of 30 degrees, the direction in
/// which the angle grows written beside it. A curve that goes round is closed. The wheel zooms at
/// the cursor, the right button pans, a double click shows all, a click on the legend hides a
/// curve.
class PolarPlot : public QwtPolarPlot {
    Q_OBJECT

  public:
    explicit PolarPlot(const PlotStyle& style, QWidget* parent = nullptr);
    ~PolarPlot() override;

    /// LogicError for a curve whose x and y differ in length.
    void setData(PolarData data);
    const PolarData& data() const { return data_; }
    void setRadiusScale(RadiusScale scale);
    RadiusScale radiusScale() const { return radiusScale_; }
    void setCurveVisible(int curve, bool visible);
    bool isCurveVisible(int curve) const;
    void resetView();

    /// Samples that a decibel radius cannot show.
    int samplesLeftOut() const;
    /// Where an angle and a value lie on the canvas.
    QPointF canvasPoint(double angle_deg, double value) const;
    QString readoutAt(const QPointF& canvasPoint) const;
    PolarPlot* makePaperTwin() const;

  signals:
    void readoutChanged(const QString& text);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void rebuildCurves();
    double radiusOf(double value) const;
    double angleAt(const QPointF& canvasPoint) const;
    void placePole(const QPointF& pole, double factor);
    void zoomAt(const QPointF& cursor, double factor);
    void panBy(const QPointF& offset);
    bool handleMouse(QEvent* event);
    void paintOverlay(QPainter& painter) const;

    PlotStyle style_;
    PolarData data_;
    RadiusScale radiusScale_ = RadiusScale::linear;
    double largest_ = 1.0;
    std::vector<QwtPolarItem*> curves_;
    std::unique_ptr<QwtPolarItem> notes_;
    CrosshairOverlay* overlay_ = nullptr;
    std::optional<QPointF> cursor_, panStart_;
};

} // namespace smat::gui
