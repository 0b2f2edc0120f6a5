#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace irsg {

/// "a", "a or b", "a, b or c": what a message says may stand somewhere.
inline std::string alternatives(const std::vector<std::string>& words) {
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i)
        text += (i == 0 ? "" : i + 1 == words.size() ? " or " : ", ") + words[i];
    return text;
}

} // namespace irsg
