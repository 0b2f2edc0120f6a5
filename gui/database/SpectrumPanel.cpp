#include "gui/database/SpectrumPanel.h"

#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QEvent>
#include <QFormLayout>
#include <QHeaderView>
#include <QTabWidget>
#include <QTableView>
#include <QToolButton>
#include <QVBoxLayout>

#include "gui/Readable.h"
#include "gui/Theme.h"
#include "gui/Widgets.h"
#include "gui/database/NumberField.h"
#include "gui/database/SpectrumTableModel.h"
#include "gui/plot/CartesianPlot.h"

namespace smat::gui {

SpectrumPanel::SpectrumPanel(EditorContext& context, QWidget* parent)
    : EntryPanel(context, EntryKind::spectrum, parent) {
    setObjectName("spectrumPanel");
    distance_ = new NumberField("m", this);
    distance_->setObjectName("referenceDistance");
    distance_->setRange(0.0, 1e7);
    distance_->setStep(1.0);
    distance_->setToolTip(tr("The air between the source and this distance is inside the "
                             "measurement already: a nearer sensor sees it unchanged, a farther "
                             "one through the rest of the air"));
    auto* form = new QFormLayout;
    form->addRow(tr("Reference distance"), distance_);

    tabs_ = new QTabWidget(this);
    tabs_->setObjectName("spectrumTabs");
    tabs_->setDocumentMode(true);
    plotPage_ = new QWidget(this);
    auto* plotColumn = new QVBoxLayout(plotPage_);
    plotColumn->setContentsMargins(0, 8, 0, 0);
    logarithmic_ = new QCheckBox(tr("log radiance"), plotPage_);
    logarithmic_->setObjectName("logRadiance");
    plotColumn->addWidget(logarithmic_);
    makePlot();
    tabs_->addTab(plotPage_, tr("View"));

    auto* tablePage = new QWidget(this);
    model_ = new SpectrumTableModel(this);
    table_ = new QTableView(tablePage);
    table_->setObjectName("spectrumTable");
    table_->setModel(model_);
    table_->setAlternatingRowColors(true);
    table_->setShowGrid(false);
    table_->setFrameShape(QFrame::NoFrame);
    table_->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 8);
    table_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    auto* copy = new QToolButton(tablePage);
    copy->setObjectName("copySpectrum");
    copy->setIcon(icon("copy-table"));
    copy->setToolTip(tr("Copy the whole table for a spreadsheet"));
    copy->setAutoRaise(true);
    connect(copy, &QToolButton::clicked, this,
            [this] { QApplication::clipboard()->setText(model_->spreadsheetText()); });
    auto* tableColumn = new QVBoxLayout(tablePage);
    tableColumn->setContentsMargins(0, 8, 0, 0);
    tableColumn->addWidget(copy);
    tableColumn->addWidget(table_, 1);
    tabs_->addTab(tablePage, tr("Table"));

    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 8, 0, 0);
    column->setSpacing(6);
    column->addWidget(makeHeading());
    column->addLayout(form);
    tabs_->addTab(makeNotes(), tr("Notes"));
    letShownPageAloneAskForRoom(*tabs_);
    column->addWidget(tabs_, 1);
    connect(distance_, &NumberField::edited, this, [this](double value) {
        edit(tr("Set reference distance of %1").arg(context_.title(*key_)), "referenceDistance",
             [&](irsg::SignatureDatabase& database) {
                 database.spectra.at(key_->name).referenceDistance_m = value;
             });
    });
    connect(distance_, &NumberField::finished, this, [this] { endGesture(); });
    connect(logarithmic_, &QCheckBox::toggled, this,
            [this](bool on) { plot_->setLogarithmic(QwtPlot::yLeft, on); });
}

void SpectrumPanel::makePlot() {
    delete plot_;
    plot_ = new CartesianPlot(PlotStyle::screen(QApplication::palette()), plotPage_);
    plot_->setMinimumSize(200, 150);
    plotPage_->layout()->addWidget(plot_);
}

void SpectrumPanel::changeEvent(QEvent* event) {
    EntryPanel::changeEvent(event);
    if (event->type() == QEvent::ApplicationPaletteChange && plot_ != nullptr) {
        makePlot();
        shown_ = {};
        show(key());
    }
}

void SpectrumPanel::refresh() {
    const irsg::UserSpectrum& spectrum = context_.session().value().spectra.at(key_->name);
    QString caption =
        counted(static_cast<long>(spectrum.components.size()), tr("component"), tr("components"));
    if (!spectrum.components.empty()) {
        const auto& axis = spectrum.components.front().radiance.wavelengths_um();
        caption += tr(", %1 nodes from %2 to %3 µm")
                       .arg(axis.size())
                       .arg(axis.front(), 0, 'g', 4)
                       .arg(axis.back(), 0, 'g', 4);
    }
    if (!spectrum.importedUnit.empty())
        caption += tr(", imported as %1").arg(readableUnit(spectrum.importedUnit));
    showTexts({}, spectrum.notes, caption);
    distance_->setValue(spectrum.referenceDistance_m);
    if (spectrum.components == shown_.components && spectrum.name == shown_.name)
        return;
    shown_ = spectrum;
    model_->setSpectrum(spectrum);
    PlotData data{{}, tr("wavelength (µm)"), tr("radiance (W·m⁻²·sr⁻¹·µm⁻¹)"), {}};
    for (const auto& component : spectrum.components)
        data.curves.push_back({QString::fromStdString(component.name),
                               component.radiance.wavelengths_um(), component.radiance.values()});
    data.yLogarithmic = logarithmic_->isChecked();
    plot_->setData(std::move(data));
}

} // namespace smat::gui
