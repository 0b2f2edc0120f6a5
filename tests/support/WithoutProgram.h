#pragma once

#include <regex>
#include <string>

namespace smat::test {

/// JSON without the members that state which version wrote it, as an earlier program wrote it.
inline std::string withoutProgram(const std::string& json) {
    return std::regex_replace(json, std::regex("\\s*\"program\": ?\"smat [^\"]*\",?"), "");
}

} // namespace smat::test
