#pragma once

#include <optional>
#include <vector>

#include <QwtPlot>

#include "gui/Theme.h"
#include "gui/plot/PlotData.h"

class QwtPlotCurve;
class QwtPlotGrid;

namespace smat::gui {

class CrosshairOverlay;

/// Curves over a linear or logarithmic axis. The wheel zooms at the cursor, a drag of the left
/// button zooms into its rectangle, a drag of the right button pans, a double click shows all,
/// Backspace takes a zoom back, a click on the legend hides a curve. A crosshair reads every curve.
class CartesianPlot : public QwtPlot {
    Q_OBJECT

  public:
    /// The visible part.
    struct View {
        Interval x, y;
    };

    explicit CartesianPlot(const PlotStyle& style, QWidget* parent = nullptr);
    ~CartesianPlot() override;

    /// LogicError for a curve whose x and y differ in length.
    void setData(PlotData data);
    const PlotData& data() const { return data_; }
    /// `axis` is QwtPlot::xBottom or QwtPlot::yLeft.
    void setLogarithmic(QwtPlot::Axis axis, bool on);
    bool isLogarithmic(QwtPlot::Axis axis) const;
    void setCurveVisible(int curve, bool visible);
    bool isCurveVisible(int curve) const;

    View view() const;
    void setView(const View& view);
    void resetView();
    void undoZoom();

    /// Every visible curve at the x under a point of the canvas; empty outside.
    QString readoutAt(const QPointF& canvasPoint) const;
    /// The same picture on paper: same data, part and hidden curves.
    CartesianPlot* makePaperTwin() const;

  signals:
    void viewChanged();
    void readoutChanged(const QString& text);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

  private:
    void applyAxes();
    View fullView() const;
    void rememberView();
    void zoomTo(const QRectF& canvasRect);
    void onLegendClicked(const QVariant& item, int index);
    void paintOverlay(QPainter& painter) const;
    bool handleMouse(QEvent* event);

    PlotStyle style_;
    PlotData data_;
    std::vector<QwtPlotCurve*> curves_;
    QwtPlotGrid* grid_ = nullptr;
    CrosshairOverlay* overlay_ = nullptr;
    std::vector<View> pastViews_;
    std::optional<QPointF> cursor_, dragStart_, panStart_;
};

} // namespace smat::gui
