#include "gui/image/PaperPicture.h"

#include <algorithm>
#include <cmath>

#include <QFontMetricsF>
#include <QPainter>

#include "gui/image/ColorBar.h"
#include "gui/image/ImageExport.h"
#include "gui/image/IndexLegend.h"
#include "gui/plot/PlotLook.h"

namespace smat::gui {
namespace {

constexpr double margin = 14.0, gap = 14.0;
constexpr double barWidth = 124.0, leastBarHeight = 240.0;
constexpr double large = 1400.0; ///< such pictures have text of twice the size
constexpr int comfortable = 360; ///< height of a plane that is not enlarged

int magnificationOf(const QSize& pixels) {
    return std::max(1, std::min((comfortable + pixels.height() - 1) / pixels.height(),
                                6 * comfortable / pixels.width()));
}

} // namespace

QImage onPaper(const PaperPicture& parts) {
    const PlotStyle style = PlotStyle::paper();
    const double ratio = parts.picture.devicePixelRatio();
    const QSizeF inside = QSizeF(parts.picture.size()) / ratio;
    const double scale = std::max(inside.width(), inside.height()) > large ? 2.0 : 1.0;
    const QFont titleFont = plotFont(1.1 * scale, true), font = plotFont(0.9 * scale);
    const double titleHeight =
        parts.title.isEmpty() ? 0.0 : 1.3 * QFontMetricsF(titleFont).height();
    const double lineHeight = parts.conditions.isEmpty() ? 0.0 : 1.5 * QFontMetricsF(font).height();

    const double edge = margin * scale, top = edge + titleHeight + lineHeight;
    const bool hasLegend = parts.bar != nullptr || parts.legend != nullptr;
    const double bar = !hasLegend ? 0.0 : (gap + barWidth) * scale;
    const double words = std::max(QFontMetricsF(titleFont).horizontalAdvance(parts.title),
                                  QFontMetricsF(font).horizontalAdvance(parts.conditions));
    const double height = std::max(inside.height(), !hasLegend ? 0.0 : leastBarHeight * scale);
    const QSizeF whole(2.0 * edge + std::max(inside.width() + bar, words), top + height + edge);

    QImage page((whole * ratio).toSize(), QImage::Format_RGB32);
    page.setDevicePixelRatio(ratio);
    page.fill(style.background);
    QPainter painter(&page);
    painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
    const auto line = [&](double y, double lineHeight, const QFont& with, const QColor& color,
                          const QString& text) {
        painter.setFont(with);
        painter.setPen(color);
        painter.drawText(QRectF(edge, y, whole.width() - 2.0 * edge, lineHeight),
                         Qt::AlignLeft | Qt::AlignTop | Qt::TextSingleLine, text);
    };
    line(edge, titleHeight, titleFont, style.text, parts.title);
    line(edge + titleHeight, lineHeight, font, style.faintText, parts.conditions);

    // On whole pixels of the page, so that those of the picture stay as they are.
    const QPointF corner(std::round(edge * ratio) / ratio, std::round(top * ratio) / ratio);
    painter.drawImage(corner, parts.picture);
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setPen(style.frame);
    const double pixel = 1.0 / ratio;
    painter.drawRect(QRectF(corner - QPointF(pixel, pixel), inside + QSizeF(pixel, pixel)));
    if (hasLegend) {
        painter.translate(corner.x() + inside.width() + gap * scale, corner.y());
        painter.scale(scale, scale);
        const QSize room = QSizeF(barWidth, height / scale).toSize();
        if (parts.bar != nullptr)
            parts.bar->drawLegend(painter, room, style, plotFont(0.95));
        else
            parts.legend->drawLegend(painter, room, style, plotFont(0.95));
    }
    return page;
}

QImage enlargedPlane(const irsg::RadianceImage& image, const irsg::ImageChannel& plane,
                     const ColorBar& bar) {
    irsg::PngViewOptions options;
    options.colorMap = bar.map().name();
    options.limits = bar.limits();
    options.colorBar = false;
    options.magnification = magnificationOf({image.width(), image.height()});
    return pictureOf(image, plane, options);
}

QImage enlarged(const QImage& picture) {
    return picture.scaled(picture.size() * magnificationOf(picture.size()));
}

} // namespace smat::gui
