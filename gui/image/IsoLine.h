#pragma once

#include <functional>
#include <vector>

#include <QLineF>
#include <QString>

class QPainter;

namespace smat::gui {

/// A line of equal value in image pixels, in pieces, and its level in words.
struct IsoLine {
    QString label;
    std::vector<QLineF> parts = {};
    bool operator==(const IsoLine&) const = default;
};

/// Draws them with their labels, thin over a seam, so that they are seen on every colour. `place`
/// turns image pixels into the painter's.
void drawIsoLines(QPainter& painter, const std::vector<IsoLine>& lines,
                  const std::function<QPointF(const QPointF&)>& place);

} // namespace smat::gui
