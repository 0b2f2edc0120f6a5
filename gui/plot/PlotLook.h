#pragma once

#include <QwtLogScaleEngine>
#include <QwtScaleDraw>
#include <QwtText>

#include "gui/widgets/Theme.h"

class QwtLegend;
class QwtPlot;

namespace smat::gui {

/// What all plots look alike in: fonts, colours and spacing.
/// The font of everything that is exported as a picture, that of irsg/image/PictureFont.h, in the
/// size of the window's text.
QFont plotFont(double scale = 1.0, bool bold = false);
/// A title with a smaller line of conditions below it, where there are any.
QwtText plotTitle(const QString& text, const QString& conditions, const PlotStyle& style);
QwtText axisText(const QString& text, const PlotStyle& style);
/// A number as files have it, without separators of thousands; beyond what is read easily as a
/// power of ten: "10⁻⁵", "2·10⁷".
QString axisNumber(double value);
class NumberLabels : public QwtScaleDraw {
  public:
    QwtText label(double value) const override;
};
/// Ticks at 1, 2 and 5 of each decade where there are few decades, else at powers of ten.
class ReadableLogScale : public QwtLogScaleEngine {
  public:
    QwtScaleDiv divideScale(double x1, double x2, int maxMajorSteps, int maxMinorSteps,
                            double stepSize = 0.0) const override;
};
void dressPlot(QwtPlot& plot, const PlotStyle& style);
void dressLegend(QwtLegend& legend, const PlotStyle& style);

} // namespace smat::gui
