#include "gui/widgets/NumberFormat.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <QRegularExpression>

#include "irsg/core/Errors.h"
#include "irsg/core/Quantity.h"

namespace smat::gui {
namespace {

/// "W cm-2 (cm-1)-1" as "W·cm⁻²·(cm⁻¹)⁻¹"; what is no product of powers of units stays as it is.
QString withRaisedPowers(const QString& unit) {
    static const QString factor = "(?:[mkµu]?W|J|[mckµun]?m|sr|s|K|Hz)(?:-?[1-9])?";
    static const QRegularExpression product(
        QRegularExpression::anchoredPattern("(?:%1|\\(%1\\)-?[1-9])(?: (?:%1|\\(%1\\)-?[1-9]))*")
            .replace("%1", factor));
    if (!product.match(unit).hasMatch())
        return unit;
    static const QString raised = "⁰¹²³⁴⁵⁶⁷⁸⁹";
    QString result;
    for (const QChar sign : unit)
        result += sign == ' '      ? QChar(u'·')
                  : sign == '-'    ? QChar(u'⁻')
                  : sign.isDigit() ? raised[sign.digitValue()]
                                   : sign;
    return result;
}

} // namespace

QString formattedNumber(double value) {
    return std::isfinite(value) ? QString::number(value, 'g', 6) : QStringLiteral("no value");
}

QString sentenceNumber(double value, int digits) {
    if (!std::isfinite(value))
        return formattedNumber(value);
    const double rounded = QString::number(value, 'g', digits).toDouble();
    const double size = std::abs(rounded);
    return size != 0.0 && (size < 1e-4 || size >= 1e7)
               ? QString::number(rounded, 'g', digits)
               : QString::number(rounded, 'g', std::max(digits, 7));
}

QString exactNumber(double value) {
    return std::isfinite(value) ? QString::fromStdString(irsg::numberText(value)) : QString();
}

QString formattedUnit(const std::string& unit) {
    for (int i = 0; i <= static_cast<int>(irsg::Quantity::dimensionless); ++i) {
        const auto& info = irsg::info(static_cast<irsg::Quantity>(i));
        if (info.unit == unit)
            return QString::fromUtf8(info.prettyUnit.data(),
                                     static_cast<qsizetype>(info.prettyUnit.size()));
    }
    return withRaisedPowers(QString::fromStdString(unit));
}

namespace {

/// What stands for a unit behind a number, and what it is replaced by.
std::vector<std::pair<QRegularExpression, QString>> unitsInSentences() {
    // Longer units first: some begin like shorter ones.
    std::vector<std::pair<QString, QString>> units;
    for (int i = 0; i < static_cast<int>(irsg::Quantity::dimensionless); ++i) {
        const std::string unit(irsg::info(static_cast<irsg::Quantity>(i)).unit);
        if (const QString plain = QString::fromStdString(unit); formattedUnit(unit) != plain)
            units.emplace_back(plain, formattedUnit(unit));
    }
    std::ranges::sort(units, {}, [](const auto& unit) { return -unit.first.size(); });
    std::vector<std::pair<QRegularExpression, QString>> result;
    for (const auto& [plain, readable] : units)
        result.emplace_back(QRegularExpression("(?<=[0-9.]|\\bin) " +
                                               QRegularExpression::escape(plain) + "(?![\\w-])"),
                            (readable == "°" ? "" : " ") + readable);
    return result;
}

} // namespace

QString withFormattedUnits(QString sentence) {
    static const auto units = unitsInSentences();
    static const QRegularExpression times("(?<=\\d) x (?=\\d)");
    for (const auto& [plain, readable] : units)
        sentence.replace(plain, readable);
    return sentence.replace(times, " × ");
}

} // namespace smat::gui
