#include "gui/image/ImageExport.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

#include <QBuffer>
#include <QPainter>
#include <QPixmap>

#include "gui/widgets/NumberFormat.h"
#include "irsg/core/Errors.h"
#include "irsg/core/FileReplacement.h"
#include "irsg/image/ApparentTemperature.h"
#include "irsg/image/ImageFormat.h"
#include "smatcore/analysis/ResultFile.h"

namespace smat::gui {
namespace {

/// "*.tif *.tiff".
QString patternsOf(const std::vector<std::string>& extensions) {
    QString patterns;
    for (const std::string& extension : extensions)
        patterns += (patterns.isEmpty() ? "*" : " *") + QString::fromStdString(extension);
    return patterns;
}

} // namespace

void exportImage(const irsg::RadianceImage& image, const std::string& channel,
                 const irsg::PngViewOptions& view, const std::filesystem::path& file) {
    irsg::writeImageFile(image, file, {.channel = channel, .view = view});
}

QStringList imageFilters() {
    QStringList filters;
    for (const irsg::ImageFormat* format : irsg::imageFormats())
        filters += filterOf(*format);
    return filters;
}

QString filterOf(const irsg::ImageFormat& format) {
    return QStringLiteral("%1 (%2)").arg(QString::fromUtf8(format.name),
                                         patternsOf(format.extensionList()));
}

QString readableImagePatterns() {
    return patternsOf(irsg::readableImageExtensions());
}

QString readableResultPatterns() {
    return patternsOf(readableResultExtensions());
}

void writePicture(const QImage& picture, const std::filesystem::path& file) {
    const std::string suffix = file.extension().string();
    if (suffix != ".png")
        throw irsg::InputError({file.string(), "", "the ending '" + suffix + "'", ".png"});
    QByteArray bytes;
    QBuffer buffer(&bytes);
    if (!picture.save(&buffer, "PNG"))
        throw irsg::LogicError("a picture cannot be made into a PNG");
    irsg::writeFileDurably(
        file, std::string_view(bytes.constData(), static_cast<std::size_t>(bytes.size())));
}

QImage pictureOf(const irsg::RadianceImage& image, const irsg::ImageChannel& plane,
                 const irsg::PngViewOptions& view) {
    const irsg::Canvas canvas = irsg::renderView(image, plane, view);
    return QImage(canvas.bytes().data(), canvas.width(), canvas.height(),
                  static_cast<qsizetype>(3) * canvas.width(), QImage::Format_RGB888)
        .copy();
}

QString valuesText(const irsg::RadianceImage& image, const irsg::ImageChannel& plane,
                   const std::optional<irsg::PixelRectangle>& rectangle) {
    const irsg::PixelRectangle area = irsg::checkedRectangle(image, rectangle);
    std::string text;
    for (int y = area.y; y < area.y + area.height; ++y)
        for (int x = area.x; x < area.x + area.width; ++x) {
            const float value = plane.values[image.offset(x, y)];
            std::array<char, 32> digits;
            const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value,
                                           std::chars_format::general, 9)
                                 .ptr;
            if (std::isnan(value))
                text += "nan";
            else
                text.append(digits.data(), end);
            text += x + 1 < area.x + area.width ? '\t' : '\n';
        }
    return QString::fromStdString(text);
}

QString planeTitle(const irsg::ImageChannel& channel) {
    if (channel.name == "L")
        return QStringLiteral("Radiance");
    if (channel.name == irsg::apparentTemperatureChannel || channel.name == "T")
        return QStringLiteral("Apparent temperature");
    if (channel.name == "E")
        return QStringLiteral("Irradiance");
    QString words = QString::fromStdString(channel.name).replace('_', ' ');
    if (!words.isEmpty())
        words[0] = words[0].toUpper();
    return words;
}

QString titleWithUnit(const irsg::ImageChannel& channel) {
    const QString unit = formattedUnit(channel.unit);
    return planeTitle(channel) + (unit.isEmpty() ? QString() : " (" + unit + ")");
}

QPixmap swatchOf(const irsg::ColorMap& map) {
    QPixmap pixmap(56, 14);
    QPainter painter(&pixmap);
    for (int x = 0; x < pixmap.width(); ++x) {
        const irsg::Rgb color = map.at((x + 0.5) / pixmap.width());
        painter.fillRect(x, 0, 1, pixmap.height(), QColor(color.red, color.green, color.blue));
    }
    return pixmap;
}

} // namespace smat::gui
