#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace irsg {

/// The SHA-256 of bytes that come piece by piece; see sha256().
class Sha256 {
  public:
    Sha256();
    void add(std::string_view bytes);
    /// Of all that was added; afterwards nothing may be.
    std::string text();

  private:
    std::array<std::uint32_t, 8> state_;
    std::string rest_; ///< less than a block
    std::uint64_t added_B_ = 0;
};

/// SHA-256 (FIPS 180-4) of `bytes` as 64 lower-case hexadecimal digits. It tells apart content that
/// was changed by accident or by another program; it is no signature against forgery, because the
/// hash lies beside the content.
std::string sha256(std::string_view bytes);

} // namespace irsg
