#include "gui/plot/CurveDrawing.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <QPaintEngine>
#include <QPainter>

namespace smat::gui {
namespace {

/// Gathers the points of one column.
class Column {
  public:
    Column(QPolygonF& out, double width) : out_(out), width_(width) {}

    void add(const QPointF& point) {
        const double column = std::floor(point.x() / width_);
        if (count_ > 0 && column != column_)
            flush();
        column_ = column;
        if (count_ == 0)
            lowest_ = highest_ = 0;
        if (count_ == 0 || point.y() < lowestPoint_.y()) {
            lowest_ = count_;
            lowestPoint_ = point;
        }
        if (count_ == 0 || point.y() > highestPoint_.y()) {
            highest_ = count_;
            highestPoint_ = point;
        }
        if (count_ == 0)
            first_ = point;
        last_ = point;
        ++count_;
    }
    void flush() {
        if (count_ == 0)
            return;
        out_ << first_;
        const bool lowFirst = lowest_ < highest_;
        take(lowFirst ? lowest_ : highest_, lowFirst ? lowestPoint_ : highestPoint_);
        if (lowest_ != highest_)
            take(lowFirst ? highest_ : lowest_, lowFirst ? highestPoint_ : lowestPoint_);
        if (count_ > 1)
            out_ << last_;
        count_ = 0;
    }

  private:
    void take(int index, const QPointF& point) {
        if (index > 0 && index < count_ - 1)
            out_ << point;
    }

    QPolygonF& out_;
    double width_, column_ = 0.0;
    int count_ = 0, lowest_ = 0, highest_ = 0;
    QPointF first_, last_, lowestPoint_, highestPoint_;
};

/// The part of a segment inside a rectangle (Liang and Barsky 1984), as parameters from 0 to 1.
struct Part {
    double from = 0.0, to = 1.0;
};
std::optional<Part> insideOf(const QPointF& a, const QPointF& b, const QRectF& area) {
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

} // namespace

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
    column.flush();
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

void drawLine(QPainter& painter, const QPolygonF& line) {
    constexpr qsizetype piece = 12;
    if (finestColumn(painter) <= 0.0 || line.size() <= 2 * piece) {
        painter.drawPolyline(line);
        return;
    }
    // Pieces share a segment, so that corners between them are joined as all others are.
    for (qsizetype from = 0; from + 1 < line.size(); from += piece - 2)
        painter.drawPolyline(line.constData() + from,
                             static_cast<int>(std::min(piece, line.size() - from)));
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
