#include "irsg/core/Utf8.h"

namespace irsg {

namespace {

/// The bytes of the character at the beginning of a text; 0 where there is none.
std::size_t lengthOfFirst(std::string_view text) {
    const auto lead = static_cast<unsigned char>(text[0]);
    const std::size_t length = lead < 0x80                   ? 1
                               : lead >= 0xc2 && lead < 0xe0 ? 2
                               : lead >= 0xe0 && lead < 0xf0 ? 3
                               : lead >= 0xf0 && lead < 0xf5 ? 4
                                                             : 0;
    if (length == 0 || length > text.size())
        return 0;
    for (std::size_t k = 1; k < length; ++k)
        if ((static_cast<unsigned char>(text[k]) & 0xc0) != 0x80)
            return 0;
    const auto second = length > 1 ? static_cast<unsigned char>(text[1]) : 0;
    const bool isForbidden = (lead == 0xe0 && second < 0xa0) || (lead == 0xed && second > 0x9f) ||
                             (lead == 0xf0 && second < 0x90) || (lead == 0xf4 && second > 0x8f);
    return isForbidden ? 0 : length;
}

void appendUtf8(std::string& text, char32_t character) {
    const auto byte = [&](unsigned bits) { text += static_cast<char>(bits); };
    if (character < 0x80) {
        byte(character);
        return;
    }
    if (character < 0x800) {
        byte(0xc0 | (character >> 6));
    } else if (character < 0x10000) {
        byte(0xe0 | (character >> 12));
        byte(0x80 | ((character >> 6) & 0x3f));
    } else {
        byte(0xf0 | (character >> 18));
        byte(0x80 | ((character >> 12) & 0x3f));
        byte(0x80 | ((character >> 6) & 0x3f));
    }
    byte(0x80 | (character & 0x3f));
}

} // namespace

bool isUtf8(std::string_view text) {
    while (!text.empty()) {
        const std::size_t length = lengthOfFirst(text);
        if (length == 0)
            return false;
        text.remove_prefix(length);
    }
    return true;
}

std::u32string charactersOf(std::string_view text) {
    std::u32string characters;
    while (!text.empty()) {
        const std::size_t length = lengthOfFirst(text);
        const auto lead = static_cast<unsigned char>(text[0]);
        char32_t character = length == 0   ? 0xFFFD
                             : length == 1 ? lead
                                           : lead & (0xFFU >> (length + 1));
        for (std::size_t k = 1; k < length; ++k)
            character = (character << 6) | (static_cast<unsigned char>(text[k]) & 0x3FU);
        characters += character;
        text.remove_prefix(length == 0 ? 1 : length);
    }
    return characters;
}

std::string utf8Text(std::string_view text) {
    if (isUtf8(text))
        return std::string(text);
    std::string result;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x80) {
            result += c;
        } else {
            result += static_cast<char>(0xc0 | (byte >> 6));
            result += static_cast<char>(0x80 | (byte & 0x3f));
        }
    }
    return result;
}

std::string asciiText(std::string_view text) {
    constexpr char digits[] = "0123456789abcdef";
    std::string result;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte >= 0x20 && byte < 0x7f)
            result += c;
        else
            (result += "\\x") += {digits[byte >> 4], digits[byte & 15]};
    }
    return result;
}

std::string_view withoutByteOrderMark(std::string_view text) {
    if (text.starts_with("\xEF\xBB\xBF"))
        text.remove_prefix(3);
    return text;
}

bool isUtf16(std::string_view bytes) {
    return bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF");
}

std::string_view utf8Of(std::string_view bytes, std::string& storage) {
    const std::string_view text = withoutByteOrderMark(bytes);
    storage = isUtf16(bytes) ? decodedUtf16(bytes) : isUtf8(text) ? "" : utf8Text(text);
    return storage.empty() ? text : std::string_view(storage);
}

std::string decodedUtf16(std::string_view bytes) {
    const bool isLittle = bytes.starts_with("\xFF\xFE");
    std::string text;
    if (!isUtf16(bytes))
        return text;
    const auto unit = [&](std::size_t i) {
        const auto first = static_cast<unsigned char>(bytes[i]);
        const auto second = static_cast<unsigned char>(bytes[i + 1]);
        return static_cast<char32_t>(isLittle ? second << 8 | first : first << 8 | second);
    };
    for (std::size_t i = 2; i + 1 < bytes.size(); i += 2) {
        char32_t character = unit(i);
        const bool isHigh = character >= 0xd800 && character < 0xdc00;
        if (isHigh && i + 3 < bytes.size() && unit(i + 2) >= 0xdc00 && unit(i + 2) < 0xe000) {
            character = 0x10000 + ((character - 0xd800) << 10) + (unit(i + 2) - 0xdc00);
            i += 2;
        } else if (character >= 0xd800 && character < 0xe000) {
            character = 0xfffd;
        }
        appendUtf8(text, character);
    }
    return text;
}

} // namespace irsg
