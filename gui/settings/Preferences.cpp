#include "gui/settings/Preferences.h"

#include <algorithm>

#include <QComboBox>
#include <QFormLayout>
#include <QImage>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QVBoxLayout>

#include "gui/widgets/DialogButtons.h"
#include "gui/widgets/NumberBoxes.h"
#include "gui/widgets/Sentences.h"
#include "irsg/core/Errors.h"
#include "irsg/image/ColorMap.h"

namespace smat::gui {
namespace {

const QStringList themeNames{"system", "light", "dark"}; // in the order of ThemeMode
// In the order of DisplayUnits::Spectral, then of false and true.
const QStringList spectralNames{"as-calculated", "um", "cm-1"};
const QStringList intensityNames{"W/sr", "dB"};
const QStringList temperatureNames{"K", "degC"};
constexpr int shortestDelay_s = 1, longestDelay_s = 600;

QSettings open() {
    return QSettings(QSettings::IniFormat, QSettings::UserScope, "smat", "preferences");
}

/// A swatch of a colour map, dark to bright.
QIcon swatch(const std::string& name) {
    const auto& map = irsg::ColorMap::named(name);
    QImage image(48, 14, QImage::Format_RGB32);
    for (int x = 0; x < image.width(); ++x) {
        const auto color = map.at(static_cast<double>(x) / (image.width() - 1));
        for (int y = 0; y < image.height(); ++y)
            image.setPixel(x, y, qRgb(color.red, color.green, color.blue));
    }
    return QIcon(QPixmap::fromImage(image));
}

QLabel* explanation(const QString& text, QWidget* parent) {
    auto* label = new QLabel(text, parent);
    label->setForegroundRole(QPalette::PlaceholderText);
    label->setWordWrap(true);
    return label;
}

} // namespace

QString Preferences::file() {
    return open().fileName();
}

Preferences Preferences::load(QStringList* problems) {
    const auto memory = open();
    Preferences preferences;
    const auto refuse = [&](const QString& key, const QString& expected) {
        if (problems != nullptr)
            *problems << QStringLiteral("%1, %2: %3")
                             .arg(memory.fileName(), key,
                                  neededInstead(expected, memory.value(key).toString()));
    };
    if (const QString text = memory.value("theme", "system").toString(); themeNames.contains(text))
        preferences.theme = static_cast<ThemeMode>(themeNames.indexOf(text));
    else
        refuse("theme", themeNames.join(", "));

    const auto maps = irsg::ColorMap::names();
    const std::string map = memory.value("colorMap", QString::fromStdString(preferences.colorMap))
                                .toString()
                                .toStdString();
    if (std::find(maps.begin(), maps.end(), map) != maps.end())
        preferences.colorMap = map;
    else
        refuse("colorMap", "the name of a colour map");

    const auto wordOf = [&](const QString& key, const QStringList& names) {
        const auto at = names.indexOf(memory.value(key, names.front()).toString());
        if (at < 0)
            refuse(key, names.join(", "));
        return std::max<qsizetype>(at, 0);
    };
    preferences.units = {static_cast<DisplayUnits::Spectral>(wordOf("spectralAxis", spectralNames)),
                         wordOf("intensityUnit", intensityNames) == 1,
                         wordOf("temperatureUnit", temperatureNames) == 1};

    bool isNumber = true;
    const int delay = memory.value("recoveryDelay_s", preferences.recoveryDelay_s).toInt(&isNumber);
    if (isNumber && delay >= shortestDelay_s && delay <= longestDelay_s)
        preferences.recoveryDelay_s = delay;
    else
        refuse("recoveryDelay_s", "a number of seconds from 1 to 600");
    return preferences;
}

void Preferences::save() const {
    auto memory = open();
    memory.setValue("theme", themeNames.at(static_cast<int>(theme)));
    memory.setValue("colorMap", QString::fromStdString(colorMap));
    memory.setValue("recoveryDelay_s", recoveryDelay_s);
    memory.setValue("spectralAxis", spectralNames.at(static_cast<int>(units.spectral)));
    memory.setValue("intensityUnit", intensityNames.at(units.decibel ? 1 : 0));
    memory.setValue("temperatureUnit", temperatureNames.at(units.celsius ? 1 : 0));
    memory.sync();
    if (memory.status() != QSettings::NoError)
        throw irsg::InputError({memory.fileName().toStdString(), "",
                                "a place that cannot be written", "a file that may be written"});
}

PreferencesDialog::PreferencesDialog(const Preferences& preferences, QWidget* parent)
    : QDialog(parent) {
    setObjectName("preferencesDialog");
    setWindowTitle(tr("Preferences"));
    theme_ = new QComboBox(this);
    theme_->setObjectName("theme");
    theme_->addItems({tr("Like the desktop"), tr("Light"), tr("Dark")});
    theme_->setCurrentIndex(static_cast<int>(preferences.theme));
    colorMap_ = new QComboBox(this);
    colorMap_->setObjectName("colorMap");
    colorMap_->setIconSize(QSize(48, 14));
    for (const auto& name : irsg::ColorMap::names())
        if (!irsg::ColorMap::named(name).isDiverging())
            colorMap_->addItem(swatch(name), QString::fromStdString(name));
    colorMap_->setCurrentText(QString::fromStdString(preferences.colorMap));
    delay_ = new WholeBox("recoveryDelay", this);
    delay_->setRange(shortestDelay_s, longestDelay_s);
    delay_->setSuffix(tr(" s after an edit"));
    delay_->setValue(preferences.recoveryDelay_s);

    const auto unitBox = [this](const QString& name, const QStringList& choices, int chosen) {
        auto* box = new QComboBox(this);
        box->setObjectName(name);
        box->addItems(choices);
        box->setCurrentIndex(chosen);
        return box;
    };
    spectral_ =
        unitBox("spectralUnit", {tr("As calculated"), tr("Wavelength, µm"), tr("Wavenumber, cm⁻¹")},
                static_cast<int>(preferences.units.spectral));
    intensity_ = unitBox("intensityUnit", {tr("W·sr⁻¹"), tr("dB re 1 W·sr⁻¹")},
                         preferences.units.decibel ? 1 : 0);
    temperature_ =
        unitBox("temperatureUnit", {tr("K"), tr("°C")}, preferences.units.celsius ? 1 : 0);

    auto* form = new QFormLayout;
    form->setHorizontalSpacing(16);
    form->setVerticalSpacing(10);
    form->setLabelAlignment(Qt::AlignRight | Qt::AlignVCenter);
    form->addRow(tr("&Theme"), theme_);
    form->addRow(tr("&Colour map"), colorMap_);
    form->addRow({}, explanation(tr("For new projects. Existing projects keep their own."), this));
    form->addRow(tr("&Recovery copy"), delay_);
    form->addRow({}, explanation(tr("Unsaved changes are kept beside the project's file, never "
                                    "over it, and offered after a crash."),
                                 this));
    form->addRow(tr("&Spectral axes"), spectral_);
    form->addRow(tr("&Intensities"), intensity_);
    form->addRow(tr("Te&mperatures"), temperature_);
    form->addRow({},
                 explanation(tr("In plots, images and read-outs. Projects and saved values keep "
                                "their units."),
                             this));
    auto* place = explanation(tr("Kept in %1").arg(Preferences::file()), this);
    place->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto* buttons = okAndCancel(*this);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(20, 18, 20, 14);
    column->setSpacing(14);
    column->addLayout(form);
    column->addWidget(place);
    column->addStretch(1);
    column->addWidget(buttons);
    setMinimumWidth(460);
}

Preferences PreferencesDialog::preferences() const {
    return {static_cast<ThemeMode>(theme_->currentIndex()),
            colorMap_->currentText().toStdString(),
            delay_->value(),
            {static_cast<DisplayUnits::Spectral>(spectral_->currentIndex()),
             intensity_->currentIndex() == 1, temperature_->currentIndex() == 1}};
}

} // namespace smat::gui

#include "moc_Preferences.cpp"
