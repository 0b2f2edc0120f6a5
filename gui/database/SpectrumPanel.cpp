#include "gui/database/SpectrumPanel.h"

#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QEvent>
#include <QGridLayout>
#include <QHeaderView>
#include <QTabWidget>
#include <QTableView>
#include <QToolButton>
#include <QVBoxLayout>

#include "gui/database/SpectrumTableModel.h"
#include "gui/plot/CartesianPlot.h"
#include "gui/widgets/NumberFormat.h"
#include "gui/widgets/Theme.h"
#include "gui/widgets/Widgets.h"

namespace smat::gui {

SpectrumPanel::SpectrumPanel(EditorContext& context, QWidget* parent)
    : EntryPanel(context, EntryKind::spectrum, parent),
      numbers_(
          irsg::spectrumFields(), this,
          [this](const irsg::EntryField<irsg::UserSpectrum>& row, double value) {
              edit(tr("Set %1 of %2").arg(tr(row.word), context_.title(*key_)), row.key,
                   [&](irsg::SignatureDatabase& database) {
                       database.spectra.at(key_->name).*row.as<double>() = value;
                   });
          },
          [this] { endGesture(); }) {
    setObjectName("spectrumPanel");
    auto* form = new QGridLayout;
    numbers_.addTo(*form, 1);

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
    table_->setTabKeyNavigation(false);
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
    // The event of the application comes to windows alone.
    // Later: Qt still gives palettes to the widgets inside.
    if (event->type() == QEvent::PaletteChange && plot_ != nullptr)
        QMetaObject::invokeMethod(
            this, [this] { plot_->setLook(PlotStyle::screen(QApplication::palette())); },
            Qt::QueuedConnection);
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
        caption += tr(", imported as %1").arg(formattedUnit(spectrum.importedUnit));
    showTexts({}, spectrum.notes, caption);
    numbers_.show(spectrum);
    if (spectrum.components == shown_.components && spectrum.name == shown_.name)
        return;
    shown_ = spectrum;
    model_->setSpectrum(spectrum);
    PlotData data{.title = {},
                  .xTitle = tr("wavelength (µm)"),
                  .yTitle = tr("radiance (W·m⁻²·sr⁻¹·µm⁻¹)"),
                  .curves = {},
                  .xUnit = "um"};
    for (const auto& component : spectrum.components)
        data.curves.push_back({QString::fromStdString(component.name),
                               component.radiance.wavelengths_um(), component.radiance.values()});
    data.yLogarithmic = logarithmic_->isChecked();
    plot_->setData(std::move(data));
}

} // namespace smat::gui

#include "moc_SpectrumPanel.cpp"
