#include "gui/plot/CurveDrawing.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <QImage>
#include <QPaintEngine>
#include <QPainter>
#include <QwtClipper>

#include "gui/plot/LineRaster.h"

namespace smat::gui {
namespace {

/// Gathers the points of one column.
class Column {
  public:
    Column(QPolygonF& out, double width) : out_(out), width_(width) {}

    void add(const QPointF& point) {
        const double column = std::floor(point.x() / width_);
        if (count_ > 0 && column != column_) {
            const bool next = std::abs(column - column_) == 1.0;
            flush(next);
            fromNext_ = next;
        }
        column_ = column;
        if (count_ == 0) {
            first_ = lowestPoint_ = highestPoint_ = point;
            lowest_ = highest_ = 0;
        } else if (point.y() < lowestPoint_.y()) {
            lowest_ = count_;
            lowestPoint_ = point;
        } else if (point.y() > highestPoint_.y()) {
            highest_ = count_;
            highestPoint_ = point;
        }
        last_ = point;
        ++count_;
    }
    void flush(bool toNext) {
        if (count_ == 0)
            return;
        const int early = std::min(lowest_, highest_), late = std::max(lowest_, highest_);
        if (early > 0 && !fromNext_)
            out_ << first_;
        out_ << (early == lowest_ ? lowestPoint_ : highestPoint_);
        if (late > early)
            out_ << (late == lowest_ ? lowestPoint_ : highestPoint_);
        if (late < count_ - 1 && !toNext)
            out_ << last_;
        count_ = 0;
    }

  private:
    QPolygonF& out_;
    double width_, column_ = 0.0;
    int count_ = 0, lowest_ = 0, highest_ = 0;
    bool fromNext_ = false; ///< the line comes from the column beside this one
    QPointF first_, last_, lowestPoint_, highestPoint_;
};

/// Where lines can be drawn pixel by pixel: the picture that a painter draws into, if it does so
/// without turning or shearing.
QImage* pictureOf(const QPainter& painter) {
    auto* device = painter.device();
    const QTransform& way = painter.deviceTransform();
    const bool upright = way.type() <= QTransform::TxScale && way.m11() == way.m22();
    if (device == nullptr || device->devType() != QInternal::Image || !upright)
        return nullptr;
    auto* picture = static_cast<QImage*>(device);
    return LineRaster::canDrawInto(*picture) ? picture : nullptr;
}

} // namespace

std::optional<Part> insideOf(const QPointF& a, const QPointF& b, const QRectF& area) {
    // Liang and Barsky 1984.
    const QPointF d = b - a;
    const std::array<std::array<double, 2>, 4> sides{{{-d.x(), a.x() - area.left()},
                                                      {d.x(), area.right() - a.x()},
                                                      {-d.y(), a.y() - area.top()},
                                                      {d.y(), area.bottom() - a.y()}}};
    Part part;
    for (const auto& [p, q] : sides) {
        if (p == 0.0) {
            if (q < 0.0)
                return std::nullopt;
        } else if (p < 0.0) {
            part.from = std::max(part.from, q / p);
        } else {
            part.to = std::min(part.to, q / p);
        }
    }
    return part.from <= part.to ? std::optional(part) : std::nullopt;
}

double finestColumn(const QPainter& painter) {
    const auto* engine = painter.paintEngine();
    if (engine == nullptr || engine->type() != QPaintEngine::Raster)
        return 0.0;
    const double scale = std::abs(painter.deviceTransform().m11());
    return scale > 0.0 ? 0.5 / scale : 0.0;
}

QPolygonF thinned(const QPolygonF& line, double columnWidth) {
    if (columnWidth <= 0.0)
        return line;
    QPolygonF result;
    result.reserve(line.size());
    Column column(result, columnWidth);
    for (const QPointF& point : line)
        column.add(point);
    column.flush(false);
    return result;
}

std::vector<QPolygonF> clipped(const QPolygonF& line, const QRectF& area) {
    std::vector<QPolygonF> parts;
    QPolygonF current;
    const auto finish = [&] {
        if (current.size() > 1)
            parts.push_back(current);
        current.clear();
    };
    for (qsizetype i = 0; i + 1 < line.size(); ++i) {
        const QPointF& a = line[i];
        const QPointF& b = line[i + 1];
        const auto part = insideOf(a, b, area);
        if (!part) {
            finish();
            continue;
        }
        if (part->from > 0.0)
            finish();
        if (current.isEmpty())
            current << a + (b - a) * part->from;
        current << (part->to < 1.0 ? a + (b - a) * part->to : b);
        if (part->to < 1.0)
            finish();
    }
    finish();
    return parts;
}

void drawLine(QPainter& painter, const QPolygonF& line, const QRectF& area) {
    QImage* picture = pictureOf(painter);
    if (picture == nullptr) {
        for (const QPolygonF& part : clipped(line, area))
            painter.drawPolyline(part);
        return;
    }
    const QTransform toPixels = painter.deviceTransform();
    const QRect seen = toPixels.mapRect(area).toAlignedRect();
    LineRaster raster(*picture, seen, painter.pen().widthF() * toPixels.m11());
    for (qsizetype i = 1; i < line.size(); ++i)
        raster.add(toPixels.map(line[i - 1]), toPixels.map(line[i]));
    raster.paint(painter.pen().color(),
                 painter.hasClipping() ? toPixels.map(painter.clipRegion()) : QRegion(seen));
}

QPolygonF edgeOf(const QPolygonF& line, double columnWidth, Edge edge) {
    if (columnWidth <= 0.0)
        return line;
    QPolygonF result;
    double column = 0.0;
    for (const QPointF& point : line) {
        const double here = std::floor(point.x() / columnWidth);
        if (result.isEmpty() || here != column)
            result << point;
        else if (edge == Edge::lowest ? point.y() < result.back().y()
                                      : point.y() > result.back().y())
            result.back().setY(point.y());
        column = here;
    }
    return result;
}

void drawBand(QPainter& painter, const QPolygonF& upper, const QPolygonF& lower,
              const QRectF& area) {
    // In pieces: what a large polygon takes to fill grows faster than its size.
    const qsizetype piece = finestColumn(painter) > 0.0 ? 64 : upper.size();
    for (qsizetype from = 0; from + 1 < upper.size(); from += piece) {
        const qsizetype count = std::min(piece + 1, upper.size() - from);
        QPolygonF band = upper.mid(from, count);
        const QPolygonF below = lower.mid(from, count);
        band.append(QPolygonF(below.rbegin(), below.rend()));
        painter.drawPolygon(QwtClipper::clippedPolygonF(area, band, true));
    }
}

void drawOnPicture(QPainter& painter, const QSize& size, const QColor& background,
                   const std::function<void(QPainter&)>& draw) {
    const int kind = painter.device()->devType();
    if (kind != QInternal::Pixmap && kind != QInternal::Widget) {
        draw(painter); // a picture already, or paper
        return;
    }
    const double ratio = painter.device()->devicePixelRatioF();
    QImage picture((QSizeF(size) * ratio).toSize(), QImage::Format_RGB32);
    picture.setDevicePixelRatio(ratio);
    picture.fill(background);
    QPainter inside(&picture);
    draw(inside);
    inside.end();
    painter.drawImage(QPointF(0.0, 0.0), picture);
}

std::vector<SampleRun> runsOf(int count, const std::function<bool(int)>& drawable) {
    std::vector<SampleRun> runs;
    bool open = false;
    for (int i = 0; i < count; ++i) {
        if (!drawable(i)) {
            open = false;
        } else if (open) {
            runs.back().last = i;
        } else {
            runs.push_back({i, i});
            open = true;
        }
    }
    return runs;
}

SampleRun visiblePart(const std::vector<double>& axis, const SampleRun& run, double low,
                      double high) {
    const auto begin = axis.begin() + run.first;
    const auto end = axis.begin() + run.last + 1;
    const bool rises = std::is_sorted(begin, end);
    if (!rises && !std::is_sorted(begin, end, std::greater<>()))
        return run;
    const auto from = rises ? std::lower_bound(begin, end, low)
                            : std::lower_bound(begin, end, high, std::greater<>());
    const auto to = rises ? std::upper_bound(begin, end, high)
                          : std::upper_bound(begin, end, low, std::greater<>());
    const int first = std::max(run.first, static_cast<int>(from - axis.begin()) - 1);
    const int last = std::min(run.last, static_cast<int>(to - axis.begin()));
    return {first, last};
}

} // namespace smat::gui
