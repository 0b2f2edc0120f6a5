#pragma once

#include <functional>
#include <optional>
#include <vector>

#include <QPolygonF>
#include <QRectF>

class QPainter;

namespace smat::gui {

/// Lines of many points, drawn as they would be with all of their points but in the time that the
/// pixels take.

/// Width of a column of the device below which points cannot be told apart, in units of the
/// painter; 0 for devices that are scaled later (SVG, PDF): there every point counts.
double finestColumn(const QPainter& painter);

/// The same line with at most four points in each column of `columnWidth`: the first, the lowest,
/// the highest and the last, in their order. Keeps every point where `columnWidth` is 0 and where
/// the line turns back.
QPolygonF thinned(const QPolygonF& line, double columnWidth);

/// The parts of a line inside a rectangle; ends lie on its border.
std::vector<QPolygonF> clipped(const QPolygonF& line, const QRectF& area);

/// Draws a line with the painter's pen. On a screen it is cut into short pieces that overlap: the
/// time that one long restless line takes to fill grows faster than its length.
void drawLine(QPainter& painter, const QPolygonF& line);

/// Index ranges [first, last] of samples that can be drawn, without the gaps between them.
struct SampleRun {
    int first = 0, last = 0;
};
std::vector<SampleRun> runsOf(int count, const std::function<bool(int)>& drawable);

/// Of an axis that only grows, or only falls: the samples of a run that lie between two values, and
/// one more at either end, whose line reaches in. The whole run where the axis turns back.
SampleRun visiblePart(const std::vector<double>& axis, const SampleRun& run, double low,
                      double high);

} // namespace smat::gui
