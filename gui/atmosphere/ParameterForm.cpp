#include "gui/atmosphere/ParameterForm.h"

#include <algorithm>
#include <iterator>

#include <QComboBox>
#include <QEvent>
#include <QFormLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QToolButton>
#include <QVBoxLayout>

#include "gui/widgets/NumberFormat.h"
#include "gui/widgets/NumberText.h"
#include "gui/widgets/RefusedText.h"
#include "gui/widgets/Sentences.h"
#include "gui/widgets/Theme.h"
#include "irsg/atmosphere/SmartParameterText.h"
#include "irsg/core/Errors.h"

namespace smat::gui {
namespace {

QString textOf(std::string_view text) {
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

QString unitOf(const irsg::SmartParameter& parameter) {
    return parameter.unit == "C" ? QStringLiteral("°C")
                                 : formattedUnit(std::string(parameter.unit));
}

/// Numbers by the rule of typedNumber(), other texts as they are.
std::string plainTextOf(const irsg::SmartParameter& parameter, const QString& text) {
    const bool isNumber = parameter.kind != irsg::KarmaKind::string;
    const QString plain =
        isNumber ? plainNumber(text, textOf(std::string_view(parameter.unit))) : text;
    return plain.trimmed().toStdString();
}

struct Label {
    const char *name, *words;
};
constexpr Label labels[] = {
    {"AerosolModel", QT_TRANSLATE_NOOP("smat::gui::ParameterForm", "Aerosol")},
    {"Aerosols", QT_TRANSLATE_NOOP("smat::gui::ParameterForm", "All aerosols")},
    {"AirMass", QT_TRANSLATE_NOOP("smat::gui::ParameterForm", "Air mass character")},
    {"AlbedoValues", QT_TRANSLATE_NOOP("smat::gui::ParameterForm", "Albedo")},
    {"AlbedoWavelengths", QT_TRANSLATE_NOOP("smat::gui::ParameterForm", "Albedo wavelengths")},
    {"AtmosphereModel", QT_TRANSLATE_NOOP("smat::gui::ParameterForm", "Model atmosphere")},
    {"BaseWavelengthMax", QT_TRANSLATE_NOOP("smat::gui::ParameterForm", "Band to")},
    {"BaseWavelengthMin", QT_TRANSLATE_NOOP("smat::gui::ParameterForm", "Band from")},
    {"Ch4_ppmv", QT_TRANSLATE_NOOP("smat::gui::ParameterForm", "Methane")},
    {"CloudBaseAltitude", QT_TRANSLATE_NOOP("smat::gui::ParameterForm", "Cloud base")},
    {"CloudExtinction", QT_TRANSLATE_NOOP("smat::gui::ParameterForm", "Cloud extinction")},
    {"CloudModel", QT_TRANSLATE_NOOP("smat::gui::ParameterForm", "Cloud or rain")},
    {"CloudThickness", QT_TRANSLATE_NOOP("smat::gui::ParameterForm", "Cloud thickness")},
    {"Co2_ppmv", QT_TRANSLATE_NOOP("smat::gui::ParameterForm", "Carbon dioxide")},
    {"GroundAltitude", QT_TRANSLATE_NOOP("smat::gui::ParameterForm", "Ground altitude")},
    {"GroundTemperature", QT_TRANSLATE_NOOP("smat::gui::ParameterForm", "Ground temperature")},
    {"IrradianceMode", QT_TRANSLATE_NOOP("smat::gui::ParameterForm", "Irradiance tables")},
    {"MeasurementHeight", QT_TRANSLATE_NOOP("smat::gui::ParameterForm", "Measurement height")},
    {"MeteoModel", QT_TRANSLATE_NOOP("smat::gui::ParameterForm", "Lowest kilometre")},
    {"N2o_ppmv", QT_TRANSLATE_NOOP("smat::gui::ParameterForm", "Nitrous oxide")},
    {"OzoneScale", QT_TRANSLATE_NOOP("smat::gui::ParameterForm", "Ozone factor")},
    {"PressureMH", QT_TRANSLATE_NOOP("smat::gui::ParameterForm", "Measured pressure")},
    {"Radiosonde", QT_TRANSLATE_NOOP("smat::gui::ParameterForm", "Radiosonde ascent")},
    {"RelativeHumidityMH", QT_TRANSLATE_NOOP("smat::gui::ParameterForm", "Measured humidity")},
    {"Resolution", QT_TRANSLATE_NOOP("smat::gui::ParameterForm", "Spectral resolution")},
    {"ScatteringMode", QT_TRANSLATE_NOOP("smat::gui::ParameterForm", "Scattering")},
    {"TemperatureALT0", QT_TRANSLATE_NOOP("smat::gui::ParameterForm", "Temperature at 0 m")},
    {"TemperatureMH", QT_TRANSLATE_NOOP("smat::gui::ParameterForm", "Measured temperature")},
    {"Visibility", QT_TRANSLATE_NOOP("smat::gui::ParameterForm", "Visibility")},
    {"WaterScale", QT_TRANSLATE_NOOP("smat::gui::ParameterForm", "Water vapour factor")},
    {"WindDirection", QT_TRANSLATE_NOOP("smat::gui::ParameterForm", "Wind direction")},
    {"WindSpeed", QT_TRANSLATE_NOOP("smat::gui::ParameterForm", "Wind speed")},
    {"WindSpeedAverage24", QT_TRANSLATE_NOOP("smat::gui::ParameterForm", "Mean wind, 24 h")},
    {"WindSpeedMeasurementHeight",
     QT_TRANSLATE_NOOP("smat::gui::ParameterForm", "Height of the wind")}};

QString titleOf(irsg::SmartGroup group) {
    switch (group) {
    case irsg::SmartGroup::air:
        return ParameterForm::tr("Air");
    case irsg::SmartGroup::gases:
        return ParameterForm::tr("Gases");
    case irsg::SmartGroup::aerosol:
        return ParameterForm::tr("Aerosol and wind");
    case irsg::SmartGroup::cloud:
        return ParameterForm::tr("Cloud and rain");
    case irsg::SmartGroup::ground:
        return ParameterForm::tr("Ground");
    case irsg::SmartGroup::computation:
        break;
    }
    return ParameterForm::tr("Band and computation");
}

/// Of a value in a table: what valueText writes.
QString valueOf(const irsg::SmartParameter& parameter,
                const irsg::AtmosphereSmartParameters& values) {
    return textOf(std::string_view(irsg::valueText(parameter, values)));
}

} // namespace

QString labelOf(const irsg::SmartParameter& parameter) {
    const auto* found = std::ranges::find(labels, parameter.name, &Label::name);
    if (found == std::end(labels))
        throw irsg::LogicError("a parameter of an atmosphere has no label: " +
                               std::string(parameter.name));
    return ParameterForm::tr(found->words);
}

QString helpText(const irsg::SmartParameter& parameter) {
    const QString usual = valueOf(parameter, {});
    return QStringLiteral("<p style='white-space:normal'>%1</p><p><i>%2</i> "
                          "<small>%3</small></p>")
        .arg(textOf(parameter.help).toHtmlEscaped(),
             ParameterForm::tr("%1; by default %2")
                 .arg(withFormattedUnits(textOf(parameter.range)),
                      usual.isEmpty() ? ParameterForm::tr("none") : usual)
                 .toHtmlEscaped(),
             textOf(parameter.name));
}

ParameterForm::ParameterForm(AtmosphereDocument& document, Dialogs dialogs, QWidget* parent)
    : QWidget(parent), document_(document), dialogs_(std::move(dialogs)) {
    setObjectName("parameterForm");
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(10);
    for (int group = 0; group <= static_cast<int>(irsg::SmartGroup::computation); ++group)
        addGroup(static_cast<irsg::SmartGroup>(group));
    column->addStretch(1);
    connect(&document_, &AtmosphereDocument::changed, this, &ParameterForm::follow);
    follow();
}

void ParameterForm::addGroup(irsg::SmartGroup group) {
    auto* box = new QGroupBox(titleOf(group), this);
    auto* form = new QFormLayout(box);
    form->setHorizontalSpacing(8);
    form->setVerticalSpacing(5);
    form->setRowWrapPolicy(QFormLayout::WrapLongRows);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    // Codes first: the numbers are about them.
    for (const bool areCodes : {true, false})
        for (const auto& table : {irsg::smartParameters(), irsg::ownSmartParameters()})
            for (const irsg::SmartParameter& parameter : table)
                if (parameter.group == group && parameter.codes.empty() != areCodes)
                    addField(*form, parameter);
    layout()->addWidget(box);
}

void ParameterForm::addField(QFormLayout& form, const irsg::SmartParameter& parameter) {
    // A kind with one value is nothing to choose.
    if (parameter.kind == irsg::KarmaKind::entityType)
        return;
    Field field{.parameter = &parameter};
    field.label = new QLabel(labelOf(parameter), this);
    QWidget* widget = parameter.codes.empty() ? makeText(field) : makeCodes(field);
    widget->setObjectName(textOf(parameter.name));
    widget->setAccessibleName(labelOf(parameter));
    widget->setToolTip(helpText(parameter));
    widget->setProperty("parameter", static_cast<int>(fields_.size()));
    widget->installEventFilter(this);
    field.label->setToolTip(widget->toolTip());
    field.label->setBuddy(widget);
    auto* row = new QHBoxLayout;
    row->setSpacing(6);
    row->addWidget(widget, 1);
    if (parameter.kind == irsg::KarmaKind::string) {
        auto* browse = new QToolButton(this);
        browse->setIcon(icon("open"));
        browse->setObjectName(textOf(parameter.name) + ".browse");
        browse->setToolTip(tr("Choose a file"));
        browse->setFocusPolicy(Qt::StrongFocus);
        row->addWidget(browse);
        connect(browse, &QToolButton::clicked, this, [this, field] { chooseFile(field); });
    }
    auto* unit = new QLabel(unitOf(parameter), this);
    unit->setForegroundRole(QPalette::PlaceholderText);
    unit->setMinimumWidth(fontMetrics().horizontalAdvance("ppmv") + 2);
    row->addWidget(unit);
    form.addRow(field.label, row);
    fields_.push_back(field);
}

QWidget* ParameterForm::makeText(Field& field) {
    auto* edit = field.text = new QLineEdit(this);
    edit->setMinimumWidth(70);
    if (field.parameter->kind == irsg::KarmaKind::string)
        edit->setPlaceholderText(tr("none"));
    connect(edit, &QLineEdit::textEdited, this,
            [this, shown = field](const QString& text) { type(shown, text); });
    connect(edit, &QLineEdit::editingFinished, this, &ParameterForm::finish);
    return edit;
}

QWidget* ParameterForm::makeCodes(Field& field) {
    auto* box = field.codes = new QComboBox(this);
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->setMinimumContentsLength(12);
    for (const irsg::SmartCode& code : field.parameter->codes)
        box->addItem(QStringLiteral("%1  %2").arg(code.code).arg(textOf(code.words)), code.code);
    connect(box, &QComboBox::activated, this, [this, shown = field] {
        const QString code = shown.codes->currentData().toString();
        finish();
        type(shown, code);
        finish();
    });
    return box;
}

bool ParameterForm::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::FocusIn)
        emit entered(*fields_[watched->property("parameter").toUInt()].parameter);
    return QWidget::eventFilter(watched, event);
}

void ParameterForm::follow() {
    const irsg::AtmosphereSmartParameters& now = document_.parameters();
    for (const Field& field : fields_) {
        const QString value = valueOf(*field.parameter, now);
        // A font of one's own would go with another theme.
        const QString weight =
            value != valueOf(*field.parameter, {}) ? "font-weight: bold" : QString();
        if (field.label->styleSheet() != weight)
            field.label->setStyleSheet(weight);
        if (field.codes != nullptr) {
            field.codes->setCurrentIndex(field.codes->findData(value.toInt()));
            continue;
        }
        // While one types "5.0" the field is left alone.
        irsg::AtmosphereSmartParameters shown = now;
        std::vector<irsg::Diagnostic> wrong;
        setFromText(shown, field.parameter->name, plainTextOf(*field.parameter, field.text->text()),
                    wrong);
        if (!wrong.empty() || shown != now || gesture_ == AtmosphereDocument::noGesture) {
            if (field.text->text() != value)
                field.text->setText(value);
            mark(field, {});
        }
    }
}

void ParameterForm::type(const Field& field, const QString& text) {
    if (gesture_ == AtmosphereDocument::noGesture) {
        gesture_ = newGesture();
        before_ = document_.parameters();
    }
    irsg::AtmosphereSmartParameters after = document_.parameters();
    std::vector<irsg::Diagnostic> wrong;
    setFromText(after, field.parameter->name, plainTextOf(*field.parameter, text), wrong);
    if (wrong.empty())
        wrong = rangeDiagnosticsOf(*field.parameter, after);
    if (!wrong.empty())
        return mark(field, sentenceOf(wrong.front()));
    mark(field, {});
    document_.set(after, tr("Set %1").arg(labelOf(*field.parameter)), gesture_);
}

void ParameterForm::finish() {
    // A text that cannot stay takes along what its first letters did.
    if (gesture_ != AtmosphereDocument::noGesture && !problem_.isEmpty()) {
        document_.set(before_, {}, gesture_);
        for (const Field& field : fields_)
            if (field.text != nullptr && field.text == sender())
                sayRefused(*field.text, problem_, valueOf(*field.parameter, before_));
    }
    gesture_ = AtmosphereDocument::noGesture;
    follow();
}

void ParameterForm::chooseFile(const Field& field) {
    const QString file = dialogs_.openFile(this, tr("Choose a radiosonde ascent"),
                                           {tr("Ascents (*.csv)"), tr("All files (*)")});
    if (file.isEmpty())
        return;
    field.text->setText(file);
    type(field, file);
    finish();
}

void ParameterForm::mark(const Field& field, const QString& problem) {
    if (field.text != nullptr)
        markField(*field.text, problem, helpText(*field.parameter));
    if (problem == problem_)
        return;
    problem_ = problem;
    emit problemChanged();
}

} // namespace smat::gui

#include "moc_ParameterForm.cpp"
