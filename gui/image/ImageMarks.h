#pragma once

#include <functional>
#include <vector>

#include <QLine>
#include <QPoint>
#include <QSize>

class QPainter;

namespace smat::gui {

/// Turns image pixels into the painter's.
using ImagePlace = std::function<QPointF(const QPointF&)>;

/// Calls `draw` with the pen of a wide seam and with that of a mark, so that what it draws is seen
/// on every colour.
void drawMarked(QPainter& painter, const std::function<void()>& draw);

/// Rings around pixels with their numbers, from 1.
void drawSpots(QPainter& painter, const std::vector<QPoint>& spots, const ImagePlace& place);

/// From the middle of one pixel to that of another; of one pixel its row and its column through an
/// image of this size.
void drawProfileLine(QPainter& painter, const QLine& line, const QSize& image,
                     const ImagePlace& place);

} // namespace smat::gui
