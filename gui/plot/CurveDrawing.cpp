#include "gui/plot/CurveDrawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include <QImage>
#include <QLineF>
#include <QPaintEngine>
#include <QPainter>
#include <QwtClipper>

#include "gui/plot/AreaRaster.h"
#include "gui/plot/LineRaster.h"
#include "gui/plot/Rounding.h"

namespace smat::gui {
namespace {

/// Lines are two pixels wide and blur what is finer.
constexpr double columnWidth_px = 1.0;

/// Gathers the points of one column.
class Column {
  public:
    Column(std::vector<qsizetype>& out, double width) : out_(out), perWidth_(1.0 / width) {}

    void add(qsizetype index, const QPointF& point) {
        const std::int64_t column = floorOf(point.x() * perWidth_);
        if (count_ > 0 && column != column_) {
            const bool next = std::abs(column - column_) == 1;
            flush(next);
            fromNext_ = next;
        }
        column_ = column;
        last_ = {index, point.y()};
        if (count_ == 0)
            first_ = lowest_ = highest_ = last_;
        else if (point.y() < lowest_.y)
            lowest_ = last_;
        else if (point.y() > highest_.y)
            highest_ = last_;
        ++count_;
    }
    void flush(bool toNext) {
        if (count_ == 0)
            return;
        const bool lowFirst = lowest_.index < highest_.index;
        const Point& early = lowFirst ? lowest_ : highest_;
        const Point& late = lowFirst ? highest_ : lowest_;
        if (!fromNext_ && first_.index < early.index)
            out_.push_back(first_.index);
        out_.push_back(early.index);
        if (late.index != early.index)
            out_.push_back(late.index);
        if (!toNext && last_.index > late.index)
            out_.push_back(last_.index);
        count_ = 0;
    }

  private:
    struct Point {
        qsizetype index = 0;
        double y = 0.0;
    };
    std::vector<qsizetype>& out_;
    double perWidth_;
    std::int64_t column_ = 0;
    int count_ = 0; ///< points of the column
    Point first_, lowest_, highest_, last_;
    bool fromNext_ = false; ///< the line comes from the column beside this one
};

std::vector<qsizetype> allOf(const QPolygonF& line) {
    std::vector<qsizetype> all(static_cast<std::size_t>(line.size()));
    std::iota(all.begin(), all.end(), qsizetype(0));
    return all;
}

/// Where pixels can be drawn one by one: the picture that a painter draws into, if it does so
/// without turning or shearing.
QImage* pictureOf(const QPainter& painter) {
    auto* device = painter.device();
    const QTransform& way = painter.deviceTransform();
    const bool upright = way.type() <= QTransform::TxScale && way.m11() == way.m22();
    if (device == nullptr || device->devType() != QInternal::Image || !upright)
        return nullptr;
    auto* picture = static_cast<QImage*>(device);
    return Coverage::canDrawInto(*picture) ? picture : nullptr;
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
    return scale > 0.0 ? columnWidth_px / scale : 0.0;
}

std::vector<qsizetype> pointsOf(const QPolygonF& line, double columnWidth) {
    if (columnWidth <= 0.0)
        return allOf(line);
    std::vector<qsizetype> result;
    result.reserve(static_cast<std::size_t>(line.size()));
    Column column(result, columnWidth);
    for (qsizetype i = 0; i < line.size(); ++i)
        column.add(i, line[i]);
    column.flush(false);
    return result;
}

std::vector<qsizetype> pointsOfEdge(const QPolygonF& line, double columnWidth, Edge edge) {
    if (columnWidth <= 0.0 || line.size() < 3)
        return allOf(line);
    std::vector<qsizetype> result{0};
    const double sign = edge == Edge::lowest ? 1.0 : -1.0;
    const double perWidth = 1.0 / columnWidth;
    std::int64_t column = floorOf(line[0].x() * perWidth);
    qsizetype best = 0;
    for (qsizetype i = 1; i < line.size(); ++i) {
        const std::int64_t here = floorOf(line[i].x() * perWidth);
        if (here == column) {
            if (sign * line[i].y() < sign * line[best].y())
                best = i;
            continue;
        }
        if (best > result.back())
            result.push_back(best);
        column = here;
        best = i;
    }
    for (const qsizetype end : {best, line.size() - 1})
        if (end > result.back())
            result.push_back(end);
    return result;
}

QPolygonF chosen(const QPolygonF& line, const std::vector<qsizetype>& points) {
    QPolygonF result;
    result.reserve(static_cast<qsizetype>(points.size()));
    for (const qsizetype point : points)
        result << line[point];
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
    const QPolygonF pixels = toPixels.map(line);
    for (qsizetype i = 1; i < pixels.size(); ++i)
        raster.add(pixels[i - 1], pixels[i]);
    raster.paint(painter.pen().color(),
                 painter.hasClipping() ? toPixels.map(painter.clipRegion()) : QRegion(seen));
}

void drawBand(QPainter& painter, const QPolygonF& upper, const QPolygonF& lower,
              const QRectF& area) {
    QImage* picture = pictureOf(painter);
    if (picture == nullptr) {
        const QPolygonF outline = upper + QPolygonF(lower.rbegin(), lower.rend());
        painter.drawPolygon(QwtClipper::clippedPolygonF(area, outline, true), Qt::WindingFill);
        return;
    }
    const QTransform toPixels = painter.deviceTransform();
    const QRect seen = toPixels.mapRect(area).toAlignedRect();
    AreaRaster raster(*picture, seen);
    const QPolygonF there = toPixels.map(upper), back = toPixels.map(lower);
    for (qsizetype i = 1; i < there.size(); ++i)
        raster.add(there[i - 1], there[i]);
    raster.add(there.back(), back.back());
    for (qsizetype i = back.size() - 1; i > 0; --i)
        raster.add(back[i], back[i - 1]);
    raster.add(back.front(), there.front());
    raster.paint(painter.brush().color(),
                 painter.hasClipping() ? toPixels.map(painter.clipRegion()) : QRegion(seen));
}

void drawHollowPoints(QPainter& painter, const QPolygonF& points, const QColor& fill,
                      const QRectF& area) {
    constexpr double radius_px = 3.6, least_px = 2.0;
    painter.save();
    QPen pen = painter.pen();
    pen.setWidthF(1.6);
    painter.setPen(pen);
    painter.setBrush(fill);
    const QPointF* last = nullptr;
    for (const QPointF& point : points) {
        if (!area.contains(point) || (last != nullptr && QLineF(*last, point).length() < least_px))
            continue;
        painter.drawEllipse(point, radius_px, radius_px);
        last = &point;
    }
    painter.restore();
}

void drawOnPicture(QPainter& painter, const QSize& size, const QColor& background,
                   const std::function<void(QPainter&)>& draw) {
    const int kind = painter.device()->devType();
    if (kind != QInternal::Pixmap && kind != QInternal::Widget) {
        draw(painter); // a picture already, or paper
        return;
    }
    const double ratio = painter.device()->devicePixelRatioF();
    // Kept for the next frame: fresh memory is slow.
    thread_local QImage picture;
    if (const QSize pixels = (QSizeF(size) * ratio).toSize(); picture.size() != pixels)
        picture = QImage(pixels, QImage::Format_RGB32);
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
