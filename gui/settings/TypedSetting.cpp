#include "gui/settings/TypedSetting.h"

#include <algorithm>

#include <QRegularExpression>

#include "gui/widgets/NumberFormat.h"
#include "gui/widgets/NumberText.h"

namespace smat::gui {
namespace {

bool isNumber(const SettingInfo& setting) {
    return setting.kind == SettingKind::real || setting.kind == SettingKind::integer ||
           setting.kind == SettingKind::choiceOrReal;
}

} // namespace

std::optional<std::string> typedSetting(const SettingInfo& setting, const QString& typed) {
    const QString text = isNumber(setting) ? plainNumber(typed, textOf(setting.unit)) : typed;
    return canonicalText(setting, text.trimmed().toStdString());
}

QString problemOf(const SettingInfo& setting, const QString& typed) {
    if (typedSetting(setting, typed))
        return {};
    if (isNumber(setting))
        if (const QString problem = typedNumber(typed, textOf(setting.unit)).problem;
            !problem.isEmpty())
            return problem;
    return expectedText(setting);
}

QString expectedText(const SettingInfo& setting) {
    QString text = withFormattedUnits(textOf(setting.expected()));
    static const QRegularExpression power("\\b1(0{6,})\\b");
    for (auto found = power.match(text); found.hasMatch(); found = power.match(text)) {
        QString exponent = QString::number(found.capturedLength(1));
        for (QChar& digit : exponent)
            digit = QString("⁰¹²³⁴⁵⁶⁷⁸⁹").at(digit.digitValue());
        text.replace(found.capturedStart(), found.capturedLength(), "10" + exponent);
    }
    return text;
}

} // namespace smat::gui
