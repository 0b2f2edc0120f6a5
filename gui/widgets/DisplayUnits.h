#pragma once

#include <optional>
#include <string>

#include <QObject>
#include <QString>

#include "gui/widgets/NumberFormat.h"

namespace smat::gui {

/// The units that plots, images and read-outs are shown in: a preference of the person in front of
/// the window. Projects, results and exported values keep their own.
struct DisplayUnits {
    enum class Spectral { asCalculated, wavelength, wavenumber };
    Spectral spectral = Spectral::asCalculated;
    bool decibel = false; ///< intensities in dB re 1 W sr-1
    bool celsius = false; ///< temperatures in deg C

    bool operator==(const DisplayUnits&) const = default;
    static const DisplayUnits& current();
};

/// Tells what shows values that the units are others.
class DisplayUnitsWatch : public QObject {
    Q_OBJECT

  public:
    static DisplayUnitsWatch& instance();
    void set(const DisplayUnits& units);

  signals:
    void changed();

  private:
    DisplayUnitsWatch() = default;
};

/// How a quantity in a unit of results is shown in another one: a row of the one table of units.
struct ShownUnit {
    std::string stored; ///< "K", "W sr-1", "cm-1", "um"
    QString title;      ///< of an axis where it is another quantity then: "Wavelength"; else empty
    QString unit;       ///< "°C"
    double (*shown)(double stored);
    double (*back)(double shown);
    /// Half the width of an error about a stored value.
    double (*error)(double stored, double half);
    bool isReversed = false; ///< where one grows the other falls
    bool isLogarithmic = false;

    /// "Apparent temperature (K)" as "Apparent temperature (°C)".
    QString titleOf(const QString& storedTitle) const;
};

/// Null where a unit is shown as it is.
const ShownUnit* shownUnitOf(const std::string& stored,
                             const DisplayUnits& units = DisplayUnits::current());

/// "1.25 °C" of a value in a unit of results; in its own where it has none in the other, such as no
/// decibels. `words` makes the text of the number.
QString valueWithUnit(double value, const std::string& unit,
                      QString (*words)(double) = formattedNumber);
/// The same of a difference, a spread or an error, which stays in its own unit.
QString storedValueWithUnit(double value, const std::string& unit,
                            QString (*words)(double) = formattedNumber);

} // namespace smat::gui
