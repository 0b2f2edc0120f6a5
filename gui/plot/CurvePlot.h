#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "gui/plot/PlotData.h"
#include "gui/plot/PlotSurface.h"
#include "gui/widgets/Theme.h"

class QVariant;

namespace smat::gui {

class CurveItem;

/// What plots of curves do alike in all coordinates: curves that are shown and hidden, their bands,
/// and what is read of them under the mouse.
class CurvePlot : public PlotSurface {
  public:
    const PlotStyle& look() const override { return style_; }
    int curveCount() const override { return static_cast<int>(items_.size()); }
    void setCurveVisible(int curve, bool visible) override;
    bool isCurveVisible(int curve) const override;
    bool hasErrors() const override;
    void setErrorBandsVisible(bool visible) override;

  protected:
    explicit CurvePlot(const PlotStyle& style) : style_(style) {}

    virtual const std::vector<Curve>& curves() const = 0;
    virtual void redraw() = 0;

    /// Takes the item of the next curve, which the plot of Qwt owns: it gets its pen, and its band.
    void adopt(CurveItem* item);
    void forgetItems() { items_.clear(); }
    /// Pens and names in the colours of another look.
    void dressItems();
    /// Shows the other one, or hides it.
    void toggle(const CurveItem* item);
    std::vector<bool> shownCurves() const;
    /// As many as there are.
    void showCurves(const std::vector<bool>& shown);
    /// Shows the curves and the bands that another plot of the same curves shows.
    void showAsIn(const CurvePlot& other);

    /// What the visible curves' samples next to `at` warn of, each sentence once.
    QStringList warningsAt(double at, double period) const;
    /// "   idle: 12.5   full power: 30.1" of the visible curves, `period` 0 for an axis that does
    /// not repeat.
    QString readoutsAt(double at, double period) const;
    /// A dot on each visible curve, where `place` has one for its value, and a box beside the
    /// cursor with `heading`, all values and what they warn of.
    void paintReadouts(QPainter& painter, const QPointF& cursor, const QString& heading, double at,
                       double period,
                       const std::function<std::optional<QPointF>(double value)>& place) const;

    PlotStyle style_;

  private:
    QPen penOf(std::size_t curve) const;

    std::vector<CurveItem*> items_;
    bool errorBands_ = true;
};

} // namespace smat::gui
