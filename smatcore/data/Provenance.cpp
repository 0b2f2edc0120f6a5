#include "smatcore/data/Provenance.h"

#include <algorithm>

namespace smat {

void Provenance::add(std::string key, std::string value) {
    std::replace_if(
        value.begin(), value.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
    entries.emplace_back(std::move(key), std::move(value));
}

std::string Provenance::value(std::string_view key) const {
    for (const auto& [name, value] : entries)
        if (name == key)
            return value;
    return "";
}

std::string Provenance::toCsvLines() const {
    std::string lines;
    for (const auto& [key, value] : entries)
        lines += "# " + key + ": " + value + "\n";
    return lines;
}

} // namespace smat
