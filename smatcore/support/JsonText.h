#pragma once

#include <algorithm>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "irsg/radiometry/Errors.h"
#include "smatcore/support/JsonLines.h"

namespace smat {

/// Deeper than any file of ours; the library's own writer would run out of stack far beyond it.
inline constexpr int deepestJson = 100;

/// The value of a JSON text. Throws InputError with the line of the first diagnostic for text that
/// is not JSON or nested deeper than deepestJson; `expected` says what the file should have been. A
/// zero byte is refused here, because the library takes it for the end of the text and says nothing
/// of what follows.
template <typename Json>
Json parseJsonText(const std::string& text, const std::string& file, const std::string& expected) {
    const auto refuse = [&](std::size_t byte, const std::string& value) {
        throw irsg::InputError(
            irsg::Diagnostic{.file = file,
                             .position = "line " + std::to_string(lineOfByte(text, byte)),
                             .value = value,
                             .expected = expected});
    };
    if (const std::size_t zero = text.find('\0'); zero != std::string::npos) {
        refuse(zero, "a zero byte");
    }
    const std::size_t tooDeep = byteOfNesting(text, deepestJson);
    if (tooDeep != std::string::npos) {
        refuse(tooDeep,
               "lists or objects nested more than " + std::to_string(deepestJson) + " deep");
    }
    try {
        return Json::parse(text);
    } catch (const typename Json::parse_error& error) {
        refuse(error.byte, "text that is not JSON");
    } catch (const typename Json::out_of_range& error) {
        // The library's words: "number overflow parsing '1e999'".
        const std::string_view words = error.what();
        const std::size_t from = words.find('\''), to = words.rfind('\'');
        const std::string number(from < to ? words.substr(from + 1, to - from - 1) : "");
        refuse(std::min(text.find(number), text.size()),
               "the number " + number + ", which is too large");
    }
    return {};
}

} // namespace smat
