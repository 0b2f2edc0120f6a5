#include "irsg/geometry/reading/text/UnitWords.h"

#include <algorithm>
#include <vector>

#include "irsg/core/CsvTable.h"
#include "irsg/core/Wording.h"

namespace irsg {

namespace {

struct NamedUnit {
    double unit_m;
    std::string_view names[7];
};
constexpr NamedUnit known[] = {
    {1.0, {"m", "meter", "meters", "metre", "metres", "mtr"}},
    {0.1, {"dm", "decimeter", "decimeters", "decimetre", "decimetres"}},
    {0.01, {"cm", "centimeter", "centimeters", "centimetre", "centimetres"}},
    {0.001, {"mm", "millimeter", "millimeters", "millimetre", "millimetres"}},
    {1e-6, {"um", "micron", "microns", "micrometer", "micrometers", "micrometre", "micrometres"}},
    {1000.0, {"km", "kilometer", "kilometers", "kilometre", "kilometres"}},
    {0.0254, {"in", "inch", "inches"}},
    {0.3048, {"ft", "foot", "feet"}},
    {0.9144, {"yd", "yard", "yards"}},
    {1609.344, {"mi", "mile", "miles"}},
    {1852.0, {"nmi"}}};

/// Behind one of these a unit may be named.
constexpr std::string_view announcing[] = {
    "unit",       "units",       "dimension",   "dimensions",   "length", "lengths",
    "coordinate", "coordinates", "measurement", "measurements", "scale",  "size",
    "sizes",      "measured",    "distances",   "modelled",     "modeled"};

std::optional<double> unitOf(std::string_view word) {
    for (const NamedUnit& unit : known)
        if (std::ranges::find(unit.names, word) != std::end(unit.names))
            return unit.unit_m;
    return std::nullopt;
}

bool isLetter(char c) {
    return c >= 'a' && c <= 'z';
}

bool isOfNumber(char c) {
    return (c >= '0' && c <= '9') || c == '.';
}

/// Words of letters, numbers, and single other characters that are not blank.
std::vector<std::string> wordsOf(const std::string& line) {
    std::vector<std::string> words;
    for (std::size_t at = 0; at < line.size();) {
        std::size_t end = at + 1;
        if (isLetter(line[at]))
            end = static_cast<std::size_t>(
                std::find_if_not(line.begin() + static_cast<long>(at), line.end(), isLetter) -
                line.begin());
        else if (isOfNumber(line[at]))
            end = static_cast<std::size_t>(
                std::find_if_not(line.begin() + static_cast<long>(at), line.end(), isOfNumber) -
                line.begin());
        if (line[at] != ' ' && line[at] != '\t')
            words.push_back(line.substr(at, end - at));
        at = end;
    }
    return words;
}

} // namespace

std::optional<UnitInWords> unitInWords(std::string_view line) {
    constexpr std::size_t longest = 200;
    const std::vector<std::string> words = wordsOf(lowerCase(std::string(line.substr(0, longest))));
    bool announced = false;
    std::optional<UnitInWords> found;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (announced && (words[i] == "per" || words[i] == "/"))
            return std::nullopt;
        if (std::ranges::find(announcing, words[i]) != std::end(announcing)) {
            announced = true;
            continue;
        }
        const auto unit_m = announced ? unitOf(words[i]) : std::nullopt;
        if (!unit_m)
            continue;
        // "in" is a word of English before another one.
        if (words[i] == "in" && i + 1 < words.size())
            continue;
        const auto times = i > 0 ? parseNumber(words[i - 1]) : std::nullopt;
        const UnitInWords said{*unit_m * times.value_or(1.0),
                               (times ? words[i - 1] + " " : "") + words[i]};
        if (!(said.unit_m >= 1e-6 && said.unit_m <= 1e6) || (found && found->unit_m != said.unit_m))
            return std::nullopt;
        found = said;
    }
    return found;
}

} // namespace irsg
