#pragma once

#include <optional>

#include <QwtPlot>
#include <QwtScaleMap>

#include "gui/database/Nodes.h"
#include "gui/plot/PlotData.h"
#include "gui/widgets/PaletteWatch.h"

class QwtPlotCurve;
class QwtPlotGrid;
class QwtPlotMarker;

namespace smat::gui {

/// The nodes of a table as a curve that is edited in place: a drag moves a node within the rules
/// (with Shift held its place on the axis stays), a double click adds one, Delete removes the
/// selected one, arrow keys step between nodes and move them. Other curves stand behind it.
class NodePlot : public QwtPlot {
    Q_OBJECT

  public:
    explicit NodePlot(QWidget* parent = nullptr);
    ~NodePlot() override;

    void setRules(NodeRules rules);
    void setNodes(const Nodes& nodes);
    const Nodes& nodes() const { return nodes_; }
    /// Curves to compare with, thin and behind; the name stands in the legend.
    void setBackdrop(std::vector<Curve> curves);
    /// Colour of the edited curve, as a curve of the plot style; the backdrop takes its own.
    void setCurveColors(int edited, std::vector<int> backdrop);
    /// The part of the axes that is always seen; more where the nodes need it.
    void setLeastView(std::optional<Interval> x, std::optional<Interval> y);
    void setReadOnly(bool readOnly) { readOnly_ = readOnly; }
    void selectNode(int node);
    int selectedNode() const { return selected_; }
    /// Where a node stands in the canvas, pixels.
    QPointF positionOf(int node) const;

  signals:
    /// By the user: the node at `x` moved. What follows up to dragEnded belongs together.
    void edited(const smat::gui::Nodes& nodes, double x);
    void added(const smat::gui::Nodes& nodes, double x);
    void removed(const smat::gui::Nodes& nodes, double x);
    void dragEnded();
    void nodeSelected(int node);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

  private:
    void dress();
    void drawNodes();
    void fitAxes();
    void growAxes();
    int nodeNear(const QPointF& at) const;
    Node underMouse(const QPointF& at) const;
    void move(Node wanted);
    void remove();
    void add(const QPointF& at);
    bool handleMouse(QEvent* event);

    NodeRules rules_;
    Nodes nodes_;
    std::vector<Curve> backdrop_;
    std::vector<int> backdropColors_;
    int editedColor_ = 0;
    std::optional<Interval> leastX_, leastY_;
    bool readOnly_ = false, dragging_ = false;
    QwtScaleMap dragX_, dragY_; ///< from where the drag began: axes that grow pull nothing along
    int selected_ = -1;
    QwtPlotGrid* grid_ = nullptr;
    QwtPlotCurve *line_ = nullptr, *heldBefore_ = nullptr, *heldAfter_ = nullptr, *dots_ = nullptr,
                 *chosen_ = nullptr;
    std::vector<QwtPlotCurve*> behind_;
    QwtPlotMarker* label_ = nullptr;
    PaletteWatch palette_;
};

} // namespace smat::gui
