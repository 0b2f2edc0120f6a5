#include "gui/plot/PlotExport.h"

#include <functional>
#include <memory>

#include <QBuffer>
#include <QImage>
#include <QPageSize>
#include <QPainter>
#include <QPdfWriter>
#include <QSaveFile>
#include <QSvgGenerator>
#include <QwtPlotRenderer>
#include <QwtPolarRenderer>

#include "gui/plot/CartesianPlot.h"
#include "gui/plot/PolarPlot.h"
#include "irsg/radiometry/Errors.h"

namespace smat::gui {
namespace {

using Draw = std::function<void(QPainter&, const QRectF&)>;
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

QByteArray asPng(QSize size, const Draw& draw) {
    constexpr int scale = 2;
    constexpr double inchesPerMetre = 39.3700787;
    QImage image(size * scale, QImage::Format_RGB32);
    image.fill(Qt::white);
    image.setDotsPerMeterX(qRound(scale * pixelsPerInch * inchesPerMetre));
    image.setDotsPerMeterY(qRound(scale * pixelsPerInch * inchesPerMetre));
    QPainter painter(&image);
    painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
    draw(painter, QRectF(QPointF(0, 0), size * scale));
    painter.end();
    QByteArray bytes;
    QBuffer buffer(&bytes);
    image.save(&buffer, "PNG");
    return bytes;
}

void write(const std::filesystem::path& file, const QByteArray& bytes) {
    QSaveFile out(QString::fromStdString(file.string()));
    if (!out.open(QIODevice::WriteOnly) || out.write(bytes) != bytes.size() || !out.commit())
        throw irsg::InputError(
            {file.string(), "", out.errorString().toStdString(), "a file that can be written"});
}

void exportAs(const std::filesystem::path& file, const QString& title, QSize size,
              const std::function<QString()>& csv, const Draw& draw) {
    const QString suffix = QString::fromStdString(file.extension().string()).toLower();
    if (suffix == ".svg")
        write(file, asSvg(title, size, draw));
    else if (suffix == ".pdf")
        write(file, asPdf(title, size, draw));
    else if (suffix == ".png")
        write(file, asPng(size, draw));
    else if (suffix == ".csv")
        write(file, csv().toUtf8());
    else
        throw irsg::InputError({file.string(), "", "suffix \"" + suffix.toStdString() + "\"",
                                ".svg, .pdf, .png or .csv"});
}

} // namespace

void exportPlot(const CartesianPlot& plot, const std::filesystem::path& file, QSize size) {
    const std::unique_ptr<CartesianPlot> twin(plot.makePaperTwin());
    twin->resize(size);
    const auto csv = [&] {
        const auto& data = plot.data();
        std::vector<Curve> seen;
        for (std::size_t i = 0; i < data.curves.size(); ++i) {
            if (plot.isCurveVisible(static_cast<int>(i)))
                seen.push_back(data.curves[i]);
        }
        return toCsv(seen, data.xTitle, data.yTitle, plot.view().x);
    };
    exportAs(file, plot.data().title, size, csv, [&](QPainter& painter, const QRectF& area) {
        painter.fillRect(area, Qt::white);
        QwtPlotRenderer renderer;
        renderer.setDiscardFlag(QwtPlotRenderer::DiscardBackground);
        renderer.render(twin.get(), &painter, withMargin(area));
    });
}

void exportPlot(const PolarPlot& plot, const std::filesystem::path& file, QSize size) {
    const std::unique_ptr<PolarPlot> twin(plot.makePaperTwin());
    twin->resize(size);
    const auto csv = [&] {
        std::vector<Curve> seen;
        for (std::size_t i = 0; i < plot.data().curves.size(); ++i) {
            if (plot.isCurveVisible(static_cast<int>(i)))
                seen.push_back(plot.data().curves[i]);
        }
        return toCsv(seen, QStringLiteral("Angle (°)"), plot.data().radiusTitle);
    };
    exportAs(file, plot.data().title, size, csv, [&](QPainter& painter, const QRectF& area) {
        painter.fillRect(area, Qt::white);
        QwtPolarRenderer renderer;
        renderer.render(twin.get(), &painter, withMargin(area));
    });
}

} // namespace smat::gui
