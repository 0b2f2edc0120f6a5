#pragma once

#include <QwtText>

#include "gui/Theme.h"

class QwtLegend;
class QwtPlot;

namespace smat::gui {

/// What all plots look alike in: fonts, colours and spacing.
QFont plotFont(double scale = 1.0, bool bold = false);
QwtText plotTitle(const QString& text, const PlotStyle& style);
QwtText axisText(const QString& text, const PlotStyle& style);
void dressPlot(QwtPlot& plot, const PlotStyle& style);
void dressLegend(QwtLegend& legend, const PlotStyle& style);

} // namespace smat::gui
