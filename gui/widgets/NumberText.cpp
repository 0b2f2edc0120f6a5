#include "gui/widgets/NumberText.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringList>

#include "irsg/core/CsvTable.h"
#include "irsg/radiometry/Units.h"

namespace smat::gui {
namespace {

QString trRows(const char* text) {
    return QCoreApplication::translate("smat::gui::PastedRows", text);
}
QString trNumber(const char* text) {
    return QCoreApplication::translate("smat::gui::TypedNumber", text);
}

/// What a unit behind a number makes of it: value * factor + offset, in the unit of the field.
struct UnitBehind {
    const char* field;
    const char* typed;
    double factor, offset;
};
/// No "nm" for a length in m: it is typed for nautical miles and for nanometres.
constexpr UnitBehind unitsBehind[] = {
    {"m", "km", 1e3, 0.0},
    {"m", "cm", 1e-2, 0.0},
    {"m", "mm", 1e-3, 0.0},
    {"m", "um", 1e-6, 0.0},
    {"m", "ft", 0.3048, 0.0},
    {"m", "NM", 1852.0, 0.0},
    {"m", "nmi", 1852.0, 0.0},
    {"km", "m", 1e-3, 0.0},
    {"um", "nm", 1e-3, 0.0},
    {"um", "mm", 1e3, 0.0},
    {"s", "ms", 1e-3, 0.0},
    {"s", "min", 60.0, 0.0},
    {"s", "h", 3600.0, 0.0},
    {"K", "C", 1.0, irsg::kelvinFromCelsius(0.0)},
    {"C", "K", 1.0, irsg::celsiusFromKelvin(0.0)},
    {"deg", "rad", 180.0 / std::numbers::pi, 0.0},
    {"deg", "mrad", 0.18 / std::numbers::pi, 0.0},
    {"m/s", "km/h", 1.0 / 3.6, 0.0},
    {"m/s", "kn", 1852.0 / 3600.0, 0.0},
    {"", "%", 0.01, 0.0},
};

/// A unit in ASCII and without blanks: "µm" as "um", "W·m⁻²" as "Wm-2", "°C" as "C".
QString plainUnit(const QString& unit) {
    static const QString from = QStringLiteral("\u00b5\u03bc\u2212\u207b\u2070\u00b9\u00b2\u00b3"
                                               "\u2074\u2075\u2076\u2077\u2078\u2079");
    static const QString to = QStringLiteral("uu--0123456789");
    QString plain;
    for (const QChar letter : unit) {
        const qsizetype place = from.indexOf(letter);
        if (place >= 0)
            plain += to[place];
        else if (letter == QChar(0x00b0))
            plain += QStringLiteral("deg");
        else if (!letter.isSpace() && letter != QChar(0x00b7))
            plain += letter;
    }
    return plain == "degC" ? QStringLiteral("C") : plain;
}

QString unitsOf(const QString& field) {
    QStringList known;
    if (!field.isEmpty())
        known << field;
    for (const UnitBehind& unit : unitsBehind)
        if (field == QLatin1String(unit.field))
            known << QLatin1String(unit.typed);
    return known.join(", ");
}

std::optional<UnitBehind> unitBehind(const QString& field, const QString& typed) {
    if (typed.isEmpty() || typed == field)
        return UnitBehind{"", "", 1.0, 0.0};
    for (const UnitBehind& unit : unitsBehind)
        if (field == QLatin1String(unit.field) && typed == QLatin1String(unit.typed))
            return unit;
    return std::nullopt;
}

/// The cells of a line, apart by the first of these that it holds.
QStringList cellsOf(const QString& line) {
    for (const QChar separator : {QChar('\t'), QChar(';')})
        if (line.contains(separator))
            return line.split(separator);
    static const QRegularExpression blanks("\\s+");
    // "4,2 0,5" has commas in its numbers, "4.2,0.5" and "4.2, 0.5" between them.
    const QString trimmed = line.trimmed();
    const QStringList words = trimmed.split(blanks, Qt::SkipEmptyParts);
    const bool commasEndWords = std::any_of(words.begin(), words.end(), [](const QString& word) {
        return word.endsWith(',') || word.startsWith(',');
    });
    if (words.size() > 1 && !commasEndWords)
        return words;
    return trimmed.contains(',') ? trimmed.split(',') : words;
}

} // namespace

TypedNumber typedNumber(const QString& text, const QString& unit, NumberMeaning meaning) {
    QString plain = text.trimmed();
    plain.replace(QChar(0x2212), '-');
    static const QRegularExpression parts(
        R"(^([+-]?[0-9.,]+(?:[eE][+-]?[0-9]+)?)\s*([^\s0-9.,;+-].*)?$)");
    const auto found = parts.match(plain);
    const auto refused = [&](const char* sentence) {
        return TypedNumber{std::nullopt, trNumber(sentence).arg(text.trimmed())};
    };
    if (plain.isEmpty())
        return refused("'%1' is not a number: nothing stands there");
    if (!found.hasMatch())
        return refused("'%1' is not a number");
    QString digits = found.captured(1);
    if (digits.contains(',') && digits.contains('.'))
        return refused("'%1' has a point and a comma: write one of them, as the decimal sign");
    if (digits.count(',') + digits.count('.') > 1)
        return refused("'%1' has several decimal signs: digits are not grouped here");
    digits.replace(',', '.');
    bool isRight = false;
    const double value = digits.toDouble(&isRight);
    if (!isRight || !std::isfinite(value))
        return refused("'%1' is not a number");
    const QString field = plainUnit(unit), typed = plainUnit(found.captured(2));
    const auto behind = unitBehind(field, typed);
    if (behind && behind->offset != 0.0 && meaning == NumberMeaning::difference)
        return {std::nullopt, trNumber("'%1' is no unit of a difference here: write it in %2")
                                  .arg(found.captured(2), unit)};
    if (!behind) {
        const QString known = unitsOf(field);
        return {std::nullopt,
                known.isEmpty()
                    ? trNumber("'%1' stands behind a number without a unit").arg(found.captured(2))
                    : trNumber("'%1' is none of the units %2").arg(found.captured(2), known)};
    }
    const double inUnit = behind->factor * value + behind->offset;
    // Without the rounding of a conversion: 0.1 km is 100 m.
    return {typed.isEmpty() || typed == field ? value : QString::number(inUnit, 'g', 15).toDouble(),
            {}};
}

QString plainNumber(const QString& text, const QString& unit) {
    // A number as files have it keeps the digits that were typed.
    bool isPlain = false;
    text.trimmed().toDouble(&isPlain);
    if (isPlain)
        return text.trimmed();
    const TypedNumber typed = typedNumber(text, unit);
    if (!typed.value)
        return text;
    const double value = *typed.value;
    return value == std::trunc(value) && std::abs(value) < 1e15 ? QString::number(value, 'f', 0)
                                                                : textOf(value);
}

std::optional<double> numberOf(const QString& text) {
    return typedNumber(text).value;
}

QString textOf(double value) {
    return QString::fromStdString(irsg::numberText(value));
}

PastedRows rowsOf(const QString& text) {
    PastedRows pasted;
    static const QRegularExpression lineEnds("\r\n|\r|\n");
    int row = 0;
    bool first = true;
    for (const QString& line : text.split(lineEnds)) {
        ++row;
        if (line.trimmed().isEmpty() || line.startsWith('#'))
            continue;
        QStringList cells = cellsOf(line);
        while (cells.size() > 1 && cells.back().trimmed().isEmpty())
            cells.removeLast();
        const bool isFirst = std::exchange(first, false);
        if (isFirst && std::none_of(cells.begin(), cells.end(), numberOf))
            continue;
        std::vector<double> numbers;
        for (int column = 0; column < cells.size(); ++column) {
            const auto number = numberOf(cells[column]);
            if (!number) {
                pasted.problem = trRows("row %1, column %2: '%3' is not a number")
                                     .arg(row)
                                     .arg(column + 1)
                                     .arg(cells[column].trimmed());
                return pasted;
            }
            numbers.push_back(*number);
        }
        if (!pasted.rows.empty() && numbers.size() != pasted.rows.front().size()) {
            pasted.problem = trRows("row %1: %2 columns, but %3 in the rows before")
                                 .arg(row)
                                 .arg(numbers.size())
                                 .arg(pasted.rows.front().size());
            return pasted;
        }
        pasted.rows.push_back(std::move(numbers));
    }
    if (pasted.rows.empty())
        pasted.problem = trRows("the clipboard holds no numbers");
    return pasted;
}

} // namespace smat::gui
