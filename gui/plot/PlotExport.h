#pragma once

#include <filesystem>

#include <QSize>

namespace smat::gui {

class CartesianPlot;
class PolarPlot;

/// Writes the plot as it is seen, black on white: .svg, .pdf, .png (at twice the size in pixels),
/// or the visible part of its numbers as .csv. The suffix of the file chooses. Throws
/// irsg::InputError for another suffix or a file that cannot be written; a file already there is
/// then left alone. `size` is in pixels of 1/96 inch.
void exportPlot(const CartesianPlot& plot, const std::filesystem::path& file,
                QSize size = {900, 600});
void exportPlot(const PolarPlot& plot, const std::filesystem::path& file, QSize size = {760, 800});

} // namespace smat::gui
