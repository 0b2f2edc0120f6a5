#pragma once

#include <memory>
#include <vector>

#include <QwtPlot>

#include "gui/plot/CurvePlot.h"
#include "gui/plot/ViewHistory.h"

class QwtPlotGrid;
class QwtPlotMarker;

namespace smat::gui {

class PlotNavigator;

/// Curves over a linear or logarithmic axis; the mouse as PlotNavigator says, and a click on the
/// legend hides a curve. Logarithmic axes go with positive values alone.
class CartesianPlot : public QwtPlot, public CurvePlot {
    Q_OBJECT

  public:
    /// The visible part.
    struct View {
        Interval x, y;
        bool operator==(const View&) const = default;
    };

    explicit CartesianPlot(const PlotStyle& style, QWidget* parent = nullptr);
    ~CartesianPlot() override;
    void setLook(const PlotStyle& style);

    /// LogicError for a curve whose x and y (and errors, where it has any) differ in length.
    void setData(PlotData data);
    /// As it is shown (DisplayUnits), and as it was given.
    const PlotData& data() const { return data_; }
    const PlotData& stored() const { return stored_; }
    /// `axis` is QwtPlot::xBottom or QwtPlot::yLeft.
    void setLogarithmic(QwtPlot::Axis axis, bool on);
    bool isLogarithmic(QwtPlot::Axis axis) const;

    View view() const;
    void setView(const View& view);
    PlotNavigator& navigator() { return *navigator_; }
    /// The same picture on paper: same data, part and hidden curves.
    CartesianPlot* makePrintCopy() const;

    QWidget* widget() override { return this; }
    QWidget* sheet() const override;
    void zoomAt(const QPointF& point, double factor) override;
    /// Nothing happens where an axis could no longer tell its ends apart.
    void zoomTo(const QRectF& canvasRect) override;
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
    void drawCanvas(QPainter* painter) override;
    void keyPressEvent(QKeyEvent* event) override;

  private:
    void applyLook();
    void applyAxes();
    void addMarks();
    void dressMarks();
    void present(PlotData data);
    View fullView() const;
    QRectF seenRect() const;

    PlotData stored_, data_;
    std::vector<Curve> drawn_; ///< those of the data, straight between their samples
    QwtPlotGrid* grid_ = nullptr;
    std::vector<QwtPlotMarker*> marks_; ///< of the data
    std::unique_ptr<PlotNavigator> navigator_;
    ViewHistory<View> history_;
};

} // namespace smat::gui
