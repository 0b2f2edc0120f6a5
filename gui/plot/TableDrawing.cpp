#include "gui/plot/TableDrawing.h"

#include <algorithm>
#include <cmath>

#include <QCoreApplication>
#include <QImage>
#include <QPainter>

#include "gui/plot/PlotLook.h"
#include "gui/widgets/NumberFormat.h"
#include "gui/widgets/ThemeColors.h"
#include "irsg/core/Errors.h"
#include "irsg/geometry/view/Pose.h"
#include "irsg/image/AxisTicks.h"
#include "irsg/radiometry/Units.h"

namespace smat::gui {

namespace {

constexpr double floor_dB = -400.0, shownBelowPeak_dB = 60.0;
/// Of the picture of a map; larger ones show nothing more.
constexpr int mostColumns = 1440, mostSide = 1000;

QString words(const char* text) {
    return QCoreApplication::translate("smat::gui::TableDrawing", text);
}

QString shownNumber(double value) {
    return formattedNumber(value);
}

/// Towards the camera of a direction: x to starboard, y to the nose, z up.
irsg::Vec3 vectorOf(double azimuth_deg, double elevation_deg) {
    return irsg::direction(irsg::radians(azimuth_deg), irsg::radians(elevation_deg));
}

/// Hatches of what is negative, along the diagonal.
bool isHatched(int x, int y, int width) {
    return ((x + y) / std::max(1, width / 240)) % 4 == 0;
}

} // namespace

TableDrawing::TableDrawing(std::shared_ptr<const ResultTable> table)
    : held_(std::move(table)),
      table_(*held_),
      lookup_(table_),
      choice_(table_.axes().size(), 0),
      map_(&irsg::ColorMap::named("viridis")) {
    const ResultColumn* wanted = nullptr;
    for (const ResultColumn* column : table_.columns())
        if (wanted == nullptr && column->key.starts_with("contrast_intensity"))
            wanted = column;
    column_ = wanted != nullptr ? wanted : table_.columns().front();
    findLimits();
}

void TableDrawing::setColumn(const std::string& key) {
    column_ = table_.column(key);
    if (column_ == nullptr)
        throw irsg::LogicError("a signature table has no column " + key);
    findLimits();
}

void TableDrawing::setChoice(const SignatureTable::Choice& choice) {
    choice_ = choice;
    findLimits();
}

void TableDrawing::setDecibel(bool on) {
    isDecibel_ = on;
    findLimits();
}

void TableDrawing::turnBall(double azimuth_deg, double elevation_deg) {
    ballAzimuth_deg_ = azimuth_deg - 360.0 * std::floor(azimuth_deg / 360.0);
    ballElevation_deg_ = std::clamp(elevation_deg, -90.0, 90.0);
}

double TableDrawing::value(int direction) const {
    return column_->values[table_.row(static_cast<std::size_t>(direction), choice_)];
}

double TableDrawing::shownValue(int direction) const {
    return isDecibel_ ? decibelOf(value(direction), floor_dB) : value(direction);
}

void TableDrawing::findLimits() {
    double low = HUGE_VAL, high = -HUGE_VAL;
    negative_ = 0;
    for (std::size_t i = 0; i < table_.directions().size(); ++i) {
        const int direction = static_cast<int>(i);
        negative_ += value(direction) < 0.0 ? 1 : 0;
        const double shown = shownValue(direction);
        if (!std::isfinite(shown) || (isDecibel_ && shown <= floor_dB))
            continue;
        low = std::min(low, shown);
        high = std::max(high, shown);
    }
    if (!(low <= high))
        low = high = isDecibel_ ? -1.0 : 0.0;
    if (isDecibel_)
        low = std::max(low, high - shownBelowPeak_dB);
    if (!(low < high)) {
        const double around = std::max(std::abs(high) * 0.01, isDecibel_ ? 0.5 : 1e-12);
        low -= around;
        high += around;
    }
    limits_ = {low, high};
}

QString TableDrawing::negativeWords() const {
    if (negative_ == 0)
        return {};
    return words("%1 of %2 cells are negative: hatched")
        .arg(negative_)
        .arg(table_.directions().size());
}

QString TableDrawing::barTitle() const {
    const QString title = QString::fromStdString(column_->axisTitle());
    if (!isDecibel_)
        return title;
    const QString unit = formattedUnit(column_->unit);
    const QString name = title.section(" (", 0, 0);
    return unit.isEmpty() ? words("%1 (dB)").arg(name) : words("%1 (dB over 1 %2)").arg(name, unit);
}

irsg::Rgb TableDrawing::colorOf(int direction) const {
    return map_->color(shownValue(direction), limits_);
}

QString TableDrawing::readout(int direction) const {
    if (direction == DirectionLookup::nothing)
        return {};
    const auto& at = table_.directions()[static_cast<std::size_t>(direction)];
    QString text = words("Azimuth %1°, elevation %2°: %3 %4")
                       .arg(shownNumber(at.azimuth_deg), shownNumber(at.elevation_deg),
                            shownNumber(value(direction)), formattedUnit(column_->unit))
                       .trimmed();
    if (isDecibel_)
        text += words(", %1 dB").arg(shownValue(direction), 0, 'f', 2);
    return text;
}

std::optional<SignatureTable::Direction> TableDrawing::onBall(double right, double up) const {
    const double square = right * right + up * up;
    if (square > 1.0)
        return std::nullopt;
    const irsg::Vec3 towards = vectorOf(ballAzimuth_deg_, ballElevation_deg_);
    const irsg::Vec3 sideways = vectorOf(ballAzimuth_deg_ - 90.0, 0.0);
    const irsg::Vec3 above = irsg::cross(towards, sideways);
    const irsg::Vec3 at =
        sideways * right + above * up + towards * std::sqrt(std::max(1.0 - square, 0.0));
    return SignatureTable::Direction{irsg::degrees(std::atan2(at.x, at.y)),
                                     irsg::degrees(std::asin(std::clamp(at.z, -1.0, 1.0)))};
}

std::optional<QPointF> TableDrawing::placeOnBall(double azimuth_deg, double elevation_deg) const {
    const irsg::Vec3 towards = vectorOf(ballAzimuth_deg_, ballElevation_deg_);
    const irsg::Vec3 sideways = vectorOf(ballAzimuth_deg_ - 90.0, 0.0);
    const irsg::Vec3 at = vectorOf(azimuth_deg, elevation_deg);
    if (irsg::dot(at, towards) < 0.0)
        return std::nullopt;
    return QPointF(irsg::dot(at, sideways), irsg::dot(at, irsg::cross(towards, sideways)));
}

QImage TableDrawing::mapPicture(int width, int height) const {
    QImage picture(width, height, QImage::Format_ARGB32_Premultiplied);
    for (int y = 0; y < height; ++y) {
        auto* line = reinterpret_cast<QRgb*>(picture.scanLine(y));
        for (int x = 0; x < width; ++x) {
            const int direction = lookup_.nearest((x + 0.5) * 360.0 / width - 180.0,
                                                  90.0 - (y + 0.5) * 180.0 / height);
            if (direction == DirectionLookup::nothing) {
                line[x] = 0;
                continue;
            }
            const irsg::Rgb color = colorOf(direction);
            const bool isDark = value(direction) < 0.0 && isHatched(x, y, width);
            line[x] = isDark ? qRgb(30, 30, 30) : qRgb(color.red, color.green, color.blue);
        }
    }
    return picture;
}

QImage TableDrawing::ballPicture(int side, const QColor& around) const {
    QImage picture(side, side, QImage::Format_ARGB32_Premultiplied);
    picture.fill(Qt::transparent);
    const double radius = 0.5 * side;
    for (int y = 0; y < side; ++y) {
        auto* line = reinterpret_cast<QRgb*>(picture.scanLine(y));
        for (int x = 0; x < side; ++x) {
            const auto at = onBall((x + 0.5) / radius - 1.0, 1.0 - (y + 0.5) / radius);
            if (!at)
                continue;
            const int direction = lookup_.nearest(at->azimuth_deg, at->elevation_deg);
            if (direction == DirectionLookup::nothing) {
                line[x] = around.rgb();
                continue;
            }
            const irsg::Rgb color = colorOf(direction);
            const bool isDark = value(direction) < 0.0 && isHatched(x, y, 2 * side);
            line[x] = isDark ? qRgb(30, 30, 30) : qRgb(color.red, color.green, color.blue);
        }
    }
    return picture;
}

TableDrawing::Areas TableDrawing::areasOf(const QRectF& area, double letter) const {
    const double head = (conditions.isEmpty() ? 2.0 : 3.4) * letter;
    const double foot = negative_ > 0 ? 1.6 * letter : 0.4 * letter;
    QRectF inner = area.adjusted(letter, head + 0.6 * letter, -letter, -foot - 0.4 * letter);
    const double barWidth = 7.5 * letter;
    const QRectF bar(inner.right() - barWidth, inner.top() + 1.4 * letter, barWidth,
                     inner.height() - 3.4 * letter);
    inner.setRight(bar.left() - letter);
    // Map beside ball where that makes both larger, else over it.
    const double left = 3.6 * letter, below = 3.0 * letter;
    const auto mapIn = [&](const QRectF& room) {
        const double width =
            std::max(0.0, std::min(room.width() - left, 2.0 * (room.height() - below)));
        const QSizeF size(width, 0.5 * width);
        return QRectF(
            QPointF(room.left() + left, room.top() + 0.5 * (room.height() - below - size.height())),
            size);
    };
    const auto ballIn = [&](const QRectF& room) {
        const double side = std::max(0.0, std::min(room.width(), room.height()) - 2.6 * letter);
        return QRectF(room.center() - QPointF(0.5 * side, 0.5 * side), QSizeF(side, side));
    };
    const QRectF beside(inner.left(), inner.top(), 0.64 * inner.width(), inner.height());
    const QRectF besideBall(beside.right() + letter, inner.top(),
                            inner.right() - beside.right() - letter, inner.height());
    const QRectF over(inner.left(), inner.top(), inner.width(), 0.5 * inner.height());
    const QRectF overBall(inner.left(), over.bottom(), inner.width(), 0.5 * inner.height());
    if (mapIn(beside).width() >= mapIn(over).width())
        return {mapIn(beside), ballIn(besideBall), bar};
    return {mapIn(over), ballIn(overBall), bar};
}

QRectF TableDrawing::ballIn(const QRectF& area, double letter) const {
    return areasOf(area, letter).ball;
}

int TableDrawing::directionAt(const QPointF& point, const QRectF& area, double letter) const {
    const Areas parts = areasOf(area, letter);
    if (parts.map.contains(point))
        return lookup_.nearest((point.x() - parts.map.left()) * 360.0 / parts.map.width() - 180.0,
                               90.0 - (point.y() - parts.map.top()) * 180.0 / parts.map.height());
    const double radius = 0.5 * parts.ball.width();
    const QPointF off = point - parts.ball.center();
    const auto at = radius > 0.0 ? onBall(off.x() / radius, -off.y() / radius) : std::nullopt;
    return at ? lookup_.nearest(at->azimuth_deg, at->elevation_deg) : DirectionLookup::nothing;
}

void TableDrawing::paint(QPainter& painter, const QRectF& area, const PlotStyle& style) const {
    painter.save();
    painter.fillRect(area, style.background);
    painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
    QFont font = plotFont();
    painter.setFont(font);
    const double letter = QFontMetricsF(font, painter.device()).height();
    const Areas parts = areasOf(area, letter);

    QFont bold = plotFont(1.15, true);
    painter.setFont(bold);
    painter.setPen(style.text);
    const QRectF head(area.left() + letter, area.top() + 0.5 * letter, area.width() - 2 * letter,
                      1.5 * letter);
    painter.drawText(
        head, Qt::AlignCenter,
        QFontMetricsF(bold, painter.device()).elidedText(title, Qt::ElideRight, head.width()));
    painter.setFont(font);
    if (!conditions.isEmpty()) {
        painter.setPen(style.faintText);
        painter.drawText(head.translated(0, 1.5 * letter), Qt::AlignCenter,
                         QFontMetricsF(font, painter.device())
                             .elidedText(conditions, Qt::ElideRight, head.width()));
    }
    paintMap(painter, parts.map, style, letter);
    paintBall(painter, parts.ball, style, letter);
    paintBar(painter, parts.bar, style, letter);
    if (negative_ > 0) {
        painter.setPen(style.text);
        painter.drawText(QRectF(area.left() + letter, area.bottom() - 1.9 * letter,
                                area.width() - 2 * letter, 1.4 * letter),
                         Qt::AlignCenter, negativeWords());
    }
    painter.restore();
}

void TableDrawing::paintMap(QPainter& painter, const QRectF& area, const PlotStyle& style,
                            double letter) const {
    if (area.width() < 4.0)
        return;
    const int width = std::clamp(
        static_cast<int>(area.width() * painter.device()->devicePixelRatioF()), 90, mostColumns);
    painter.fillRect(area, style.canvas);
    painter.drawImage(area, mapPicture(width, width / 2));
    painter.setPen(QPen(style.frame, 0.0));
    painter.drawRect(area);
    painter.setPen(style.text);
    const auto tick = [&](const QPointF& at, const QPointF& out, const QString& text,
                          const QRectF& box, int align) {
        painter.drawLine(at, at + out);
        painter.drawText(box, align, text);
    };
    for (int azimuth = -180; azimuth <= 180; azimuth += 45) {
        const double x = area.left() + (azimuth + 180) * area.width() / 360.0;
        tick({x, area.bottom()}, {0, 0.35 * letter}, QString::number(azimuth),
             QRectF(x - 3 * letter, area.bottom() + 0.4 * letter, 6 * letter, letter),
             Qt::AlignHCenter | Qt::AlignTop);
    }
    for (int elevation = -90; elevation <= 90; elevation += 30) {
        const double y = area.top() + (90 - elevation) * area.height() / 180.0;
        tick({area.left(), y}, {-0.35 * letter, 0}, QString::number(elevation),
             QRectF(area.left() - 4.5 * letter, y - 0.6 * letter, 4.0 * letter, 1.2 * letter),
             Qt::AlignRight | Qt::AlignVCenter);
    }
    painter.drawText(QRectF(area.left(), area.bottom() + 1.5 * letter, area.width(), 1.3 * letter),
                     Qt::AlignCenter, words("Azimuth (°), 0 the nose, 90 starboard"));
    painter.save();
    painter.translate(area.left() - 3.1 * letter, area.center().y());
    painter.rotate(-90.0);
    painter.drawText(QRectF(-0.5 * area.height() - 3 * letter, -0.6 * letter,
                            area.height() + 6 * letter, 1.2 * letter),
                     Qt::AlignCenter, words("Elevation (°)"));
    painter.restore();
}

void TableDrawing::paintBall(QPainter& painter, const QRectF& area, const PlotStyle& style,
                             double letter) const {
    if (area.width() < 4.0)
        return;
    const int side = std::clamp(
        static_cast<int>(area.width() * painter.device()->devicePixelRatioF()), 60, mostSide);
    painter.drawImage(area, ballPicture(side, style.canvas));
    const auto placed = [&](const QPointF& on, double out = 1.0) {
        return area.center() + QPointF(on.x(), -on.y()) * (0.5 * out * area.width());
    };
    // Every 30 degrees, the equator and the plane of the nose stronger.
    const auto line = [&](auto place, bool isMain) {
        QColor ink = colors::ballLine(style.dark);
        ink.setAlphaF(isMain ? 0.55F : 0.22F);
        painter.setPen(QPen(ink, 0.0));
        std::optional<QPointF> before;
        for (int i = 0; i <= 120; ++i) {
            const auto on = place(static_cast<double>(i) / 120.0);
            if (on && before)
                painter.drawLine(placed(*before), placed(*on));
            before = on;
        }
    };
    for (int azimuth = 0; azimuth < 360; azimuth += 30)
        line([&](double t) { return placeOnBall(azimuth, 180.0 * t - 90.0); }, azimuth % 180 == 0);
    for (int elevation = -60; elevation <= 60; elevation += 30)
        line([&](double t) { return placeOnBall(360.0 * t, elevation); }, elevation == 0);
    painter.setPen(QPen(style.frame, 0.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(area);
    const std::tuple<double, double, QString> names[] = {
        {0.0, 0.0, words("nose")},   {90.0, 0.0, words("starboard")},
        {180.0, 0.0, words("tail")}, {270.0, 0.0, words("port")},
        {0.0, 90.0, words("top")},   {0.0, -90.0, words("bottom")}};
    for (const auto& [azimuth, elevation, name] : names) {
        const auto on = placeOnBall(azimuth, elevation);
        if (!on)
            continue;
        const QPointF at = placed(*on);
        painter.setPen(QPen(style.text, 0.0));
        painter.setBrush(style.background);
        painter.drawEllipse(at, 0.18 * letter, 0.18 * letter);
        const QFontMetricsF metrics(painter.font(), painter.device());
        QRectF box(0, 0, metrics.horizontalAdvance(name) + 0.6 * letter, 1.15 * letter);
        box.moveCenter(at + QPointF(0, -0.95 * letter));
        QColor plate = style.background;
        plate.setAlphaF(0.75F);
        painter.setPen(Qt::NoPen);
        painter.setBrush(plate);
        painter.drawRoundedRect(box, 0.2 * letter, 0.2 * letter);
        painter.setPen(style.text);
        painter.drawText(box, Qt::AlignCenter, name);
    }
    painter.setBrush(Qt::NoBrush);
}

void TableDrawing::paintBar(QPainter& painter, const QRectF& area, const PlotStyle& style,
                            double letter) const {
    const QRectF bar(area.left(), area.top(), 1.3 * letter, area.height());
    if (bar.height() < 2 * letter)
        return;
    constexpr int steps = 256;
    QImage colors(1, steps, QImage::Format_RGB32);
    for (int i = 0; i < steps; ++i) {
        const irsg::Rgb color = map_->at((steps - 1 - i) / (steps - 1.0));
        colors.setPixel(0, i, qRgb(color.red, color.green, color.blue));
    }
    painter.drawImage(bar, colors);
    painter.setPen(QPen(style.frame, 0.0));
    painter.drawRect(bar);
    painter.setPen(style.text);
    const auto ticks = irsg::axisTicks(limits_, 8);
    for (std::size_t i = 0; i < ticks.values.size(); ++i) {
        const double y = bar.bottom() - limits_.position(ticks.values[i]) * bar.height();
        painter.drawLine(QPointF(bar.right(), y), QPointF(bar.right() + 0.35 * letter, y));
        painter.drawText(
            QRectF(bar.right() + 0.6 * letter, y - 0.6 * letter, 4.2 * letter, 1.2 * letter),
            Qt::AlignLeft | Qt::AlignVCenter, QString::fromStdString(ticks.labels[i]));
    }
    QString name = barTitle();
    if (ticks.exponent != 0)
        name += QStringLiteral(" · 10") + QString::fromStdString(irsg::superscript(ticks.exponent));
    painter.save();
    painter.translate(area.left() + 6.4 * letter, bar.center().y());
    painter.rotate(-90.0);
    painter.drawText(QRectF(-0.5 * bar.height() - 2 * letter, -0.6 * letter,
                            bar.height() + 4 * letter, 1.2 * letter),
                     Qt::AlignCenter, name);
    painter.restore();
}

QString TableDrawing::csv() const {
    QString text = QStringLiteral("azimuth [deg],elevation [deg],%1\n")
                       .arg(QString::fromStdString(column_->header()));
    for (std::size_t i = 0; i < table_.directions().size(); ++i) {
        const auto& at = table_.directions()[i];
        text += exactNumber(at.azimuth_deg) + "," + exactNumber(at.elevation_deg) + "," +
                exactNumber(value(static_cast<int>(i))) + "\n";
    }
    return text;
}

} // namespace smat::gui
