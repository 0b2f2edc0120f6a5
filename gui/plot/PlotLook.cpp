#include "gui/plot/PlotLook.h"

#include <QApplication>
#include <QwtLegend>
#include <QwtPlot>
#include <QwtScaleDraw>
#include <QwtScaleWidget>

namespace smat::gui {

QFont plotFont(double scale, bool bold) {
    QFont font = QApplication::font();
    font.setPointSizeF(font.pointSizeF() * scale);
    font.setBold(bold);
    return font;
}

QwtText plotTitle(const QString& text, const PlotStyle& style) {
    QwtText result(text, QwtText::PlainText);
    result.setFont(plotFont(1.1, true));
    result.setColor(style.text);
    return result;
}

QwtText axisText(const QString& text, const PlotStyle& style) {
    QwtText result(text, QwtText::PlainText);
    result.setFont(plotFont());
    result.setColor(style.text);
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
        plot.setAxisFont(axis, plotFont(0.95));
        auto* draw = plot.axisScaleDraw(axis);
        draw->enableComponent(QwtAbstractScaleDraw::Backbone, true);
        draw->setTickLength(QwtScaleDiv::MinorTick, 3.0);
        draw->setTickLength(QwtScaleDiv::MediumTick, 4.0);
        draw->setTickLength(QwtScaleDiv::MajorTick, 6.0);
        draw->setSpacing(5.0);
        plot.axisWidget(axis)->setMargin(0);
        plot.axisWidget(axis)->setSpacing(8);
    }
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
