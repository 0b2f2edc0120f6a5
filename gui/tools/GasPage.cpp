#include "gui/tools/GasPage.h"

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <utility>

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "gui/tools/GasEntryDialog.h"
#include "gui/tools/GasFigures.h"
#include "gui/tools/GasLayersBox.h"
#include "gui/tools/GasPlot.h"
#include "gui/widgets/FileFilters.h"
#include "gui/widgets/NumberField.h"
#include "gui/widgets/NumberFormat.h"
#include "gui/widgets/RefusedText.h"
#include "gui/widgets/Sentences.h"
#include "gui/widgets/Widgets.h"
#include "gui/workbench/Workbench.h"
#include "irsg/core/Errors.h"
#include "irsg/radiometry/Band.h"
#include "smatcore/project/AtmosphereInput.h"
#include "smatcore/project/EnvironmentInput.h"
#include "smatcore/project/SceneBuilder.h"
#include "smatcore/settings/SettingKeys.h"

namespace smat::gui {

namespace {

/// What the list of atmospheres begins and ends with; between them are files.
constexpr int noAtmosphere = 0, projectAtmosphere = 1, firstFile = 2;
/// Offered where a person gives the layers a background.
constexpr double usualBackground_K = 300.0;

/// Of the numbers of an input, by the names of gasInputDiagnostics.
struct Label {
    const char *name, *words;
};
constexpr std::array labels{
    Label{"band", QT_TRANSLATE_NOOP("smat::gui::GasPage", "Band")},
    Label{"step", QT_TRANSLATE_NOOP("smat::gui::GasPage", "Step")},
    Label{"background", QT_TRANSLATE_NOOP("smat::gui::GasPage", "Black body behind")},
    Label{"--altitude", QT_TRANSLATE_NOOP("smat::gui::GasPage", "Altitude")},
    Label{"--range", QT_TRANSLATE_NOOP("smat::gui::GasPage", "Range")},
    Label{"--sensor-altitude", QT_TRANSLATE_NOOP("smat::gui::GasPage", "Sensor altitude")}};

/// As a label says it; of a layer as it is.
QString labelOf(const std::string& name) {
    const auto* const found =
        std::ranges::find(labels, name, [](const Label& label) { return std::string(label.name); });
    return found == labels.end() ? QString::fromStdString(name) : GasPage::tr(found->words);
}

/// Of what is wrong with an input, what is about this number.
QString problemOf(const GasInput& input, const std::string& name) {
    for (irsg::Diagnostic& diagnostic : gasInputDiagnostics(input))
        if (diagnostic.file == name) {
            diagnostic.file.clear();
            return withFormattedUnits(sentenceOf(diagnostic));
        }
    return {};
}

} // namespace

GasPage::GasPage(Workbench& workbench, Dialogs dialogs, QWidget* parent)
    : AtmosphereToolPage(workbench, std::move(dialogs), parent) {
    setObjectName("gasPage");
    layers_ = new GasLayersBox(this->workbench().undoStack(), this);
    plot_ = new GasPlot(this->dialogs(), this);
    plot_->hide(); // until there is something to plot
    inputs()->addWidget(layers_);
    makeForm();
    take_ = new QPushButton(tr("Take from the project"), this);
    take_->setObjectName("takeFromProject");
    take_->setToolTip(tr("Band, atmosphere, altitude and range as the project has them now"));
    add_ = new QPushButton(tr("Add to database…"), this);
    add_->setObjectName("addToDatabase");
    add_->setToolTip(tr("Add the chosen layer as a gas zone, or the spectrum of layers, to the "
                        "signature database that is open"));
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(take_);
    buttons->addWidget(add_);
    inputs()->addLayout(buttons);
    connect(take_, &QPushButton::clicked, this, &GasPage::takeFromProject);
    connect(add_, &QPushButton::clicked, this, &GasPage::addToDatabase);
    connect(layers_, &GasLayersBox::changed, this, &GasPage::refresh);
    connect(&this->workbench(), &Workbench::settingsChanged, this, &GasPage::refresh);
    connect(&this->workbench(), &Workbench::projectOpened, this, &GasPage::refresh);
    for (const auto signal : {&DatabaseSession::opened, &DatabaseSession::stateChanged})
        connect(&this->workbench().database(), signal, this, &GasPage::refresh);
    takeFromProject();
    tabAsOneReads(*this);
}

void GasPage::makeForm() {
    const GasInput usual;
    const Settings settings; // those of a new project
    auto* form = new QFormLayout;
    form->setHorizontalSpacing(12);
    form->setVerticalSpacing(6);
    form->setLabelAlignment(Qt::AlignRight | Qt::AlignVCenter);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    rightBand_ = usual.gas.band;
    band_ = new QLineEdit(QString::fromStdString(irsg::numberText(rightBand_.min_um) + "-" +
                                                 irsg::numberText(rightBand_.max_um)),
                          this);
    band_->setObjectName("gasBand");
    connect(band_, &QLineEdit::textChanged, this, &GasPage::refresh);
    auto* band = new QHBoxLayout;
    band->setSpacing(8);
    band->addWidget(band_, 1);
    auto* micrometres = new QLabel(tr("µm"), this);
    micrometres->setForegroundRole(QPalette::PlaceholderText);
    band->addWidget(micrometres);
    form->addRow(labelOf("band"), band);
    step_ = makeNumber("step", formattedUnit("cm-1"), usual.gas.step_per_cm, 1.0,
                       tr("Width of the cells of the spectrum"),
                       [](GasInput& input, double value) { input.gas.step_per_cm = value; });
    form->addRow(labelOf("step"), step_);
    source_ = new QComboBox(this);
    source_->setObjectName("gasSource");
    source_->setToolTip(tr("Source of the absorption of a gas: auto takes lines where their tables "
                           "reach, and RADCAL beyond"));
    for (const char* word : irsg::gasSourceNames)
        source_->addItem(word);
    connect(source_, &QComboBox::activated, this, &GasPage::refresh);
    form->addRow(tr("Source"), source_);
    background_ = makeNumber("background", tr("K"), usualBackground_K, 10.0,
                             tr("Temperature of a black body behind the last layer"),
                             [](GasInput& input, double value) { input.gas.background_K = value; });
    hasBackground_ = makeGiven("hasBackground", "background", *background_);
    form->addRow(hasBackground_, background_);

    atmosphere_ = new QComboBox(this);
    atmosphere_->setObjectName("gasAtmosphere");
    atmosphere_->setToolTip(
        tr("Between gas and sensor; without one, the sensor is right in front of the gas"));
    atmosphere_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    atmosphere_->setMinimumContentsLength(12);
    atmosphere_->addItems({tr("none"), tr("that of the project"), tr("A file…")});
    connect(atmosphere_, &QComboBox::activated, this, &GasPage::chooseAtmosphere);
    form->addRow(tr("Atmosphere"), atmosphere_);
    altitude_ = makeNumber("--altitude", tr("m"), settings[key::targetAltitude], 10.0,
                           tr("Of the gas, above the ground"),
                           [](GasInput& input, double value) { input.altitude_m = value; });
    form->addRow(labelOf("--altitude"), altitude_);
    range_ = makeNumber("--range", tr("m"), settings[key::cameraRange], 100.0,
                        tr("From the sensor to the gas"),
                        [](GasInput& input, double value) { input.range_m = value; });
    form->addRow(labelOf("--range"), range_);
    sensorAltitude_ = makeNumber(
        "--sensor-altitude", tr("m"), settings[key::targetAltitude], 10.0, tr("Above the ground"),
        [](GasInput& input, double value) { input.sensorAltitude_m = value; });
    hasSensorAltitude_ = makeGiven("hasSensorAltitude", "--sensor-altitude", *sensorAltitude_);
    hasSensorAltitude_->setToolTip(tr("If not given, that of the gas"));
    form->addRow(hasSensorAltitude_, sensorAltitude_);
    inputs()->addLayout(form);
}

NumberField* GasPage::makeNumber(const std::string& name, const QString& unit, double value,
                                 double step, const QString& tip,
                                 const std::function<void(GasInput&, double)>& put) {
    auto* field = new NumberField(unit, this);
    field->setObjectName(QString::fromStdString(name));
    field->setAccessibleName(labelOf(name));
    field->setToolTip(tip);
    field->setStep(step);
    field->setRange(0.0, std::numeric_limits<double>::infinity());
    field->setValue(value);
    field->setCheck([this, name, put](double typed) {
        GasInput candidate = input();
        put(candidate, typed);
        return problemOf(candidate, name);
    });
    // After the field's own slot, which says whether the text can stand.
    connect(field, &QLineEdit::textEdited, this, &GasPage::refresh);
    connect(field, &NumberField::finished, this, &GasPage::refresh);
    return field;
}

QCheckBox* GasPage::makeGiven(const char* object, const std::string& name, NumberField& field) {
    auto* box = new QCheckBox(labelOf(name), this);
    box->setObjectName(object);
    field.setEnabled(false);
    connect(box, &QCheckBox::toggled, this, &GasPage::refresh);
    return box;
}

void GasPage::takeFromProject() {
    if (workbench().hasProject()) {
        const Settings& settings = workbench().settings();
        band_->setText(QString::fromStdString(eachBand(settings).front().text(key::sensorBand)));
        altitude_->setValue(settings[key::targetAltitude]);
        sensorAltitude_->setValue(settings[key::targetAltitude]);
        range_->setValue(settings[key::cameraRange]);
        atmosphere_->setCurrentIndex(projectAtmosphere);
        chosenAtmosphere_ = chosenAtmosphere().empty() ? noAtmosphere : projectAtmosphere;
        atmosphere_->setCurrentIndex(chosenAtmosphere_);
    }
    refresh();
}

void GasPage::chooseAtmosphere(int index) {
    if (index == atmosphere_->count() - 1) {
        atmosphere_->setCurrentIndex(chosenAtmosphere_);
        const QString file =
            dialogs().openFile(this, tr("Atmosphere between gas and sensor"), atmosphereFilters());
        if (file.isEmpty())
            return;
        index = atmosphere_->findData(file);
        if (index < firstFile) {
            index = atmosphere_->count() - 1; // before "A file"
            atmosphere_->insertItem(
                index, textOf(std::filesystem::path(file.toStdString()).filename()), file);
            atmosphere_->setItemData(index, file, Qt::ToolTipRole);
        }
    }
    chosenAtmosphere_ = index;
    atmosphere_->setCurrentIndex(index);
    refresh();
}

std::vector<std::filesystem::path> GasPage::chosenAtmosphere() const {
    const int index = atmosphere_->currentIndex();
    if (index >= firstFile)
        return {atmosphere_->currentData().toString().toStdString()};
    std::vector<std::filesystem::path> files;
    if (index == projectAtmosphere && workbench().hasProject())
        files = resolvedAtmosphere(workbench().project(), workbench().settings());
    std::erase_if(files, isNoAtmosphere);
    return files;
}

GasInput GasPage::input() const {
    GasInput input;
    input.gas.layers = layers_->layers();
    input.gas.band = rightBand_;
    input.gas.step_per_cm = step_->value();
    input.gas.source = static_cast<irsg::GasSource>(source_->currentIndex());
    if (hasBackground_->isChecked())
        input.gas.background_K = background_->value();
    input.atmosphere = chosenAtmosphere();
    if (input.atmosphere.empty())
        return input;
    input.altitude_m = altitude_->value();
    input.range_m = range_->value();
    if (hasSensorAltitude_->isChecked())
        input.sensorAltitude_m = sensorAltitude_->value();
    return input;
}

QStringList GasPage::problems() const {
    QStringList sentences = layers_->problems();
    for (const NumberField* field : {step_, background_, altitude_, range_, sensorAltitude_})
        if (!field->isRight())
            sentences << field->accessibleName() + ": " + field->problem();
    if (!bandProblem_.isEmpty())
        sentences << labelOf("band") + ": " + bandProblem_;
    if (atmosphere_->currentIndex() == projectAtmosphere && chosenAtmosphere().empty())
        sentences << tr("The project has no atmosphere.");
    for (irsg::Diagnostic& diagnostic : gasInputDiagnostics(input())) {
        const QString label = labelOf(diagnostic.file);
        if (label == QString::fromStdString(diagnostic.file))
            continue; // the layers have said it
        diagnostic.file = label.toStdString();
        sentences << withFormattedUnits(sentenceOf(diagnostic));
    }
    return sentences;
}

void GasPage::readBand() {
    bandProblem_.clear();
    try {
        rightBand_ = irsg::Band::fromText(band_->text().trimmed().toStdString()).range();
    } catch (const irsg::InputError& error) {
        irsg::Diagnostic first = error.diagnostics().front();
        first.file.clear();
        bandProblem_ = withFormattedUnits(sentenceOf(first));
    }
}

void GasPage::refresh() {
    if (add_ == nullptr)
        return;
    readBand();
    const GasInput asked = input();
    const bool hasPath = !asked.atmosphere.empty();
    background_->setEnabled(hasBackground_->isChecked());
    for (QWidget* widget : {static_cast<QWidget*>(altitude_), static_cast<QWidget*>(range_),
                            static_cast<QWidget*>(hasSensorAltitude_)})
        widget->setEnabled(hasPath);
    sensorAltitude_->setEnabled(hasPath && hasSensorAltitude_->isChecked());
    take_->setEnabled(workbench().hasProject());
    atmosphere_->setItemData(projectAtmosphere, atmosphereWords(), Qt::ToolTipRole);
    const QString wrongBand = bandProblem_.isEmpty() ? problemOf(asked, "band") : bandProblem_;
    markField(*band_, wrongBand, tr("From the shortest to the longest wavelength, such as 3-5"));
    const QStringList wrong = problems();
    setProblems(wrong);
    add_->setEnabled(layers_->problems().isEmpty() && wrongBand.isEmpty() && step_->isRight() &&
                     workbench().database().isOpen());
    if (wrong.isEmpty())
        setCommand(QString::fromStdString(gasCommand(asked, "gas.csv")));
}

Calculation::Work GasPage::work() {
    return [this, asked = input()]() -> std::function<void()> {
        GasOutputRequest request = gasOutputRequest(asked);
        request.commandLine = gasCommand(asked, "gas.csv");
        const auto output = std::make_shared<const GasOutput>(gasOutput(request));
        return [this, output] { showOutput(*output); };
    };
}

void GasPage::showOutput(const GasOutput& output) {
    plot_->setOutput(output);
    showTableOn(*plot_, output.table, tr("Hot gas"), gasFigures(output));
}

void GasPage::addToDatabase() {
    if (!workbench().database().isOpen())
        return;
    const GasInput asked = input();
    const std::size_t chosen = layers_->chosen();
    const irsg::GasLayer layer = asked.gas.layers[chosen];
    GasEntryDialog dialog(workbench().database().snapshot(), asked.gas.layers.size(), chosen,
                          tr("gas of %1 K").arg(exactNumber(layer.temperature_K)), this);
    if (!dialogs().run(dialog))
        return;
    const GasEntryPlace place = dialog.place();
    irsg::GasRequest request = asked.gas;
    switch (dialog.what()) {
    case GasEntryDialog::What::zone:
        edit(place, [&](irsg::SignatureDatabase& database) { addGasZone(database, layer, place); });
        return;
    case GasEntryDialog::What::layerSpectrum:
        request.layers = {layer};
        break;
    case GasEntryDialog::What::allSpectrum:
        break;
    }
    addSurface(request, place);
}

void GasPage::addSurface(const irsg::GasRequest& request, const GasEntryPlace& place) {
    const DatabaseSession& session = workbench().database();
    using Surface = std::shared_ptr<const GasSurface>;
    adding_.run<Surface>(
        [request] { return std::make_shared<const GasSurface>(gasSurface(request)); },
        [this, place, &session, file = session.file()](const Surface& surface) {
            // What was open may be another by now.
            if (session.isOpen() && session.file() == file)
                edit(place, [&](irsg::SignatureDatabase& database) {
                    addGasSurface(database, *surface, place);
                });
        },
        [this](const std::exception_ptr& thrown) {
            dialogs().tell(this, refusalTitle(), sentencesOf(thrown));
        });
}

void GasPage::edit(const GasEntryPlace& place,
                   const std::function<void(irsg::SignatureDatabase&)>& change) {
    try {
        workbench().database().edit(tr("Add %1").arg(QString::fromStdString(place.name)), change);
    } catch (const irsg::InputError& error) {
        dialogs().tell(this, tr("This gas cannot be added"), sentencesOf(error));
    }
}

} // namespace smat::gui

#include "moc_GasPage.cpp"
