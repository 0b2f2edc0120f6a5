#pragma once

#include <functional>
#include <optional>
#include <vector>

#include <QPolygonF>
#include <QRectF>

class QColor;
class QPainter;
class QSize;

namespace smat::gui {

/// Lines of many points, drawn as they would be with all of their points but in the time that the
/// pixels take.

/// Width of a column of the device below which points cannot be told apart, in units of the
/// painter; 0 for devices that are scaled later (SVG, PDF): there every point counts.
double finestColumn(const QPainter& painter);

/// Which points of a line are enough to draw it: at most four of each column of `columnWidth`, the
/// lowest and the highest in their order, and the first and the last where the line comes from
/// further off than the next column, or goes there. Between neighbours nothing is lost by leaving
/// them out: what joins two columns passes every height that lies between. Every point where
/// `columnWidth` is 0.
std::vector<qsizetype> pointsOf(const QPolygonF& line, double columnWidth);

/// The points of a line that are enough for an edge of a band: of each column of `columnWidth` the
/// lowest alone, or the highest, and both ends of the line. Every point where `columnWidth` is 0.
enum class Edge { lowest, highest };
std::vector<qsizetype> pointsOfEdge(const QPolygonF& line, double columnWidth, Edge edge);

/// A line of these points alone.
QPolygonF chosen(const QPolygonF& line, const std::vector<qsizetype>& points);

/// A part of a segment, as parameters from 0 to 1.
struct Part {
    double from = 0.0, to = 1.0;
};
/// The part that lies inside a rectangle.
std::optional<Part> insideOf(const QPointF& a, const QPointF& b, const QRectF& area);

/// The parts of a line inside a rectangle; ends lie on its border.
std::vector<QPolygonF> clipped(const QPolygonF& line, const QRectF& area);

/// Draws what lies in `area` of a line with the painter's pen, which is solid. In a picture as
/// LineRaster does, on other devices (SVG, PDF) with all of its points, cut at the area.
void drawLine(QPainter& painter, const QPolygonF& line, const QRectF& area);

/// Fills what lies in `area` of the band between two edges that are not empty with the painter's
/// brush, which is solid. In a picture as AreaRaster does, on other devices as one outline with all
/// of its points.
void drawBand(QPainter& painter, const QPolygonF& upper, const QPolygonF& lower,
              const QRectF& area);

/// Draws hollow points in `area` with the painter's pen, in the order of the line that they lie on;
/// one that would hide most of the last is left out.
void drawHollowPoints(QPainter& painter, const QPolygonF& points, const QColor& fill,
                      const QRectF& area);

/// Lets `draw` draw on a sheet of `size` in `background` at the painter's finest, and puts it at
/// the painter's origin: in such a picture drawLine is at its fastest. A painter of a picture or of
/// paper is handed on as it is.
void drawOnPicture(QPainter& painter, const QSize& size, const QColor& background,
                   const std::function<void(QPainter&)>& draw);

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
