#pragma once

#include <optional>
#include <string>

#include <QString>

#include "smatcore/settings/SettingInfo.h"

namespace smat::gui {

/// The canonical text of what was typed for a setting, numbers by the rule of typedNumber(); none
/// where it is no value.
std::optional<std::string> typedSetting(const SettingInfo& setting, const QString& typed);
/// Why it is none: "'2.5.0' has several decimal signs", or what is expected; empty where it is one.
QString problemOf(const SettingInfo& setting, const QString& typed);
/// What a setting takes, with long powers of ten as 10⁹: "a number from 1 to 16384 (px)".
QString expectedText(const SettingInfo& setting);

} // namespace smat::gui
