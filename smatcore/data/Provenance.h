#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace smat {

/// Where numbers come from: ordered keys with their values, written ahead of every result. Holds no
/// clock, so that equal inputs give equal files. A key may occur more than once ("warning").
struct Provenance {
    std::vector<std::pair<std::string, std::string>> entries;

    void add(std::string key, std::string value);
    /// The first value of that key, or "".
    std::string value(std::string_view key) const;
    /// `# key: value` lines; line breaks inside values become blanks.
    std::string toCsvLines() const;
    bool operator==(const Provenance&) const = default;
};

} // namespace smat
