#include "gui/view/ViewHud.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include <QCoreApplication>
#include <QPainter>
#include <QPainterPath>
#include <QTextDocument>

#include "gui/plot/PlotLook.h"
#include "gui/view/SeamedDrawing.h"
#include "gui/widgets/ThemeColors.h"

namespace smat::gui {
namespace {

constexpr double inset_px = 6.0;

QString trHud(const char* text) {
    return QCoreApplication::translate("smat::gui::ViewHud", text);
}

/// Words on a plate that stands out from any picture.
void drawPlate(QPainter& painter, const QRectF& box, bool dark) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(faded(colors::overlayPaper(dark), 0.8F));
    painter.drawRoundedRect(box, 5.0, 5.0);
    painter.setBrush(Qt::NoBrush);
}

enum class Corner { topLeft, topRight, bottomRight };
constexpr double aroundLabel_px = 18.0;
bool fits(const QPainter& painter, const QRectF& area, const QString& text) {
    return QFontMetricsF(painter.font()).horizontalAdvance(text) + aroundLabel_px <= area.width();
}
QRectF labelBox(const QPainter& painter, const QRectF& area, Corner corner, const QString& text) {
    const QFontMetricsF metrics(painter.font());
    QRectF box(0, 0, std::min(metrics.horizontalAdvance(text) + aroundLabel_px, area.width()),
               metrics.height() + 8.0);
    if (corner == Corner::topLeft)
        box.moveTopLeft(area.topLeft());
    else if (corner == Corner::topRight)
        box.moveTopRight(area.topRight());
    else
        box.moveBottomRight(area.bottomRight());
    return box;
}
void drawLabel(QPainter& painter, const QRectF& area, Corner corner, const QString& text,
               bool dark) {
    const QRectF box = labelBox(painter, area, corner, text);
    drawPlate(painter, box, dark);
    painter.setPen(colors::overlayInk(dark));
    painter.drawText(
        box.adjusted(9, 0, -9, 0), Qt::AlignVCenter | Qt::AlignLeft,
        QFontMetricsF(painter.font()).elidedText(text, Qt::ElideRight, box.width() - 17.0));
}

} // namespace

void ViewHud::paint(QPainter& painter) const {
    painter.setFont(plotFont()); // it is exported with the view
    if (!hasProject && !hasModel && busy.isEmpty() && problem.isEmpty()) {
        paintInvitation(painter);
        return;
    }
    if (!inspecting)
        paintFrame(painter);
    if (!inset.isNull())
        paintInset(painter);
    paintFrusta(painter);
    if (hasModel && modelAxes)
        paintModelAxes(painter);
    if (hasModel && sunVector)
        paintSun(painter);
    if (handles)
        handles->paint(painter, projection, dark);
    if (viewAxes)
        paintViewAxes(painter);
    paintWords(painter);
    if (!problem.isEmpty())
        paintProblem(painter);
}

void ViewHud::paintInvitation(QPainter& painter) const {
    painter.setPen(faded(colors::overlayInk(dark), 0.75F));
    painter.drawText(QRectF(QPointF(), projection.window), Qt::AlignCenter | Qt::TextWordWrap,
                     trHud("Nothing is open yet.\n"
                           "Open a project or a model (Ctrl+O), or drop one here."));
}

double ViewHud::axisLength_m() const {
    const double metresPerPixel = projection.depth_m(reference_m) / projection.focalLength_px;
    const double side = std::min(projection.window.width(), projection.window.height());
    return std::clamp(1.3 * radius_m, 40.0 * metresPerPixel,
                      std::max(40.0, 0.4 * side) * metresPerPixel);
}

QPointF ViewHud::viewAxesOrigin() const {
    const QRectF inner =
        inspecting ? QRectF(QPointF(), projection.window) : frameRectIn(frame, projection.window);
    return inner.bottomLeft() + QPointF(64.0, -64.0);
}

void ViewHud::paintFrame(QPainter& painter) const {
    const QRectF inner =
        frameRectIn(frame, projection.window).adjusted(inset_px, inset_px, -inset_px, -inset_px);
    const double arm = 16.0;
    const QColor ink = faded(colors::overlayInk(dark), 0.75F);
    for (const auto& [corner, right, down] :
         {std::tuple{inner.topLeft(), 1.0, 1.0}, std::tuple{inner.topRight(), -1.0, 1.0},
          std::tuple{inner.bottomLeft(), 1.0, -1.0}, std::tuple{inner.bottomRight(), -1.0, -1.0}}) {
        drawSeamed(painter, {corner, corner + QPointF(arm * right, 0.0)}, ink, 1.2, dark);
        drawSeamed(painter, {corner, corner + QPointF(0.0, arm * down)}, ink, 1.2, dark);
    }
}

void ViewHud::paintViewAxes(QPainter& painter) const {
    const std::pair<irsg::Vec3, QString> axes[] = {
        {{1, 0, 0}, trHud("E")}, {{0, 1, 0}, trHud("N")}, {{0, 0, 1}, trHud("Up")}};
    const QPointF origin = viewAxesOrigin();
    painter.save();
    QFont font = painter.font();
    font.setBold(true);
    painter.setFont(font);
    for (std::size_t i = 0; i < 3; ++i) {
        const auto& [along, name] = axes[i];
        const QPointF tip(irsg::dot(along, projection.eye.right),
                          -irsg::dot(along, projection.eye.up));
        drawSeamed(painter, {origin, origin + tip * viewAxisLength_px},
                   colors::axis(static_cast<int>(i)), 2.4, dark);
        drawSeamedText(painter, origin + tip * (viewAxisLength_px + 13.0), name,
                       colors::axis(static_cast<int>(i)), dark);
    }
    painter.restore();
}

void ViewHud::paintModelAxes(QPainter& painter) const {
    const std::pair<irsg::Vec3, QString> axes[] = {
        {{1, 0, 0}, trHud("starboard")}, {{0, 1, 0}, trHud("nose")}, {{0, 0, 1}, trHud("up")}};
    const irsg::Rotation rotation = attitude.rotation();
    const double length_m = axisLength_m();
    for (std::size_t i = 0; i < 3; ++i) {
        const irsg::Vec3 along = rotation * axes[i].first;
        const auto line = projection.line(reference_m, reference_m + along * length_m);
        if (!line)
            continue;
        drawSeamed(painter, *line, colors::axis(static_cast<int>(i)), 2.0, dark);
        // A name beyond the tip, or beside an axis that points into the picture.
        const double length_px = line->length();
        const QPointF beyond =
            length_px > 1.0 ? (line->p2() - line->p1()) / length_px : QPointF(0.0, -1.0);
        const QFontMetricsF metrics(painter.font());
        const double half = metrics.horizontalAdvance(axes[i].second) / 2.0;
        drawSeamedText(painter, line->p2() + QPointF(beyond.x() * (half + 6.0), beyond.y() * 13.0),
                       axes[i].second, colors::axis(static_cast<int>(i)), dark);
    }
}

void ViewHud::paintSun(QPainter& painter) const {
    const auto line = projection.line(reference_m, reference_m + towardsSun * sunLength_m());
    if (!line)
        return;
    // Below the horizon no sun is reflected: the line is there, broken.
    const bool isUp = towardsSun.z > 0.0;
    const QColor yellow = colors::sun();
    drawSeamed(painter, *line, yellow, 2.4, dark, isUp ? Qt::SolidLine : Qt::DotLine);
    painter.setPen(QPen(colors::sunRim(), 1.0));
    painter.setBrush(isUp ? yellow : faded(yellow, 0.4F));
    painter.drawEllipse(line->p2(), 6.0, 6.0);
    painter.setBrush(Qt::NoBrush);
}

void ViewHud::paintFrusta(QPainter& painter) const {
    for (const ViewFrustum& frustum : frusta) {
        const bool isFrame = frustum.of == ViewFrustum::Of::frame;
        const QColor color =
            isFrame ? faded(colors::overlayInk(dark), 0.8F) : colors::tileFrustum();
        const double width_px = isFrame ? 1.0 : 1.4;
        for (std::size_t i = 0; i < 4; ++i) {
            const irsg::Vec3 &corner = frustum.corners_m[i], &next = frustum.corners_m[(i + 1) % 4];
            if (const auto edge = projection.line(corner, next))
                drawSeamed(painter, *edge, color, width_px, dark);
            // Seen through the sensor itself they are points.
            if (const auto edge =
                    inspecting ? projection.line(frustum.eye_m, corner) : std::nullopt;
                edge && frustum.of != ViewFrustum::Of::point)
                drawSeamed(painter, *edge, faded(color, 0.6F), 0.8, dark);
        }
        if (const auto sight = frustum.of == ViewFrustum::Of::point && inspecting
                                   ? projection.line(frustum.eye_m, frustum.corners_m[0])
                                   : std::nullopt)
            drawSeamed(painter, *sight, faded(color, 0.6F), 0.8, dark, Qt::DotLine);
    }
}

QRectF ViewHud::wordsArea() const {
    const QRectF inner =
        inspecting ? QRectF(QPointF(), projection.window) : frameRectIn(frame, projection.window);
    return inner.adjusted(inset_px + 8, inset_px + 6, -inset_px - 8, -inset_px - 6);
}

void ViewHud::paintInset(QPainter& painter) const {
    painter.setPen(QPen(faded(colors::overlayInk(dark), 0.75F), 1.4));
    painter.drawRect(inset);
    drawLabel(painter, inset.adjusted(3, 3, -3, -3), Corner::topLeft,
              inspecting ? trHud("sensor") : trHud("inspection"), dark);
}

void ViewHud::paintWords(QPainter& painter) const {
    QRectF area = wordsArea();
    const auto placed = [this](const char* form) {
        return trHud(form)
            .arg(camera.azimuth_deg, 0, 'f', 1)
            .arg(camera.elevation_deg, 0, 'f', 1)
            .arg(camera.range_m, 0, 'g', 6);
    };
    QRectF left = area;
    if (!inset.isNull())
        left.setRight(inset.left() - 6.0);
    QString words = placed(inspecting ? "inspection   azimuth %1°   elevation %2°   distance %3 m"
                                      : "sensor   azimuth %1°   elevation %2°   range %3 m");
    // No number may be cut off.
    if (!fits(painter, left, words))
        words = placed("az %1°   el %2°   %3 m");
    if (const auto windows = std::ranges::count(frusta, ViewFrustum::Of::window, &ViewFrustum::of);
        !frusta.empty())
        words += "   " + (windows == 1 ? trHud("1 window") : trHud("%1 windows").arg(windows)) +
                 (mostSamples > 0.0
                      ? trHud(", up to %1 samples a pixel and axis").arg(mostSamples, 0, 'g', 3)
                      : QString());
    drawLabel(painter, left, Corner::topLeft, words, dark);
    if (!inset.isNull())
        area.setTop(std::max(area.top(), inset.bottom() + 6.0));
    if (!busy.isEmpty()) {
        // Below the camera where there is no room beside it.
        const QRectF camera = labelBox(painter, left, Corner::topLeft, words);
        QRectF right = area;
        if (labelBox(painter, right, Corner::topRight, busy).intersects(camera))
            right.setTop(camera.bottom() + 4.0);
        drawLabel(painter, right, Corner::topRight, busy, dark);
    }
    if (!readout.isEmpty())
        drawLabel(painter, area, Corner::bottomRight, readout, dark);
}

void ViewHud::paintProblem(QPainter& painter) const {
    const QSizeF window = projection.window;
    const double width = std::clamp(0.7 * window.width(), 240.0, 640.0);
    QStringList shown = problem.mid(0, 6);
    if (problem.size() > shown.size())
        shown << trHud("and %1 more").arg(problem.size() - shown.size());
    QTextDocument words;
    words.setDefaultFont(painter.font());
    words.setDocumentMargin(0.0);
    words.setHtml(QStringLiteral("<div style='color:%1'><b>%2</b><p>%3</p></div>")
                      .arg(colors::overlayInk(dark).name(), trHud("No infrared picture"),
                           shown.join("\n").toHtmlEscaped().replace('\n', "<br>")));
    words.setTextWidth(width - 32.0);

    QRectF box(0, 0, width, std::min(words.size().height() + 28.0, window.height() - 24.0));
    box.moveCenter(QPointF(window.width() / 2.0, window.height() / 2.0));
    painter.setPen(QPen(colors::problemFrame(), 1.4));
    painter.setBrush(faded(colors::overlayPaper(dark), 0.93F));
    painter.drawRoundedRect(box, 7.0, 7.0);
    painter.setBrush(Qt::NoBrush);
    const QRectF inner = box.adjusted(16, 14, -16, -14);
    painter.save();
    painter.translate(inner.topLeft());
    words.drawContents(&painter, QRectF(QPointF(), inner.size()));
    painter.restore();
}

} // namespace smat::gui
