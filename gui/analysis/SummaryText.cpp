#include "gui/analysis/SummaryText.h"

#include <cmath>

#include "gui/widgets/DisplayUnits.h"
#include "gui/widgets/NumberFormat.h"

namespace smat::gui {

namespace {

/// Counts are whole; a measure has the digits that one reads.
QString wordsOf(double value) {
    return value == std::trunc(value) ? formattedNumber(value) : sentenceNumber(value);
}

} // namespace

QString summaryLine(const SummaryItem& item) {
    const QString label = withFormattedUnits(QString::fromStdString(item.label));
    const bool isSpread = label.contains("deviation") || label.contains("error");
    return QStringLiteral("%1: %2").arg(
        label, isSpread ? storedValueWithUnit(item.value, item.unit, wordsOf)
                        : valueWithUnit(item.value, item.unit, wordsOf));
}

} // namespace smat::gui
