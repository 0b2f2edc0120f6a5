#include "gui/plot/PlotLook.h"

#include <algorithm>
#include <cmath>

#include <QApplication>
#include <QFontDatabase>
#include <QFontInfo>
#include <QwtLegend>
#include <QwtPlot>
#include <QwtScaleDraw>
#include <QwtScaleWidget>

#include "irsg/core/Errors.h"
#include "irsg/image/AxisTicks.h"
#include "irsg/image/PictureFont.h"

namespace smat::gui {

namespace {

/// Makes the font of pictures known to Qt and tells its family.
QString pictureFamily() {
    QString family;
    for (const auto weight : {irsg::FontWeight::bold, irsg::FontWeight::regular}) {
        const std::string_view file = irsg::fontFile(weight);
        const int id = QFontDatabase::addApplicationFontFromData(
            QByteArray::fromRawData(file.data(), static_cast<qsizetype>(file.size())));
        const QStringList families = QFontDatabase::applicationFontFamilies(id);
        if (families.isEmpty())
            throw irsg::LogicError("Qt cannot read the font of pictures");
        family = families.front();
    }
    return family;
}

} // namespace

QFont plotFont(double scale, bool bold) {
    static const QString family = pictureFamily();
    const QFont words = QApplication::font();
    QFont font(family);
    // In pixels, so that a painter of another resolution scales it like every other length.
    font.setPixelSize(qRound(QFontInfo(words).pixelSize() * scale));
    font.setBold(bold);
    font.setHintingPreference(QFont::PreferVerticalHinting); // whatever the machine prefers
    return font;
}

QString axisNumber(double value) {
    const double size = std::abs(value);
    if (value == 0.0 || (size >= 1e-3 && size < 1e6))
        return QString::number(value, 'g', 7);
    const int exponent = static_cast<int>(std::floor(std::log10(size) + 1e-9));
    const QString factor = QString::number(value / std::pow(10.0, exponent), 'g', 4);
    const QString power =
        QStringLiteral("10") + QString::fromStdString(irsg::superscript(exponent));
    return factor == "1" ? power : factor == "-1" ? "-" + power : factor + "·" + power;
}

QwtText NumberLabels::label(double value) const {
    return QwtText(axisNumber(value), QwtText::PlainText);
}

QwtScaleDiv ReadableLogScale::divideScale(double x1, double x2, int maxMajorSteps,
                                          int maxMinorSteps, double stepSize) const {
    const double low = std::min(x1, x2);
    const double high = std::max(x1, x2);
    const bool fewDecades = low > 0.0 && high / low > 8.0 && high / low < 2000.0;
    if (!fewDecades)
        return QwtLogScaleEngine::divideScale(x1, x2, maxMajorSteps, maxMinorSteps, stepSize);
    QList<double> major, minor;
    for (double decade = std::pow(10.0, std::floor(std::log10(low))); decade <= high;
         decade *= 10.0) {
        for (int digit = 1; digit <= 9; ++digit) {
            const double tick = digit * decade;
            if (tick < low * (1.0 - 1e-9) || tick > high * (1.0 + 1e-9))
                continue;
            (digit == 1 || digit == 2 || digit == 5 ? major : minor) << tick;
        }
    }
    return QwtScaleDiv(x1, x2, minor, {}, major);
}

QwtText plotTitle(const QString& text, const QString& conditions, const PlotStyle& style) {
    QwtText result(text, QwtText::PlainText);
    result.setFont(plotFont(1.1, true));
    if (!conditions.isEmpty()) {
        result.setText(QStringLiteral("<div align=\"center\"><b>%1</b><br>"
                                      "<span style=\"color:%2; font-size:%3px\">%4</span></div>")
                           .arg(text.toHtmlEscaped(), style.faintText.name())
                           .arg(plotFont(0.9).pixelSize())
                           .arg(conditions.toHtmlEscaped().replace('\n', "<br>")),
                       QwtText::RichText);
        result.setFont(plotFont(1.1));
    }
    result.setColor(style.text);
    result.setRenderFlags(Qt::AlignCenter | Qt::TextWordWrap); // in a narrow window
    return result;
}

QwtText axisText(const QString& text, const PlotStyle& style) {
    QwtText result(text, QwtText::PlainText);
    result.setFont(plotFont());
    result.setColor(style.text);
    result.setRenderFlags(Qt::AlignHCenter | Qt::TextWordWrap); // along a short axis
    return result;
}

void dressPlot(QwtPlot& plot, const PlotStyle& style) {
    QPalette palette = plot.palette();
    palette.setColor(QPalette::Window, style.background);
    palette.setColor(QPalette::WindowText, style.frame);
    palette.setColor(QPalette::Text, style.text);
    palette.setColor(QPalette::Dark, style.frame);
    plot.setPalette(palette);
    plot.setAutoFillBackground(true);
    plot.setContentsMargins(12, 10, 16, 10);
    for (const int axis : {QwtPlot::xBottom, QwtPlot::yLeft}) {
        plot.setAxisScaleDraw(axis, new NumberLabels);
        plot.setAxisFont(axis, plotFont(0.95));
        auto* draw = plot.axisScaleDraw(axis);
        draw->enableComponent(QwtAbstractScaleDraw::Backbone, true);
        draw->setTickLength(QwtScaleDiv::MinorTick, 3.0);
        draw->setTickLength(QwtScaleDiv::MediumTick, 4.0);
        draw->setTickLength(QwtScaleDiv::MajorTick, 6.0);
        draw->setSpacing(5.0);
        // Room for the widest usual number, so that the canvas does not shift while zooming.
        if (axis == QwtPlot::yLeft)
            draw->setMinimumExtent(QFontMetricsF(plotFont(0.95)).horizontalAdvance("0.0000") +
                                   12.0);
        plot.axisWidget(axis)->setMargin(0);
        plot.axisWidget(axis)->setSpacing(8);
    }
    plot.axisWidget(QwtPlot::xBottom)->setMinBorderDist(28, 28);
    plot.axisWidget(QwtPlot::yLeft)->setMinBorderDist(8, 8);
}

void dressLegend(QwtLegend& legend, const PlotStyle& style) {
    QPalette palette = legend.palette();
    palette.setColor(QPalette::Window, style.background);
    palette.setColor(QPalette::WindowText, style.text);
    palette.setColor(QPalette::Text, style.text);
    palette.setColor(QPalette::ButtonText, style.text);
    legend.setPalette(palette);
    legend.setFont(plotFont());
    legend.setDefaultItemMode(QwtLegendData::Clickable);
    legend.setFrameStyle(QFrame::NoFrame);
}

} // namespace smat::gui
