#pragma once

#include <string>
#include <string_view>

namespace irsg {

/// Well-formed UTF-8 after RFC 3629: no stray or missing continuation, no overlong form, no
/// surrogate, nothing above U+10FFFF.
bool isUtf8(std::string_view text);

/// The characters of a text; each byte that is part of none (see isUtf8) is one of U+FFFD.
std::u32string charactersOf(std::string_view text);

/// The text where it is UTF-8; else each of its bytes as a character of Latin-1 (ISO 8859-1).
std::string utf8Text(std::string_view text);

/// The text with every byte that is not a character of ASCII as \\xNN: fit for any message.
std::string asciiText(std::string_view text);

/// The text without the byte order mark of UTF-8.
std::string_view withoutByteOrderMark(std::string_view text);

/// Whether bytes begin with a byte order mark of UTF-16.
bool isUtf16(std::string_view bytes);

/// The text of a file in UTF-8: without a byte order mark, from UTF-16 with one, from Latin-1 where
/// it is neither. `storage` holds it where it had to be made, and is empty otherwise; the text
/// lives as long as both.
std::string_view utf8Of(std::string_view bytes, std::string& storage);

/// Bytes that begin with a byte order mark of UTF-16 as UTF-8, without it; halves of characters are
/// U+FFFD. Empty for any other bytes.
std::string decodedUtf16(std::string_view bytes);

} // namespace irsg
