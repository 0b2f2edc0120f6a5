#pragma once

#include <string_view>

namespace irsg {

/// The bytes of resources/materials/library.json.
std::string_view materialLibraryText();

} // namespace irsg
