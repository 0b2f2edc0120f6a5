#include "gui/analysis/SummaryText.h"

#include "gui/widgets/DisplayUnits.h"
#include "gui/widgets/NumberFormat.h"

namespace smat::gui {

QString summaryLine(const SummaryItem& item) {
    const QString label = withFormattedUnits(QString::fromStdString(item.label));
    const bool isSpread = label.contains("deviation") || label.contains("error");
    return QStringLiteral("%1: %2").arg(label, isSpread ? storedValueWithUnit(item.value, item.unit)
                                                        : valueWithUnit(item.value, item.unit));
}

} // namespace smat::gui
