#include "gui/tools/GasPlot.h"

#include <string>
#include <utility>

#include <QCheckBox>
#include <QComboBox>
#include <QVBoxLayout>

#include "gui/plot/CartesianPlot.h"
#include "gui/plot/PlotPanel.h"
#include "gui/plot/ResultPlot.h"
#include "gui/widgets/FlowBar.h"
#include "irsg/core/Quantity.h"

namespace smat::gui {

namespace {

std::string keyOf(irsg::Quantity quantity) {
    return std::string(irsg::info(quantity).key);
}

} // namespace

GasPlot::GasPlot(Dialogs dialogs, QWidget* parent) : QWidget(parent) {
    setObjectName("gasPlot");
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::Base);
    panel_ = new PlotPanel(PlotKind::cartesian, std::move(dialogs), this);
    quantity_ = new QComboBox(panel_);
    quantity_->setObjectName("quantity");
    quantity_->setMinimumWidth(90); // gives way where the page is narrow
    quantity_->setToolTip(tr("Quantity to plot"));
    quantity_->addItem(tr("Spectral radiance"),
                       QString::fromStdString(keyOf(irsg::Quantity::spectralRadiance)));
    quantity_->addItem(tr("Transmittance"),
                       QString::fromStdString(keyOf(irsg::Quantity::transmittance)));
    panel_->addInFront(quantity_);
    parts_ = makeChoice("gasParts", tr("What each gas adds"),
                        tr("The radiance less that of the same layers without this gas: below 0 "
                           "where it hides more than it emits"));
    radcal_ = makeChoice("gasRadcal", tr("RADCAL"),
                         tr("The same layers by the tables of RADCAL, where another source is "
                            "plotted"));
    product_ = makeChoice("gasProduct", tr("Product of means"),
                          tr("Mean radiance times mean transmittance of the atmosphere, without "
                             "the coincidence of their lines"));
    auto* row = new WrappingRow;
    row->setSpacing(14);
    for (QCheckBox* box : {parts_, radcal_, product_})
        row->addWidget(box);
    row->addStretch(1);
    auto* choices = new QVBoxLayout;
    choices->setContentsMargins(8, 6, 8, 0);
    choices->addLayout(row);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addLayout(choices);
    column->addWidget(panel_, 1);
    connect(quantity_, &QComboBox::activated, this, &GasPlot::draw);
}

QCheckBox* GasPlot::makeChoice(const char* name, const QString& text, const QString& tip) {
    auto* box = new QCheckBox(text, this);
    box->setObjectName(name);
    box->setToolTip(tip);
    connect(box, &QCheckBox::toggled, this, &GasPlot::draw);
    return box;
}

void GasPlot::setOutput(GasOutput output) {
    output_ = std::move(output);
    draw();
}

void GasPlot::draw() {
    const ResultTable& table = output_.table;
    if (table.empty())
        return;
    const std::string key = quantity_->currentData().toString().toStdString();
    const bool isRadiance = key == keyOf(irsg::Quantity::spectralRadiance);
    parts_->setEnabled(isRadiance);
    radcal_->setEnabled(isRadiance && !output_.radcal_W_m2_sr_um.empty());
    product_->setEnabled(isRadiance && table.find("spectral_radiance_product") != nullptr);
    PlotData data = cartesianData({{tr("Hot gas"), &table}}, key);
    if (isRadiance)
        addRadiances(data);
    else
        addTransmittances(data);
    // Axes stay as a person has them.
    CartesianPlot* plot = panel_->cartesian();
    data.xLogarithmic = plot->isLogarithmic(QwtPlot::xBottom);
    data.yLogarithmic = plot->isLogarithmic(QwtPlot::yLeft);
    plot->setData(std::move(data));
    panel_->refresh();
}

void GasPlot::addCurve(PlotData& data, const QString& name,
                       const std::vector<double>& values) const {
    data.curves.insert(data.curves.end() - 1,
                       {.name = name, .x = data.curves.back().x, .y = values});
}

void GasPlot::addRadiances(PlotData& data) const {
    data.curves.back().name = tr("all");
    if (parts_->isChecked())
        for (std::size_t emitter = 0; emitter < irsg::gasEmitterCount; ++emitter) {
            const std::string gas = irsg::gasEmitterName(emitter);
            if (const auto* column = output_.table.find("spectral_radiance_added_" + gas))
                addCurve(data, QString::fromStdString(gas), column->values);
        }
    if (radcal_->isEnabled() && radcal_->isChecked())
        addCurve(data, tr("RADCAL"), output_.radcal_W_m2_sr_um);
    if (product_->isEnabled() && product_->isChecked())
        addCurve(data, tr("product of means"),
                 output_.table.find("spectral_radiance_product")->values);
}

void GasPlot::addTransmittances(PlotData& data) const {
    data.curves.back().name = tr("all");
    for (const auto& [key, name] : {std::pair("transmittance_gas", tr("gas")),
                                    std::pair("transmittance_atmosphere", tr("atmosphere"))})
        if (const auto* column = output_.table.find(key))
            addCurve(data, name, column->values);
}

QStringList GasPlot::exportFilters() const {
    return {tr("Scalable picture (*.svg)"), tr("PDF (*.pdf)"), tr("Picture (*.png)")};
}

void GasPlot::exportTo(const std::filesystem::path& file) const {
    panel_->exportTo(file);
}

} // namespace smat::gui

#include "moc_GasPlot.cpp"
