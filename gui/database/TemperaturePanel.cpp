#include "gui/database/TemperaturePanel.h"

#include <algorithm>

#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QStackedWidget>
#include <QTabWidget>
#include <QToolButton>
#include <QVBoxLayout>

#include "gui/database/FactorsPanel.h"
#include "gui/database/NodePlot.h"
#include "gui/database/TemperatureResult.h"
#include "gui/database/TermsPanel.h"
#include "gui/widgets/Theme.h"
#include "gui/widgets/Widgets.h"

namespace smat::gui {
namespace {

constexpr int temperatureMode = 0;
constexpr int spectrumMode = 1;
constexpr int termsTab = 1;
constexpr int factorsTab = 2;

} // namespace

TemperaturePanel::TemperaturePanel(EditorContext& context, QWidget* parent)
    : EntryPanel(context, EntryKind::temperature, parent) {
    setObjectName("temperaturePanel");
    mode_ = new QComboBox(this);
    mode_->setObjectName("emissionMode");
    mode_->addItems({tr("Use temperature"), tr("User-defined spectrum")});
    mode_->setToolTip(tr("Use temperature: the surface emits as its temperature (eq. 7) and its "
                         "material say. User-defined spectrum: it emits the components of a "
                         "spectrum times their factors (eq. 6)"));
    spectrum_ = new QComboBox(this);
    spectrum_->setObjectName("spectrumChoice");
    spectrum_->setMinimumWidth(120);
    auto* look = new QToolButton(this);
    look->setObjectName("viewSpectrum");
    look->setIcon(icon("spectrum"));
    look->setAutoRaise(true);
    look->setToolTip(tr("View this spectrum"));
    auto* row = new QHBoxLayout;
    row->setSpacing(8);
    row->addWidget(new QLabel(tr("Mode"), this));
    row->addWidget(mode_);
    row->addWidget(spectrum_, 1);
    row->addWidget(look);
    row->addStretch(0);

    tabs_ = new QTabWidget(this);
    tabs_->setObjectName("temperatureTabs");
    tabs_->setDocumentMode(true);
    tabs_->addTab(makeEmission(), tr("Result"));
    terms_ = new TermsPanel(this);
    tabs_->addTab(terms_, tr("Equation terms"));
    factors_ = new FactorsPanel(context_, this);
    tabs_->addTab(factors_, tr("Factors"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 8, 0, 0);
    column->setSpacing(6);
    column->addWidget(makeHeading());
    column->addLayout(row);
    tabs_->addTab(makeNotes(), tr("Notes"));
    letShownPageAloneAskForRoom(*tabs_);
    column->addWidget(tabs_, 1);

    connect(mode_, &QComboBox::activated, this, &TemperaturePanel::chooseMode);
    connect(spectrum_, &QComboBox::textActivated, this, &TemperaturePanel::chooseSpectrum);
    connect(look, &QToolButton::clicked, this,
            [this] { emit spectrumRequested(spectrum_->currentText()); });
    connect(terms_, &TermsPanel::edited, this,
            [this](const irsg::TemperatureTerms& terms, const QString& field, const QString& what) {
                edit(tr("Set %1 of temperature %2").arg(what).arg(key_ ? key_->index : 0),
                     "terms." + field, [&](irsg::SignatureDatabase& database) {
                         database.temperatures.at(key_->index).terms = terms;
                     });
            });
    connect(terms_, &TermsPanel::gestureEnded, this, [this] { endGesture(); });
    connect(
        factors_, &FactorsPanel::edited, this,
        [this](const irsg::ComponentFactors& factors, const QString& field, const QString& what) {
            edit(tr("Set %1 of temperature %2").arg(what).arg(key_ ? key_->index : 0),
                 "factors." + field, [&](irsg::SignatureDatabase& database) {
                     database.temperatures.at(key_->index).factors = factors;
                 });
        });
    connect(factors_, &FactorsPanel::gestureEnded, this, [this] { endGesture(); });
}

QWidget* TemperaturePanel::makeEmission() {
    result_ = new TemperatureResult(this);
    emitted_ = new NodePlot(this);
    emitted_->setObjectName("emittedSpectrum");
    emitted_->setReadOnly(true);
    NodeRules rules;
    rules.xName = tr("wavelength");
    rules.xUnit = tr("µm");
    rules.yName = tr("emitted radiance now");
    rules.yUnit = tr("W·m⁻²·sr⁻¹·µm⁻¹");
    emitted_->setRules(rules);
    emission_ = new QStackedWidget(this);
    emission_->addWidget(result_);
    emission_->addWidget(emitted_);
    return emission_;
}

void TemperaturePanel::chooseMode(int mode) {
    edit(mode == temperatureMode
             ? tr("Set temperature %1 to use its temperature").arg(key_ ? key_->index : 0)
             : tr("Set temperature %1 to a user-defined spectrum").arg(key_ ? key_->index : 0),
         "mode", [&](irsg::SignatureDatabase& database) {
             auto& entry = database.temperatures.at(key_->index);
             entry.mode = mode == temperatureMode ? irsg::EmissionMode::temperature
                                                  : irsg::EmissionMode::userSpectrum;
             // The first spectrum is a start where none was chosen yet.
             if (mode == spectrumMode && !database.spectra.contains(entry.userSpectrum) &&
                 !database.spectra.empty())
                 entry.userSpectrum = database.spectra.begin()->first;
         });
    endGesture();
}

void TemperaturePanel::chooseSpectrum(const QString& name) {
    edit(tr("Set spectrum of temperature %1 to %2").arg(key_ ? key_->index : 0).arg(name),
         "userSpectrum", [&](irsg::SignatureDatabase& database) {
             database.temperatures.at(key_->index).userSpectrum = name.toStdString();
         });
    endGesture();
}

void TemperaturePanel::showEmission(const irsg::TemperatureEntry& entry) {
    const auto& spectra = context_.session().value().spectra;
    const auto found = spectra.find(entry.userSpectrum);
    const irsg::UserSpectrum* spectrum = found == spectra.end() ? nullptr : &found->second;
    factors_->setFactors(entry.factors, spectrum, context_.state());
    const bool measured = entry.mode == irsg::EmissionMode::userSpectrum;
    emission_->setCurrentWidget(measured ? static_cast<QWidget*>(emitted_) : result_);
    if (!measured || spectrum == nullptr || spectrum->components.empty()) {
        emitted_->setBackdrop({});
        emitted_->setLeastView(std::nullopt, std::nullopt);
        return;
    }
    // The sum of eq. 6 and its parts.
    const auto& axis = spectrum->components.front().radiance.wavelengths_um();
    Curve sum{tr("sum"), axis, std::vector<double>(axis.size(), 0.0)};
    std::vector<Curve> curves;
    double most = 0.0;
    for (const auto& component : spectrum->components) {
        const auto factor =
            std::ranges::find(entry.factors, component.name, &irsg::ComponentFactor::component);
        const double now = factor == entry.factors.end() ? 1.0 : factor->at(context_.state());
        Curve part{QString::fromStdString(component.name), axis, component.radiance.sample(axis)};
        for (std::size_t i = 0; i < axis.size(); ++i) {
            part.y[i] *= now;
            sum.y[i] += part.y[i];
            most = std::max(most, sum.y[i]);
        }
        curves.push_back(std::move(part));
    }
    curves.push_back(std::move(sum));
    emitted_->setBackdrop(std::move(curves));
    emitted_->setLeastView(Interval{axis.front(), axis.back()}, Interval{0.0, most});
}

void TemperaturePanel::refresh() {
    const auto& database = context_.session().value();
    const irsg::TemperatureEntry& entry = database.temperatures.at(key_->index);
    const int faces = context_.facesOf(*key_);
    showTexts(entry.name, entry.notes,
              context_.knowsModel() ? counted(faces, tr("face"), tr("faces")) : QString());
    const bool measured = entry.mode == irsg::EmissionMode::userSpectrum;
    mode_->setCurrentIndex(measured ? spectrumMode : temperatureMode);
    spectrum_->setVisible(measured);
    findChild<QToolButton*>("viewSpectrum")->setVisible(measured);
    QStringList names;
    for (const auto& [name, spectrum] : database.spectra)
        names << QString::fromStdString(name);
    const QString chosen = QString::fromStdString(entry.userSpectrum);
    if (!names.contains(chosen))
        names.prepend(chosen);
    spectrum_->clear();
    spectrum_->addItems(names);
    spectrum_->setCurrentText(chosen);
    terms_->setTerms(entry.terms);
    result_->setProjectState(context_.state());
    result_->setTerms(entry.terms);
    tabs_->setTabVisible(termsTab, !measured);
    tabs_->setTabVisible(factorsTab, measured);
    showEmission(entry);
}

} // namespace smat::gui

#include "moc_TemperaturePanel.cpp"
