#pragma once

#include <string>
#include <string_view>

namespace irsg {

/// SHA-256 (FIPS 180-4) of `bytes` as 64 lower-case hexadecimal digits. It tells apart content that
/// was changed by accident or by another program; it is no signature against forgery, because the
/// hash lies beside the content.
std::string sha256(std::string_view bytes);

} // namespace irsg
