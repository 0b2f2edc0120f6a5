#pragma once

#include <QwtPlot>

#include "gui/widgets/PaletteWatch.h"
#include "irsg/image/Histogram.h"

class QwtPlotHistogram;
class QwtPlotMarker;

namespace smat::gui {

/// A histogram with its quantity and unit on the axis, linear or logarithmic in either direction,
/// and the limits of the colours as lines.
class HistogramPlot : public QwtPlot {
    Q_OBJECT

  public:
    explicit HistogramPlot(QWidget* parent = nullptr);
    ~HistogramPlot() override;

    /// `title` is the quantity with its unit.
    void setHistogram(const irsg::Histogram& histogram, const QString& title);
    const irsg::Histogram& histogram() const { return histogram_; }
    void setLogarithmicCounts(bool on);
    void setLimits(const irsg::DisplayLimits& limits);

    QSize sizeHint() const override { return {420, 180}; }
    QSize minimumSizeHint() const override { return {200, 120}; }

  protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

  private:
    void draw();
    void dress();
    /// As many numbers below the values as stand beside each other in the width that there is.
    void fitTicks();

    irsg::Histogram histogram_;
    QString title_;
    bool logarithmicCounts_ = true;
    QwtPlotHistogram* bars_ = nullptr;
    PaletteWatch palette_;
    QwtPlotMarker* low_ = nullptr;
    QwtPlotMarker* high_ = nullptr;
};

} // namespace smat::gui
