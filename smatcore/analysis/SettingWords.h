#pragma once

#include <string>
#include <string_view>

#include "smatcore/settings/Settings.h"

namespace smat {

/// The value of a setting as titles say it: "8-12 µm", "900 m", "12°", "midlatitude-summer" of a
/// file, "vacuum" where there is no air.
std::string valueWords(const Settings& settings, std::string_view key);
/// The same with what it is the value of, where that does not speak for itself: "range 900 m".
std::string settingWords(const Settings& settings, std::string_view key);

} // namespace smat
