#pragma once

#include <string>

namespace irsg {

/// 16 hexadecimal digits that tell this build of the libraries that compute from any other: a hash
/// of the build identifiers that the linker gave them (ELF note NT_GNU_BUILD_ID). Equal for every
/// program that uses the same libraries; empty where they carry none.
const std::string& buildId();

} // namespace irsg
