#pragma once

#include <string>

namespace irsg {

/// "0.3.0": the version that CMakeLists.txt states.
std::string programVersion();
/// "smat 0.3.0", which every file that can hold it states under `program`: the version that wrote
/// the file. Readers ignore it, and a file without it is as good.
std::string programWithVersion();

} // namespace irsg
