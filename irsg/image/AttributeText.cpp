#include "irsg/image/AttributeText.h"

#include <set>

namespace irsg {

namespace {

bool isReservedKey(std::string_view key) {
    static const std::set<std::string, std::less<>> keys = {"channel", "unit", "width", "height"};
    return keys.contains(key) || key.starts_with(attributePrefix);
}

std::string escaped(std::string_view text, bool isKey) {
    std::string out;
    for (const char c : text)
        if (c == '\\')
            out += "\\\\";
        else if (c == '\n')
            out += "\\n";
        else if (c == '\r')
            out += "\\r";
        else if (c == ':' && isKey)
            out += "\\c";
        else
            out += c;
    return out;
}

std::string unescaped(std::string_view text) {
    std::string out;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char next = text[i] == '\\' && i + 1 < text.size() ? text[i + 1] : '\0';
        const std::string_view codes = "\\nrc", meanings = "\\\n\r:";
        const std::size_t code = next == '\0' ? std::string_view::npos : codes.find(next);
        if (code == std::string_view::npos) {
            out += text[i];
        } else {
            out += meanings[code];
            ++i;
        }
    }
    return out;
}

} // namespace

std::string attributeLine(std::string_view key, std::string_view value) {
    return escaped(key, true) + ": " + escaped(value, false);
}

std::string imageAttributeLine(std::string_view key, std::string_view value) {
    return attributeLine(isReservedKey(key) ? std::string(attributePrefix) + std::string(key)
                                            : std::string(key),
                         value);
}

void AttributeText::read(std::string_view line) {
    const std::size_t colon = line.find(':');
    if (colon == std::string_view::npos)
        return;
    const std::string key = unescaped(line.substr(0, colon));
    std::string_view value = line.substr(colon + 1);
    if (value.starts_with(' '))
        value.remove_prefix(1);
    if (key.starts_with(attributePrefix))
        attributes[key.substr(attributePrefix.size())] = unescaped(value);
    else
        (isReservedKey(key) ? plane : attributes)[key] = unescaped(value);
}

} // namespace irsg
