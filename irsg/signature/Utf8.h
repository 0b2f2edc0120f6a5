#pragma once

#include <string_view>

namespace irsg {

/// Well-formed UTF-8 after RFC 3629: no stray or missing continuation, no overlong form, no
/// surrogate, nothing above U+10FFFF.
bool isUtf8(std::string_view text);

} // namespace irsg
