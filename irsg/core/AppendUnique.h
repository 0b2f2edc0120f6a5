#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace irsg {

/// Adds a line that is not among the others yet: warnings and remarks are told once.
inline void appendUnique(std::vector<std::string>& lines, std::string line) {
    if (std::ranges::find(lines, line) == lines.end())
        lines.push_back(std::move(line));
}

/// Each of some lines likewise.
inline void appendUnique(std::vector<std::string>& lines, const std::vector<std::string>& more) {
    for (const std::string& line : more)
        appendUnique(lines, line);
}

} // namespace irsg
