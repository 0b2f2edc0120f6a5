#pragma once

#include "smatcore/settings/SettingInfo.h"
#include "smatcore/settings/SettingKeys.h"

namespace smat::rows {

/// Rows of the settings table, one for each type of key. `option` is the option of the command
/// line, `help` one or more sentences.
SettingInfo number(RealKey key, std::string option, std::string label, std::string unit,
                   double minimum, double maximum, std::string defaultText, std::string help,
                   SettingAudience audience = SettingAudience::basic);
SettingInfo integer(IntegerKey key, std::string option, std::string label, std::string unit,
                    double minimum, double maximum, std::string defaultText, std::string help,
                    SettingAudience audience = SettingAudience::basic);
SettingInfo flag(BooleanKey key, std::string option, std::string label, bool byDefault,
                 std::string help, SettingAudience audience = SettingAudience::basic);
SettingInfo choice(TextKey key, std::string option, std::string label,
                   std::vector<std::string> choices, std::string defaultText, std::string help,
                   SettingAudience audience = SettingAudience::basic);
SettingInfo choiceOrNumber(OptionalRealKey key, std::string option, std::string label,
                           std::string unit, std::vector<std::string> choices, double minimum,
                           double maximum, std::string defaultText, std::string help,
                           SettingAudience audience = SettingAudience::basic);
SettingInfo numbers(RealListKey key, std::string option, std::string label, std::string unit,
                    std::vector<std::string> choices, double minimum, double maximum,
                    std::string defaultText, std::string help,
                    SettingAudience audience = SettingAudience::basic);
SettingInfo bands(TextKey key, std::string option, std::string label, std::string defaultText,
                  std::string help);
SettingInfo file(PathsKey key, std::string option, std::string label, std::string help);
SettingInfo files(PathsKey key, std::string option, std::string label, std::string help);
/// How the cases of a sweep stand: `fixed`, or `adaptive`, `how` far.
SettingInfo adaptiveSteps(TextKey key, const std::string& how);
/// The same of a plot, which is adaptive where `step`, the setting of its cases, is `auto`.
SettingInfo stepsOfPlot(TextKey key, const std::string& step, const std::string& how);
/// A row that earlier versions named otherwise.
SettingInfo formerly(SettingInfo info, FormerNames former);
/// A row with words for forms, one of each choice.
SettingInfo named(SettingInfo info, std::vector<std::string> names);

} // namespace smat::rows
