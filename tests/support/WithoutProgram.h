#pragma once

#include <cctype>
#include <string>

namespace smat::test {

/// JSON without the members that state which version wrote it, as an earlier program wrote it.
inline std::string withoutProgram(std::string json) {
    const std::string key = "\"program\":";
    for (std::size_t at = 0; (at = json.find(key)) != std::string::npos;) {
        std::size_t end = json.find('"', json.find('"', at + key.size()) + 1) + 1;
        if (json[end] == ',') {
            ++end;
        }
        while (std::isspace(static_cast<unsigned char>(json[at - 1])) != 0) {
            --at;
        }
        json.erase(at, end - at);
    }
    return json;
}

} // namespace smat::test
