#include "smatcore/tools/KeyNumbers.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <sstream>

#include "irsg/core/CsvTable.h"
#include "smatcore/support/NearestNames.h"

namespace smat {

std::vector<irsg::Diagnostic> readKeyNumbers(const std::string& text, const std::string& name,
                                             const std::vector<NumberKey>& keys,
                                             const std::string& example,
                                             const std::function<void(std::size_t, double)>& set) {
    std::vector<irsg::Diagnostic> diagnostics;
    std::set<std::string> given;
    std::istringstream entries(text);
    for (std::string entry; std::getline(entries, entry, ',');) {
        const std::size_t sign = entry.find('=');
        const std::string key(irsg::trimmed(entry.substr(0, sign)));
        const auto known = std::ranges::find(keys, key, &NumberKey::key);
        if (sign == std::string::npos) {
            diagnostics.push_back({name, "", "'" + entry + "'", "KEY=NUMBER, as " + example});
        } else if (known == keys.end()) {
            std::vector<std::string> names;
            std::ranges::transform(keys, std::back_inserter(names), &NumberKey::key);
            diagnostics.push_back({name, "", key, oneOf(names, key)});
        } else if (!given.insert(key).second) {
            diagnostics.push_back({name, key, "it twice", "each key once"});
        } else if (const auto number = irsg::parseNumber(irsg::trimmed(entry.substr(sign + 1)))) {
            set(static_cast<std::size_t>(known - keys.begin()), *number);
        } else {
            diagnostics.push_back({name, key, "'" + entry.substr(sign + 1) + "'", "a number"});
        }
    }
    for (const NumberKey& key : keys)
        if (key.isNeeded && !given.contains(key.key))
            diagnostics.push_back({name, key.key, "nothing", "a number"});
    return diagnostics;
}

} // namespace smat
