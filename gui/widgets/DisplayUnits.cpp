#include "gui/widgets/DisplayUnits.h"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "gui/widgets/NumberFormat.h"
#include "irsg/radiometry/Units.h"

namespace smat::gui {
namespace {

constexpr double perMicrometre = 1e4; // cm-1 times um

DisplayUnits& currentUnits() {
    static DisplayUnits units;
    return units;
}

double reciprocal(double value) {
    return value == 0.0 ? std::numeric_limits<double>::quiet_NaN() : perMicrometre / value;
}
double reciprocalError(double value, double half) {
    return value == 0.0 ? std::numeric_limits<double>::quiet_NaN()
                        : perMicrometre / (value * value) * half;
}
double sameError(double, double half) {
    return half;
}
/// Nothing for what has no logarithm.
double decibels(double value) {
    return value > 0.0 ? 10.0 * std::log10(value) : std::numeric_limits<double>::quiet_NaN();
}
double decibelError(double value, double half) {
    return value > 0.0 ? 10.0 * std::numbers::log10e * half / value
                       : std::numeric_limits<double>::quiet_NaN();
}

/// Every unit that can be shown as another one.
const std::array<ShownUnit, 4>& shownUnits() {
    static const std::array<ShownUnit, 4> table{
        ShownUnit{"cm-1", QObject::tr("Wavelength"), QStringLiteral("µm"), reciprocal, reciprocal,
                  reciprocalError, true},
        ShownUnit{"um", QObject::tr("Wavenumber"), QStringLiteral("cm⁻¹"), reciprocal, reciprocal,
                  reciprocalError, true},
        ShownUnit{"W sr-1",
                  {},
                  QStringLiteral("dB re 1 W·sr⁻¹"),
                  decibels,
                  [](double shown) { return std::pow(10.0, 0.1 * shown); },
                  decibelError,
                  false,
                  true},
        ShownUnit{"K",
                  {},
                  QStringLiteral("°C"),
                  irsg::celsiusFromKelvin,
                  irsg::kelvinFromCelsius,
                  sameError}};
    return table;
}

} // namespace

const DisplayUnits& DisplayUnits::current() {
    return currentUnits();
}

DisplayUnitsWatch& DisplayUnitsWatch::instance() {
    static DisplayUnitsWatch watch;
    return watch;
}

void DisplayUnitsWatch::set(const DisplayUnits& units) {
    if (units == currentUnits())
        return;
    currentUnits() = units;
    emit changed();
}

QString ShownUnit::titleOf(const QString& storedTitle) const {
    if (!title.isEmpty())
        return title + " (" + unit + ")";
    QString made = storedTitle;
    const QString old = "(" + formattedUnit(stored) + ")";
    return made.contains(old) ? made.replace(old, "(" + unit + ")")
                              : storedTitle + " (" + unit + ")";
}

const ShownUnit* shownUnitOf(const std::string& stored, const DisplayUnits& units) {
    using Spectral = DisplayUnits::Spectral;
    for (const ShownUnit& one : shownUnits()) {
        const bool isWanted = one.stored == "K"        ? units.celsius
                              : one.stored == "W sr-1" ? units.decibel
                              : one.stored == "um"     ? units.spectral == Spectral::wavenumber
                                                       : units.spectral == Spectral::wavelength;
        if (isWanted && one.stored == stored)
            return &one;
    }
    return nullptr;
}

QString storedValueWithUnit(double value, const std::string& unit, QString (*words)(double)) {
    return withFormattedUnits(words(value) + " " + QString::fromStdString(unit)).trimmed();
}

QString valueWithUnit(double value, const std::string& unit, QString (*words)(double)) {
    const ShownUnit* shown = shownUnitOf(unit);
    const double other = shown == nullptr ? value : shown->shown(value);
    if (shown == nullptr || (std::isnan(other) && !std::isnan(value)))
        return storedValueWithUnit(value, unit, words);
    return words(other) + " " + shown->unit;
}

} // namespace smat::gui

#include "moc_DisplayUnits.cpp"
