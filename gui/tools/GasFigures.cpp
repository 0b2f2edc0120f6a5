#include "gui/tools/GasFigures.h"

#include <algorithm>
#include <string>

#include <QCoreApplication>
#include <QStringList>

#include "gui/widgets/NumberFormat.h"
#include "irsg/gas/GasSpectrum.h"

namespace smat::gui {

namespace {

QString trWords(const char* text) {
    return QCoreApplication::translate("smat::gui::GasFigures", text);
}

const SummaryItem* find(const GasOutput& output, const std::string& label) {
    const auto found = std::ranges::find(output.summary, label, &SummaryItem::label);
    return found == output.summary.end() ? nullptr : &*found;
}

} // namespace

QString gasFigures(const GasOutput& output) {
    QStringList lines;
    const auto number = [](const SummaryItem& item) { return sentenceNumber(item.value); };
    const auto withUnit = [&](const SummaryItem& item) {
        return (number(item) + ' ' + formattedUnit(item.unit)).trimmed();
    };
    const auto add = [&](const char* label, const char* words) {
        if (const SummaryItem* item = find(output, label))
            lines << trWords(words).arg(withUnit(*item));
    };
    const SummaryItem *radiance = find(output, "band_radiance"),
                      *error = find(output, "error_band_radiance");
    if (radiance != nullptr && error != nullptr)
        lines << trWords("Band radiance: %1 ± %2").arg(number(*radiance), withUnit(*error));
    add("band_transmittance", "Band transmittance: %1");
    add("band_radiance_source", "Before the atmosphere: %1");
    add("band_radiance_source_radcal", "By RADCAL, of the gas alone: %1");
    add("band_radiance_product", "Product of means: %1");
    add("band_path_radiance", "Path radiance of the atmosphere: %1");
    for (std::size_t emitter = 0; emitter < irsg::gasEmitterCount; ++emitter) {
        const std::string gas = irsg::gasEmitterName(emitter);
        const SummaryItem* added = find(output, "band_radiance_added_" + gas);
        if (added == nullptr)
            continue;
        QString line = trWords("%1 adds %2").arg(QString::fromStdString(gas), withUnit(*added));
        // Soot has an index of refraction, and no table to choose.
        if (emitter < irsg::hotGasCount)
            line += trWords(", by %1").arg(QString::fromStdString(output.answeredBy[emitter]));
        lines << line;
    }
    for (const std::string& warning : output.warnings)
        lines << trWords("Note: %1").arg(QString::fromStdString(warning));
    return lines.join('\n');
}

} // namespace smat::gui
