#pragma once

#include <filesystem>
#include <optional>

#include <QImage>
#include <QString>
#include <QStringList>

#include "irsg/image/ImageFormat.h"
#include "irsg/image/ImageStatistics.h"
#include "irsg/image/PngView.h"
#include "irsg/image/RadianceImage.h"

namespace smat::gui {

/// Writes an image in the format of the file's extension, with `channel` where that keeps one plane
/// and as a view where it is a picture. Throws irsg::InputError for another suffix and for a file
/// that cannot be written.
void exportImage(const irsg::RadianceImage& image, const std::string& channel,
                 const irsg::PngViewOptions& view, const std::filesystem::path& file);

/// "OpenEXR image (*.exr)" of each format that images are written in, for file dialogs.
QStringList imageFilters();
QString filterOf(const irsg::ImageFormat& format);
/// "*.exr *.csv *.txt": of all files that images are read from, and of those that results are.
QString readableImagePatterns();
QString readableResultPatterns();

/// Writes a picture as PNG. Throws irsg::InputError for another suffix and for a file that cannot
/// be written; what was there is then as it was.
void writePicture(const QImage& picture, const std::filesystem::path& file);

/// The view of a plane as a picture.
QImage pictureOf(const irsg::RadianceImage& image, const irsg::ImageChannel& plane,
                 const irsg::PngViewOptions& view);

/// The values of a plane or of its rectangle, separated by tabs, a row a line, top row first, as
/// they go into a spreadsheet; 9 significant digits.
QString valuesText(const irsg::RadianceImage& image, const irsg::ImageChannel& plane,
                   const std::optional<irsg::PixelRectangle>& rectangle);

/// "Radiance" of channel L, "Apparent temperature", else the channel's own name in words.
QString planeTitle(const irsg::ImageChannel& channel);
/// "Radiance (W·m⁻²·sr⁻¹)".
QString titleWithUnit(const irsg::ImageChannel& channel);
/// A strip of the colours, for a list of maps.
QPixmap swatchOf(const irsg::ColorMap& map);

} // namespace smat::gui
