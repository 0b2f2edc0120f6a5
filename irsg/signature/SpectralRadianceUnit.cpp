#include <array>
#include <string_view>
#include <utility>

#include "irsg/core/CsvTable.h"
#include "irsg/core/Errors.h"
#include "irsg/signature/SpectrumCsv.h"

namespace irsg {

namespace {

struct NamedUnit {
    SpectralRadianceUnit unit;
    std::string power;     ///< "uW"
    std::string area;      ///< "cm"
    std::string_view axis; ///< "um" or "cm-1"
};

std::vector<NamedUnit> allUnits() {
    constexpr std::pair<const char*, const char*> powerAndArea[] = {
        {"W", "m"}, {"mW", "m"}, {"uW", "m"}, {"W", "cm"}, {"mW", "cm"}, {"uW", "cm"}};
    constexpr std::array<double, 6> toW_m2 = {1.0, 1e-3, 1e-6, 1e4, 10.0, 1e-2};
    std::vector<NamedUnit> units;
    for (std::size_t i = 0; i < toW_m2.size(); ++i) {
        const auto& [power, area] = powerAndArea[i];
        units.push_back({{toW_m2[i], false}, power, area, "um"});
        units.push_back({{toW_m2[i], true}, power, area, "cm-1"});
    }
    return units;
}

std::string canonicalText(const NamedUnit& unit) {
    return unit.power + " " + unit.area + "-2 sr-1 " +
           (unit.unit.perWavenumber ? "(cm-1)-1" : "um-1");
}

/// Every spelling of a unit, as `normalized` leaves it.
std::vector<std::string> spellings(const NamedUnit& unit) {
    const std::string axis(unit.axis);
    const std::string products = unit.power + unit.area + "-2sr-1";
    const std::string slashes = unit.power + "/" + unit.area + "2/sr/";
    const std::string bracket = unit.power + "/(" + unit.area + "2sr" + axis + ")";
    std::vector<std::string> forms = {products + "/" + axis, products + "per" + axis,
                                      slashes + axis, bracket};
    forms.push_back(products + (unit.unit.perWavenumber ? "(cm-1)-1" : "um-1"));
    return forms;
}

/// ASCII without blanks, points and carets: "µW·cm⁻² sr^-1" becomes "uWcm-2sr-1".
std::string normalized(std::string_view text) {
    constexpr std::pair<std::string_view, std::string_view> replacements[] = {
        {"\u00b5", "u"}, {"\u03bc", "u"}, {"\u207b", "-"}, {"\u2212", "-"}, {"\u00b9", "1"},
        {"\u00b2", "2"}, {"\u00b7", ""},  {" ", ""},       {"^", ""},       {"*", ""}};
    std::string result;
    while (!text.empty()) {
        std::size_t taken = 0;
        for (const auto& [from, to] : replacements) {
            if (taken == 0 && text.starts_with(from)) {
                result += to;
                taken = from.size();
            }
        }
        if (taken == 0) {
            result += text.front();
            taken = 1;
        }
        text.remove_prefix(taken);
    }
    return result;
}

} // namespace

SpectralRadianceUnit SpectralRadianceUnit::parse(const std::string& text) {
    const std::string wanted = normalized(text);
    for (const NamedUnit& unit : allUnits()) {
        for (const std::string& spelling : spellings(unit))
            if (wanted == spelling)
                return unit.unit;
    }
    std::string list;
    for (const std::string& name : known())
        list += (list.empty() ? "" : ", ") + name;
    throw InputError({"", "unit", "'" + text + "'", "one of " + list});
}

std::vector<std::string> SpectralRadianceUnit::known() {
    std::vector<std::string> names;
    for (const NamedUnit& unit : allUnits())
        names.push_back(canonicalText(unit));
    return names;
}

std::string SpectralRadianceUnit::text() const {
    for (const NamedUnit& unit : allUnits())
        if (unit.unit == *this)
            return canonicalText(unit);
    throw LogicError("a radiance unit of factor " + numberText(toW_m2) + " without a name");
}

} // namespace irsg
