#pragma once

#include "smatcore/settings/SettingInfo.h"

namespace smat::rows {

/// Rows of the settings table, by what a setting holds. `key` is "section.name", `option` the
/// option of the command line, `help` one or more sentences.
SettingInfo number(std::string key, std::string option, std::string label, std::string unit,
                   double minimum, double maximum, std::string defaultText, std::string help,
                   SettingAudience audience = SettingAudience::basic);
SettingInfo integer(std::string key, std::string option, std::string label, std::string unit,
                    double minimum, double maximum, std::string defaultText, std::string help,
                    SettingAudience audience = SettingAudience::basic);
SettingInfo choice(std::string key, std::string option, std::string label,
                   std::vector<std::string> choices, std::string defaultText, std::string help,
                   SettingAudience audience = SettingAudience::basic);
SettingInfo choiceOrNumber(std::string key, std::string option, std::string label, std::string unit,
                           std::vector<std::string> choices, double minimum, double maximum,
                           std::string defaultText, std::string help,
                           SettingAudience audience = SettingAudience::basic);
SettingInfo text(std::string key, std::string option, std::string label, std::string unit,
                 SettingKind kind, std::string defaultText, std::string help,
                 SettingAudience audience = SettingAudience::basic);
/// A row with words for forms, one of each choice.
SettingInfo named(SettingInfo info, std::vector<std::string> names);

} // namespace smat::rows
