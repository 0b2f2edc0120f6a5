#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <QwtPointPolar>
#include <QwtPolarPlot>

#include "gui/plot/CurvePlot.h"
#include "gui/plot/ViewHistory.h"

class QwtPolarGrid;

namespace smat::gui {

class PlotNavigator;

enum class RadiusScale {
    linear,
    decibel ///< 10 log10 of the value over the largest one; values that are not positive are gaps
};

/// Curves around a model: 0 degrees (the nose) at the top, a grid of 30 degrees, the direction in
/// which the angle grows written beside it. A curve that goes round is closed. The mouse as
/// PlotNavigator says, and a click on the legend hides a curve.
class PolarPlot : public QwtPolarPlot, public CurvePlot {
    Q_OBJECT

  public:
    /// What is seen, as Qwt keeps it.
    struct View {
        double factor = 1.0;
        QwtPointPolar middle;
        std::optional<Interval> limits; ///< where they were typed
        bool operator==(const View& other) const {
            return factor == other.factor && middle == other.middle && limits == other.limits;
        }
    };

    explicit PolarPlot(const PlotStyle& style, QWidget* parent = nullptr);
    ~PolarPlot() override;
    void setLook(const PlotStyle& style);

    /// LogicError for a curve whose x and y (and errors, where it has any) differ in length.
    void setData(PolarData data);
    /// As it is shown (DisplayUnits), and as it was given.
    const PolarData& data() const { return data_; }
    const PolarData& stored() const { return stored_; }
    /// Whether the radius can be in dB: its values are not already.
    bool canBeDecibel() const { return data_.radiusTitle == stored_.radiusTitle; }
    void setRadiusScale(RadiusScale scale);
    RadiusScale radiusScale() const { return radiusScale_; }
    /// Where the radius begins, in the middle, and where it ends, in the unit of the values or dB;
    /// nothing for limits chosen by the data. What is below is drawn in the middle, what is above
    /// not at all.
    void setRadiusLimits(const std::optional<Interval>& limits);
    /// Those in effect.
    Interval radiusLimits() const;

    /// Samples that a decibel radius cannot show.
    int samplesLeftOut() const;
    /// Where an angle and a value lie on the canvas.
    QPointF canvasPoint(double angle_deg, double value) const;
    PlotNavigator& navigator() { return *navigator_; }
    PolarPlot* makePrintCopy() const;

    QWidget* widget() override { return this; }
    QWidget* sheet() const override;
    /// All of the circle is the most that is shown.
    void zoomAt(const QPointF& point, double factor) override;
    void zoomTo(const QRectF& part) override;
    void panBy(const QPointF& offset) override;
    void resetView() override;
    void rememberView() override;
    bool canUndoZoom() const override { return !history_.empty(); }
    void undoZoom() override;
    QString readoutAt(const QPointF& canvasPoint) const override;
    void paintCrosshair(QPainter& painter, const QPointF& point) const override;

  signals:
    void viewChanged();
    void readoutChanged(const QString& text);

  protected:
    const std::vector<Curve>& curves() const override { return data_.curves; }
    void redraw() override { replot(); }
    void drawCanvas(QPainter* painter, const QRectF& canvasRect) const override;
    void keyPressEvent(QKeyEvent* event) override;

  private:
    void applyLook();
    void rebuild();
    void present(PolarData data);
    void setRadiusAxis();
    void addCurve(std::size_t index);
    void showWhole();
    double radiusOf(double value) const;
    double angleAt(const QPointF& canvasPoint) const;
    void placePole(const QPointF& pole, double factor);

    PolarData stored_, data_;
    std::vector<Curve> drawn_; ///< those of the data, straight between their samples
    RadiusScale radiusScale_ = RadiusScale::linear;
    std::optional<Interval> limits_;
    double largest_ = 1.0;
    std::unique_ptr<QwtPolarItem> notes_;
    QwtPolarGrid* grid_ = nullptr;
    std::unique_ptr<PlotNavigator> navigator_;
    ViewHistory<View> history_;
};

} // namespace smat::gui
