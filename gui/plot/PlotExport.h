#pragma once

#include <filesystem>
#include <functional>

#include <QByteArray>
#include <QImage>
#include <QSize>

class QPainter;
class QRectF;

namespace smat::gui {

class CartesianPlot;
class PolarPlot;

/// Size of a plot on paper, pixels of 1/96 inch.
inline constexpr QSize cartesianPaper{900, 600};
inline constexpr QSize polarPaper{760, 800};

/// Writes the plot as it is seen, black on white: .svg, .pdf, .png (at twice the size in pixels),
/// or the visible part of its numbers as .csv. The suffix of the file chooses. Throws
/// irsg::InputError for another suffix or a file that cannot be written; a file already there is
/// then left alone.
void exportPlot(const CartesianPlot& plot, const std::filesystem::path& file,
                QSize size = cartesianPaper);
void exportPlot(const PolarPlot& plot, const std::filesystem::path& file, QSize size = polarPaper);

/// The same picture as .png has.
QImage plotPicture(const CartesianPlot& plot, QSize size = cartesianPaper);
QImage plotPicture(const PolarPlot& plot, QSize size = polarPaper);
QByteArray plotSvg(const CartesianPlot& plot, QSize size = cartesianPaper);
QByteArray plotSvg(const PolarPlot& plot, QSize size = polarPaper);

enum class PlotPart {
    all,
    visible ///< curves that are not hidden, and of them what lies in the view
};
/// The numbers as text, see toCsv.
QString plotValues(const CartesianPlot& plot, PlotPart part, QChar separator = ',');
QString plotValues(const PolarPlot& plot, PlotPart part, QChar separator = ',');

/// The same of anything that paints itself into an area, black on white.
using DrawOnPaper = std::function<void(QPainter&, const QRectF&)>;
void exportDrawing(const std::filesystem::path& file, const QString& title, QSize size,
                   const std::function<QString()>& csv, const DrawOnPaper& draw);
QImage drawnPicture(QSize size, const DrawOnPaper& draw);

/// Throws irsg::InputError; a file already there is then left alone.
void writePlotFile(const std::filesystem::path& file, const QByteArray& bytes);

} // namespace smat::gui
