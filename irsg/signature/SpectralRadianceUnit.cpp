#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <utility>

#include "irsg/core/Errors.h"
#include "irsg/signature/SpectrumCsv.h"

namespace irsg {

namespace {

/// 10^exponent, which is exact or the nearest double.
double powerOfTen(int exponent) {
    constexpr std::array<double, 17> powers = {1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 0.1, 1.0,
                                               10.0, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8};
    return powers[static_cast<std::size_t>(exponent + 8)];
}

struct NamedUnit {
    SpectralRadianceUnit unit;
    std::string text;
};

/// The canonical texts, each factor once.
const std::vector<NamedUnit>& allUnits() {
    static const std::vector<NamedUnit> all = [] {
        std::vector<NamedUnit> units;
        constexpr std::pair<const char*, int> powers[] = {{"W m-2", 0},   {"mW m-2", -3},
                                                          {"uW m-2", -6}, {"W cm-2", 4},
                                                          {"mW cm-2", 1}, {"uW cm-2", -2}};
        for (const auto& [text, exponent] : powers) {
            units.push_back({{powerOfTen(exponent), false}, std::string(text) + " sr-1 um-1"});
            units.push_back({{powerOfTen(exponent), true}, std::string(text) + " sr-1 (cm-1)-1"});
        }
        for (const auto& [axis, ten] : {std::pair("nm", 3), std::pair("angstrom", 4)})
            for (const auto& [text, exponent] : powers) {
                const SpectralRadianceUnit unit{powerOfTen(exponent + ten), false};
                if (std::ranges::find(units, unit, &NamedUnit::unit) == units.end())
                    units.push_back({unit, std::string(text) + " sr-1 " + axis + "-1"});
            }
        return units;
    }();
    return all;
}

/// ASCII, with points and stars as blanks: "µW·cm⁻² sr⁻¹" becomes "uW cm-2 sr-1".
std::string plainText(std::string_view text) {
    constexpr std::pair<std::string_view, std::string_view> replacements[] = {
        {"\u00b5", "u"},
        {"\u03bc", "u"},
        {"\u207b", "-"},
        {"\u2212", "-"},
        {"\u00b9", "1"},
        {"\u00b2", "2"},
        {"\u00b7", " "},
        {"\u22c5", " "},
        {"*", " "},
        {"^", ""},
        {".", " "},
        {"per ", "/"},
        {"micron", "um"},
        {"Angstrom", "angstrom"},
        {"\u00c5ngstr\u00f6m", "angstrom"},
        {"\u00e5ngstr\u00f6m", "angstrom"},
        {"\u00c5", "angstrom"},
        {"\u212b", "angstrom"}};
    std::string result;
    while (!text.empty()) {
        const auto found = std::ranges::find_if(
            replacements, [&](const auto& pair) { return text.starts_with(pair.first); });
        const bool isKnown = found != std::end(replacements);
        result += isKnown ? found->second : text.substr(0, 1);
        text.remove_prefix(isKnown ? found->first.size() : 1);
    }
    return result;
}

struct Factor {
    std::string unit;
    int exponent = 1;
    bool operator==(const Factor&) const = default;
};

/// Reads the factors of "W/(cm2 sr cm-1)". `keepsDividing`: a slash divides by all behind it.
class UnitParser {
  public:
    UnitParser(std::string_view text, bool keepsDividing)
        : rest_(text), keepsDividing_(keepsDividing) {}

    std::optional<std::vector<Factor>> factors() {
        std::vector<Factor> all;
        if (!product(all, 1, 0) || !rest_.empty())
            return std::nullopt;
        return all;
    }

  private:
    void skipBlanks() {
        while (rest_.starts_with(' ') || rest_.starts_with('\t'))
            rest_.remove_prefix(1);
    }

    bool product(std::vector<Factor>& all, int sign, int depth) {
        bool divides = false;
        for (skipBlanks(); !rest_.empty() && rest_[0] != ')'; skipBlanks()) {
            if (rest_[0] == '/') {
                rest_.remove_prefix(1);
                divides = true;
                continue;
            }
            if (!factor(all, divides ? -sign : sign, depth))
                return false;
            divides = divides && keepsDividing_;
        }
        return true;
    }

    bool factor(std::vector<Factor>& all, int sign, int depth) {
        if (rest_[0] == '(') {
            if (depth > 3)
                return false;
            rest_.remove_prefix(1);
            std::vector<Factor> inner;
            if (!product(inner, 1, depth + 1) || rest_.empty())
                return false;
            rest_.remove_prefix(1);
            const int power = exponent().value_or(1);
            for (Factor& one : inner) {
                one.exponent *= sign * power;
                all.push_back(std::move(one));
            }
            return true;
        }
        std::string unit;
        while (!rest_.empty() &&
               ((rest_[0] >= 'a' && rest_[0] <= 'z') || (rest_[0] >= 'A' && rest_[0] <= 'Z'))) {
            unit += rest_[0];
            rest_.remove_prefix(1);
        }
        // Products may be written without a blank: "mWcm-2".
        for (const std::string_view power : {"mW", "uW", "W"})
            if (unit.starts_with(power) && unit.size() > power.size()) {
                all.push_back({std::string(power), sign});
                unit.erase(0, power.size());
                break;
            }
        if (unit.empty())
            return takeOne();
        all.push_back({unit, sign * exponent().value_or(1)});
        return true;
    }

    /// The 1 of "1/cm".
    bool takeOne() {
        if (!rest_.starts_with('1'))
            return false;
        rest_.remove_prefix(1);
        return true;
    }

    std::optional<int> exponent() {
        const std::size_t digit = rest_.starts_with('-') || rest_.starts_with('+') ? 1 : 0;
        if (digit >= rest_.size() || rest_[digit] < '1' || rest_[digit] > '9')
            return std::nullopt;
        const int value = rest_[digit] - '0';
        const bool isNegative = rest_[0] == '-';
        rest_.remove_prefix(digit + 1);
        return isNegative ? -value : value;
    }

    std::string_view rest_;
    bool keepsDividing_;
};

/// The unit that factors make, where each is there once.
std::optional<SpectralRadianceUnit> unitOf(std::vector<Factor> factors) {
    constexpr std::pair<std::string_view, int> powers[] = {{"W", 0}, {"mW", -3}, {"uW", -6}};
    constexpr std::pair<std::string_view, int> areas[] = {{"m", 0}, {"cm", 4}};
    constexpr std::pair<std::string_view, int> axes[] = {{"um", 0}, {"nm", 3}, {"angstrom", 4}};
    const auto take = [&](std::string_view unit, int exponent) {
        const auto found = std::ranges::find(factors, Factor{std::string(unit), exponent});
        if (found == factors.end())
            return false;
        factors.erase(found);
        return true;
    };
    const auto takeOne = [&](const auto& list, int power) -> std::optional<int> {
        for (const auto& [unit, ten] : list)
            if (take(unit, power))
                return ten;
        return std::nullopt;
    };
    const std::optional<int> power = takeOne(powers, 1), area = takeOne(areas, -2);
    const bool hasAngle = take("sr", -1);
    const std::optional<int> axis = takeOne(axes, -1);
    const bool perWavenumber = !axis && take("cm", 1);
    if (!power || !area || !hasAngle || (!axis && !perWavenumber) || !factors.empty())
        return std::nullopt;
    return SpectralRadianceUnit{powerOfTen(*power + *area + axis.value_or(0)), perWavenumber};
}

} // namespace

SpectralRadianceUnit SpectralRadianceUnit::parse(const std::string& text) {
    const std::string plain = plainText(text);
    for (const bool keepsDividing : {false, true})
        if (auto factors = UnitParser(plain, keepsDividing).factors())
            if (const auto unit = unitOf(*std::move(factors)))
                return *unit;
    std::string list;
    for (const std::string& name : known())
        list += (list.empty() ? "" : ", ") + name;
    throw InputError({"", "unit", "'" + text + "'", "one of " + list});
}

std::vector<std::string> SpectralRadianceUnit::known() {
    std::vector<std::string> names;
    for (const NamedUnit& unit : allUnits())
        names.push_back(unit.text);
    return names;
}

std::string SpectralRadianceUnit::text() const {
    for (const NamedUnit& unit : allUnits())
        if (unit.unit == *this)
            return unit.text;
    throw LogicError("a radiance unit of factor " + numberText(toW_m2) + " without a name");
}

} // namespace irsg
