#include "gui/atmosphere/AtmospherePlots.h"

#include <algorithm>

#include <QBoxLayout>
#include <QEvent>

#include "gui/plot/CartesianPlot.h"
#include "gui/widgets/NumberFormat.h"
#include "gui/widgets/Theme.h"

namespace smat::gui {
namespace {

constexpr int besideFrom_px = 820; ///< wide enough for profiles beside spectra

/// The same part stays in view where a person has chosen one.
void showIn(CartesianPlot& plot, PlotData data) {
    const bool isZoomed = plot.canUndoZoom();
    const CartesianPlot::View view = plot.view();
    plot.setData(std::move(data));
    if (isZoomed) {
        plot.rememberView();
        plot.setView(view);
    }
    plot.replot();
}

} // namespace

AtmospherePlots::AtmospherePlots(QWidget* parent) : QWidget(parent) {
    setObjectName("airPlots");
    all_ = new QBoxLayout(QBoxLayout::TopToBottom, this);
    all_->setContentsMargins(12, 0, 12, 0);
    all_->setSpacing(4);
    auto* spectra = new QVBoxLayout;
    spectra->setSpacing(2);
    transmittance_ = addPlot(*spectra, "airTransmittance");
    radiance_ = addPlot(*spectra, "airPathRadiance");
    profiles_ = new QBoxLayout(QBoxLayout::LeftToRight);
    profiles_->setSpacing(4);
    temperature_ = addPlot(*profiles_, "airTemperature");
    humidity_ = addPlot(*profiles_, "airHumidity");
    all_->addLayout(spectra, 5);
    all_->addLayout(profiles_, 3);
    clear();
    showColumn({});
}

CartesianPlot* AtmospherePlots::addPlot(QBoxLayout& layout, const char* name) {
    auto* plot = new CartesianPlot(PlotStyle::screen(palette()), this);
    plot->setObjectName(name);
    plot->setMinimumSize(140, 140); // as high as "Transmittance" is long
    layout.addWidget(plot, 1);
    return plot;
}

void AtmospherePlots::showSpectra(const AtmosphereSpectra& spectra) {
    spectra_ = spectra;
    const QString wavelength = tr("Wavelength (µm)");
    showIn(*transmittance_,
           {.title = {},
            .xTitle = {}, // that of the plot below
            .yTitle = tr("Transmittance"),
            .curves = {{tr("Transmittance, mean %1").arg(spectra.meanTransmittance, 0, 'f', 4),
                        spectra.wavelength_um, spectra.transmittance}},
            .xUnit = "um"});
    showIn(*radiance_, {.title = {},
                        .xTitle = wavelength,
                        .yTitle = tr("Path radiance"),
                        .curves = {{tr("%1, in band %2 %3")
                                        .arg(formattedUnit("W m-2 sr-1 um-1"))
                                        .arg(spectra.inBandPathRadiance_W_m2_sr, 0, 'g', 4)
                                        .arg(formattedUnit("W m-2 sr-1")),
                                    spectra.wavelength_um, spectra.pathRadiance_W_m2_sr_um}},
                        .xUnit = "um"});
}

void AtmospherePlots::showColumn(const AtmosphereProfile& column) {
    column_ = column;
    // Altitude goes up, as everybody draws it. What a lone curve is stands at its axis.
    const auto showProfile = [&](CartesianPlot& plot, const QString& name,
                                 const std::vector<double>& values) {
        showIn(plot, {.title = {},
                      .xTitle = name,
                      .yTitle = &plot == temperature_ ? tr("Altitude (km)") : QString(),
                      .curves = {{name, values, column.altitude_km}}});
    };
    showProfile(*temperature_, tr("Air (°C)"), column.temperature_C);
    showProfile(*humidity_, tr("Humidity (%)"), column.relativeHumidity_percent);
}

void AtmospherePlots::clear() {
    spectra_ = {};
    transmittance_->setData(
        {.title = {}, .xTitle = {}, .yTitle = tr("Transmittance"), .curves = {}});
    radiance_->setData({.title = {},
                        .xTitle = tr("Wavelength (µm)"),
                        .yTitle = tr("Path radiance"),
                        .curves = {}});
    for (CartesianPlot* plot : {transmittance_, radiance_})
        plot->replot();
}

void AtmospherePlots::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange && humidity_ != nullptr)
        for (CartesianPlot* plot : {transmittance_, radiance_, temperature_, humidity_})
            plot->setLook(PlotStyle::screen(palette()));
}

void AtmospherePlots::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    const bool beside = width() >= besideFrom_px;
    all_->setDirection(beside ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
    profiles_->setDirection(beside ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
    // Numbers of an axis need their place.
    const int labels = std::max(2, (beside ? width() / 2 : width() / 2 - 70) / 45);
    for (CartesianPlot* plot : {temperature_, humidity_})
        plot->setAxisMaxMajor(QwtAxis::XBottom, std::min(labels, 8));
}

} // namespace smat::gui

#include "moc_AtmospherePlots.cpp"
