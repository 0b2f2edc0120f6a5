#include "gui/plot/PlotExport.h"

#include <cmath>
#include <functional>
#include <memory>
#include <utility>

#include <QBuffer>
#include <QImage>
#include <QPageSize>
#include <QPainter>
#include <QPdfWriter>
#include <QSvgGenerator>
#include <QwtPlotRenderer>
#include <QwtPolarCanvas>
#include <QwtPolarRenderer>

#include "gui/plot/CartesianPlot.h"
#include "gui/plot/PolarPlot.h"
#include "gui/widgets/DisplayUnits.h"
#include "gui/widgets/ThemeColors.h"
#include "irsg/core/Errors.h"
#include "irsg/core/FileReplacement.h"

namespace smat::gui {
namespace {

using Draw = DrawOnPaper;
constexpr double pixelsPerInch = 96.0;

QRectF withMargin(const QRectF& area) {
    const double margin = 0.02 * area.width();
    return area.adjusted(margin, margin, -margin, -margin);
}

QByteArray asSvg(const QString& title, QSize size, const Draw& draw) {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    QSvgGenerator generator;
    generator.setOutputDevice(&buffer);
    generator.setTitle(title);
    generator.setSize(size);
    generator.setViewBox(QRect(QPoint(0, 0), size));
    generator.setResolution(static_cast<int>(pixelsPerInch));
    QPainter painter(&generator);
    draw(painter, QRectF(QPointF(0, 0), size));
    painter.end();
    return bytes;
}

QByteArray asPdf(const QString& title, QSize size, const Draw& draw) {
    constexpr int resolution = 600;
    constexpr double pointsPerInch = 72.0;
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    QPdfWriter writer(&buffer);
    writer.setTitle(title);
    writer.setCreator("SMAT");
    writer.setResolution(resolution);
    writer.setPageSize(QPageSize(QSizeF(size) * pointsPerInch / pixelsPerInch, QPageSize::Point));
    writer.setPageMargins({});
    QPainter painter(&writer);
    draw(painter, QRectF(QPointF(0, 0), QSizeF(size) * resolution / pixelsPerInch));
    painter.end();
    return bytes;
}

QImage asImage(QSize size, const Draw& draw) {
    constexpr int scale = 2;
    constexpr double inchesPerMetre = 39.3700787;
    QImage image(size * scale, QImage::Format_RGB32);
    image.fill(colors::paper());
    image.setDotsPerMeterX(qRound(scale * pixelsPerInch * inchesPerMetre));
    image.setDotsPerMeterY(qRound(scale * pixelsPerInch * inchesPerMetre));
    QPainter painter(&image);
    painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
    draw(painter, QRectF(QPointF(0, 0), size * scale));
    painter.end();
    return image;
}

QByteArray asPng(QSize size, const Draw& draw) {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    asImage(size, draw).save(&buffer, "PNG");
    return bytes;
}

void exportAs(const std::filesystem::path& file, const QString& title, QSize size,
              const std::function<QString()>& csv, const Draw& draw) {
    const QString suffix = QString::fromStdString(file.extension().string()).toLower();
    if (suffix == ".svg")
        writePlotFile(file, asSvg(title, size, draw));
    else if (suffix == ".pdf")
        writePlotFile(file, asPdf(title, size, draw));
    else if (suffix == ".png")
        writePlotFile(file, asPng(size, draw));
    else if (suffix == ".csv")
        writePlotFile(file, csv().toUtf8());
    else
        throw irsg::InputError({file.string(), "", "suffix \"" + suffix.toStdString() + "\"",
                                ".svg, .pdf, .png or .csv"});
}

/// Hands `work` what draws a plot on paper.
template <typename Work>
auto onPaper(const CartesianPlot& plot, QSize size, const Work& work) {
    const std::unique_ptr<CartesianPlot> twin(plot.makePrintCopy());
    twin->resize(size);
    return work([&](QPainter& painter, const QRectF& area) {
        painter.fillRect(area, colors::paper());
        QwtPlotRenderer renderer;
        renderer.setDiscardFlag(QwtPlotRenderer::DiscardBackground);
        renderer.render(twin.get(), &painter, withMargin(area));
    });
}
template <typename Work>
auto onPaper(const PolarPlot& plot, QSize size, const Work& work) {
    const std::unique_ptr<PolarPlot> twin(plot.makePrintCopy());
    twin->resize(size);
    return work([&](QPainter& painter, const QRectF& area) {
        painter.fillRect(area, colors::paper());
        QwtPolarRenderer renderer;
        renderer.render(twin.get(), &painter, withMargin(area));
    });
}

template <typename Plot>
std::vector<Curve> curvesOf(const Plot& plot, PlotPart part) {
    std::vector<Curve> curves;
    for (std::size_t i = 0; i < plot.stored().curves.size(); ++i)
        if (part == PlotPart::all || plot.isCurveVisible(static_cast<int>(i)))
            curves.push_back(plot.stored().curves[i]);
    return curves;
}

template <typename Plot>
void exportPlotAs(const Plot& plot, const std::filesystem::path& file, QSize size) {
    const auto csv = [&] { return plotValues(plot, PlotPart::visible); };
    onPaper(plot, size,
            [&](const Draw& draw) { exportAs(file, plot.data().title, size, csv, draw); });
}

} // namespace

void writePlotFile(const std::filesystem::path& file, const QByteArray& bytes) {
    irsg::writeFileDurably(
        file, std::string_view(bytes.constData(), static_cast<std::size_t>(bytes.size())));
}

void exportDrawing(const std::filesystem::path& file, const QString& title, QSize size,
                   const std::function<QString()>& csv, const DrawOnPaper& draw) {
    exportAs(file, title, size, csv, draw);
}

QImage drawnPicture(QSize size, const DrawOnPaper& draw) {
    return asImage(size, draw);
}

void exportPlot(const CartesianPlot& plot, const std::filesystem::path& file, QSize size) {
    exportPlotAs(plot, file, size);
}

void exportPlot(const PolarPlot& plot, const std::filesystem::path& file, QSize size) {
    exportPlotAs(plot, file, size);
}

QImage plotPicture(const CartesianPlot& plot, QSize size) {
    return onPaper(plot, size, [&](const Draw& draw) { return asImage(size, draw); });
}

QImage plotPicture(const PolarPlot& plot, QSize size) {
    return onPaper(plot, size, [&](const Draw& draw) { return asImage(size, draw); });
}

QByteArray plotSvg(const CartesianPlot& plot, QSize size) {
    return onPaper(plot, size,
                   [&](const Draw& draw) { return asSvg(plot.data().title, size, draw); });
}

QByteArray plotSvg(const PolarPlot& plot, QSize size) {
    return onPaper(plot, size,
                   [&](const Draw& draw) { return asSvg(plot.data().title, size, draw); });
}

namespace {

/// What the results warn of, as lines above their values in a file: a spreadsheet gets cells alone.
QString headOf(const QStringList& warnings, QChar separator) {
    QString head;
    for (const QString& warning : warnings)
        if (separator == ',')
            head += QStringLiteral("# warning: %1\n").arg(QString(warning).replace('\n', ' '));
    return head;
}

} // namespace

QString plotValues(const CartesianPlot& plot, PlotPart part, QChar separator) {
    std::optional<Interval> within;
    if (part == PlotPart::visible)
        within = plot.view().x;
    if (const ShownUnit* x = shownUnitOf(plot.stored().xUnit); within && x != nullptr) {
        within = Interval{x->back(within->minimum), x->back(within->maximum)};
        if (x->isReversed)
            std::swap(within->minimum, within->maximum);
        // Back and forth leaves the last bits of the ends.
        const double slack = 1e-12 * std::abs(within->maximum);
        within = Interval{within->minimum - slack, within->maximum + slack};
    }
    return headOf(plot.data().warnings, separator) + toCsv(curvesOf(plot, part),
                                                           plot.stored().xTitle,
                                                           plot.stored().yTitle, within, separator);
}

QString plotValues(const PolarPlot& plot, PlotPart part, QChar separator) {
    std::vector<Curve> curves = curvesOf(plot, part);
    if (part == PlotPart::visible && plot.zoomFactor() < 1.0) {
        // A zoomed circle shows no interval of angles but a window.
        const QRectF window = plot.canvas()->rect();
        const ShownUnit* radius =
            plot.canBeDecibel() ? nullptr : shownUnitOf(plot.stored().radiusUnit);
        for (auto& curve : curves) {
            Curve seen{curve.name, {}, {}};
            for (std::size_t i = 0; i < curve.x.size(); ++i) {
                const double shown = radius == nullptr ? curve.y[i] : radius->shown(curve.y[i]);
                if (!window.contains(plot.canvasPoint(curve.x[i], shown)))
                    continue;
                seen.x.push_back(curve.x[i]);
                seen.y.push_back(curve.y[i]);
                if (!curve.error.empty())
                    seen.error.push_back(curve.error[i]);
                if (curve.isLayer())
                    seen.base.push_back(curve.base[i]);
                if (!curve.warnings.empty())
                    seen.warnings.push_back(curve.warnings[i]);
            }
            curve = std::move(seen);
        }
    }
    return headOf(plot.data().warnings, separator) +
           toCsv(curves, QStringLiteral("Angle (°)"), plot.stored().radiusTitle, {}, separator);
}

} // namespace smat::gui
