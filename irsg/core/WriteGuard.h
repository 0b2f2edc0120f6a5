#pragma once

#include <filesystem>
#include <functional>

namespace irsg {

/// Is asked before any file is written (FileReplacement.h), and throws InputError for one that is
/// to stay as it is. Empty, the default, asks nobody. Set it before other threads write.
using WriteGuard = std::function<void(const std::filesystem::path& file)>;
void setWriteGuard(WriteGuard guard);

} // namespace irsg
