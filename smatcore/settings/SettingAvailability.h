#pragma once

#include <string>

#include "smatcore/settings/SettingInfo.h"

namespace smat {

/// Why a setting cannot be used in this build, in words for a form; empty where it can.
std::string whyUnavailable(const SettingInfo& setting);

} // namespace smat
