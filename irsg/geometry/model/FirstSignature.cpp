#include "irsg/geometry/model/FirstSignature.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "irsg/core/Errors.h"
#include "irsg/signature/MaterialLibrary.h"

namespace irsg {
namespace {

using Kind = FirstTemperature::Kind;

constexpr double turbulentRecovery = 0.89; ///< of a turbulent boundary layer, by custom

struct Word {
    const char* part;     ///< of a name in small letters
    const char* material; ///< how the library calls it
    FirstTemperature temperature;
};

constexpr FirstTemperature air{}, recovery{Kind::recovery, 0.0};
constexpr FirstTemperature warmer(double kelvin) {
    return {Kind::aboveAir, kelvin};
}

/// The first that a name holds counts: what is hot, to "engine"; what it is made of, to "seat"; its
/// colour, or the part that it is.
constexpr Word words[] = {
    {"afterburner", "nickel alloy, oxidised (exhaust parts)", warmer(700.0)},
    {"exhaust", "nickel alloy, oxidised (exhaust parts)", warmer(400.0)},
    {"nozzle", "nickel alloy, oxidised (exhaust parts)", warmer(400.0)},
    {"tailpipe", "nickel alloy, oxidised (exhaust parts)", warmer(400.0)},
    {"turbine", "nickel alloy, oxidised (exhaust parts)", warmer(400.0)},
    {"muffler", "rusted steel", warmer(250.0)},
    {"funnel", "grey aircraft paint, matt", warmer(60.0)},
    {"stack", "grey aircraft paint, matt", warmer(60.0)},
    {"airbrake", "grey aircraft paint, matt", recovery},
    {"speedbrake", "grey aircraft paint, matt", recovery},
    {"brake", "rusted steel", warmer(80.0)},
    {"engine", "weathered bare aluminium", warmer(40.0)},
    {"canopy", "acrylic canopy, 8 mm", recovery},
    {"cockpit", "acrylic canopy, 8 mm", recovery},
    {"plexi", "acrylic canopy, 8 mm", recovery},
    {"acryl", "acrylic canopy, 8 mm", recovery},
    {"fiberglas", "carbon fibre composite, unpainted", recovery},
    {"fibreglas", "carbon fibre composite, unpainted", recovery},
    {"glass", "window glass, 4 mm", air},
    {"glas", "window glass, 4 mm", air},
    {"window", "window glass, 4 mm", air},
    {"windsh", "window glass, 4 mm", air},
    {"windscreen", "window glass, 4 mm", air},
    {"wheel", "rubber, tyre", warmer(15.0)},
    {"tire", "rubber, tyre", warmer(15.0)},
    {"tyre", "rubber, tyre", warmer(15.0)},
    {"rubber", "rubber, tyre", air},
    {"track", "rubber, tyre", warmer(15.0)},
    {"soot", "soot, thick layer", warmer(20.0)},
    {"rust", "rusted steel", air},
    {"titan", "titanium, bare", recovery},
    {"gold", "gold, polished", air},
    {"galvan", "galvanised steel, weathered", air},
    {"anodi", "anodised aluminium", air},
    {"chrome", "stainless steel, polished", air},
    {"stainless", "stainless steel, polished", air},
    {"steel", "stainless steel, oxidised in service", air},
    {"iron", "rusted steel", air},
    {"alumin", "weathered bare aluminium", recovery},
    {"metal", "weathered bare aluminium", recovery},
    {"carbon", "carbon fibre composite, unpainted", recovery},
    {"composite", "carbon fibre composite, unpainted", recovery},
    {"rotor", "carbon fibre composite, unpainted", recovery},
    {"prop", "carbon fibre composite, unpainted", recovery},
    {"blade", "carbon fibre composite, unpainted", recovery},
    {"concrete", "concrete", warmer(5.0)},
    {"asphalt", "asphalt", warmer(10.0)},
    {"road", "asphalt", warmer(10.0)},
    {"grass", "green leaves", air},
    {"leaf", "green leaves", air},
    {"leaves", "green leaves", air},
    {"tree", "green leaves", air},
    {"sand", "dry sand, quartz", warmer(10.0)},
    {"snow", "snow", air},
    {"water", "sea water, calm, near the normal", air},
    {"human", "human skin", {Kind::fixed, 306.0}},
    {"face", "human skin", {Kind::fixed, 306.0}},
    {"cloth", "cotton cloth, dark", warmer(5.0)},
    {"fabric", "cotton cloth, dark", air},
    {"seat", "cotton cloth, dark", air},
    {"olive", "olive drab camouflage paint", recovery},
    {"camo", "olive drab camouflage paint", recovery},
    {"green", "olive drab camouflage paint", recovery},
    {"army", "olive drab camouflage paint", recovery},
    {"white", "white paint, titanium dioxide", recovery},
    {"black", "flat black paint", recovery},
    {"grey", "grey aircraft paint, matt", recovery},
    {"gray", "grey aircraft paint, matt", recovery},
    {"paint", "grey aircraft paint, matt", recovery},
    {"skin", "grey aircraft paint, matt", recovery},
    {"body", "grey aircraft paint, matt", recovery},
    {"fuselage", "grey aircraft paint, matt", recovery},
    {"wing", "grey aircraft paint, matt", recovery},
    {"hull", "grey aircraft paint, matt", recovery},
};
constexpr const char* otherwise = "grey aircraft paint, matt";

int libraryIndex(const char* name) {
    for (const auto& [index, material] : materialLibrary().materials)
        if (material.name == name)
            return index;
    throw LogicError("the library of materials has no " + std::string(name));
}

/// The words of a name in small letters, and neighbours as one: "LeftNozzle_02" is "left",
/// "nozzle", "leftnozzle"; "air_brake" is no brake.
std::vector<std::string> wordsOf(const std::string& name) {
    std::vector<std::string> found(1);
    char before = ' ';
    for (const char letter : name) {
        const auto byte = static_cast<unsigned char>(letter);
        const bool begins =
            std::isupper(byte) != 0 && std::islower(static_cast<unsigned char>(before)) != 0;
        if ((std::isalpha(byte) == 0 || begins) && !found.back().empty())
            found.emplace_back();
        if (std::isalpha(byte) != 0)
            found.back() += static_cast<char>(std::tolower(byte));
        before = letter;
    }
    for (std::size_t i = 1, count = found.size(); i < count; ++i)
        found.push_back(found[i - 1] + found[i]);
    return found;
}

/// Short words stand at the beginning of one of the name: "surface" is no face, "environment" no
/// iron. Longer ones may be anywhere: "leftnozzle".
bool says(const std::vector<std::string>& name, const char* part) {
    constexpr std::size_t longWord = 5;
    const std::size_t length = std::char_traits<char>::length(part);
    return std::ranges::any_of(name, [&](const std::string& word) {
        const auto at = word.find(part);
        return at == 0 || (at != word.npos && length >= longWord);
    });
}

/// The place of the first word of the list that a name says; their number where it says none.
std::size_t placeOf(const std::string& name) {
    const auto spoken = wordsOf(name);
    const auto found =
        std::ranges::find_if(words, [&](const Word& word) { return says(spoken, word.part); });
    return static_cast<std::size_t>(found - std::begin(words));
}

/// What is hot counts wherever it stands, the hottest first. Of the other words those of what a
/// surface is made of count before colours and parts, and the name of a material before that of an
/// object before that of a group: the seat in a cockpit is no canopy.
int strengthOf(std::size_t place, CodeRule::Of of) {
    const auto isBehind = [&](const char* last) {
        return place >
               static_cast<std::size_t>(
                   std::ranges::find(words, std::string_view(last),
                                     [](const Word& word) { return std::string_view(word.part); }) -
                   std::begin(words));
    };
    const int left = static_cast<int>(std::size(words) - place), kind = 2 - static_cast<int>(of);
    if (!isBehind("engine"))
        return 100000 + 3 * left + kind;
    return (isBehind("seat") ? 0 : 10000) + 1000 * kind + left;
}

FirstSurface suggestion(CodeRule::Of of, const std::string& name) {
    FirstSurface surface;
    surface.of = of;
    surface.name = name;
    const std::size_t place = placeOf(name);
    const bool isKnown = place < std::size(words);
    surface.libraryMaterial = libraryIndex(isKnown ? words[place].material : otherwise);
    surface.temperature = isKnown ? words[place].temperature : recovery;
    surface.because = isKnown ? words[place].part : "";
    surface.strength = strengthOf(place, of);
    return surface;
}

/// Names of a kind, and which of them may give a surface.
class NamesOfParts {
  public:
    explicit NamesOfParts(const NamedParts& parts) {
        for (const auto& [names, extent] : parts) {
            ++counts_[{CodeRule::Of::material, names.material}];
            ++counts_[{CodeRule::Of::object, names.object}];
            for (const std::string& group : std::set(names.groups.begin(), names.groups.end()))
                ++counts_[{CodeRule::Of::group, group}];
        }
        parts_ = parts.size();
    }
    /// The name of the whole says nothing of a part.
    bool isOfPart(CodeRule::Of of, const std::string& name) const {
        return of == CodeRule::Of::material || parts_ == 1 || counts_.at({of, name}) < parts_;
    }
    /// Whether names of a kind tell faces apart that no word tells apart. Materials say most; of
    /// objects and groups only as many as a person looks through.
    bool tells(CodeRule::Of of) const {
        const auto isOf = [&](const auto& count) { return count.first.first == of; };
        const auto number = std::ranges::count_if(counts_, isOf);
        return number > 0 && (number > 1 || !counts_.contains({of, ""})) &&
               (of == CodeRule::Of::material || number <= mostOfAKind);
    }
    static constexpr std::ptrdiff_t mostOfAKind = 100;

  private:
    std::map<std::pair<CodeRule::Of, std::string>, std::size_t> counts_;
    std::size_t parts_ = 0;
};

/// All names of a part, each with its kind, in the order in which equal words count.
std::vector<std::pair<CodeRule::Of, std::string>> namesOf(const FaceNames& part) {
    std::vector<std::pair<CodeRule::Of, std::string>> names{{CodeRule::Of::material, part.material},
                                                            {CodeRule::Of::object, part.object}};
    for (const std::string& group : part.groups)
        names.emplace_back(CodeRule::Of::group, group);
    return names;
}

using SurfacesByName = std::map<std::pair<CodeRule::Of, std::string>, FirstSurface>;

constexpr int weakest = -1; ///< of a rule that fits all faces

/// Makes one surface, "rivet*", of "rivet1", "rivet2" ... where a kind has more surfaces than a
/// person looks through.
void joinSeries(SurfacesByName& surfaces, CodeRule::Of kind) {
    const auto isOfKind = [&](const auto& surface) { return surface.first.first == kind; };
    if (std::ranges::count_if(surfaces, isOfKind) <= NamesOfParts::mostOfAKind)
        return;
    SurfacesByName joined;
    for (auto& [key, surface] : surfaces) {
        std::string name = key.second;
        if (key.first == kind) {
            name.clear();
            for (const char letter : key.second)
                if (std::isdigit(static_cast<unsigned char>(letter)) == 0)
                    name += letter;
                else if (name.empty() || name.back() != '*')
                    name += '*';
        }
        const auto [place, isNew] = joined.try_emplace({key.first, name}, surface);
        place->second.name = name;
        if (!isNew) {
            place->second.polygons += surface.polygons;
            place->second.area += surface.area;
        }
    }
    surfaces = std::move(joined);
}

TemperatureEntry entryOf(const FirstTemperature& temperature) {
    TemperatureEntry entry;
    entry.name = nameOf(temperature);
    entry.notes = "A first choice, not measured.";
    if (temperature.kind == Kind::fixed) {
        entry.terms.base_K = temperature.kelvin;
        return entry;
    }
    entry.terms = TemperatureTerms::ofAmbient();
    if (temperature.kind == Kind::aboveAir)
        entry.terms.base_K = temperature.kelvin;
    if (temperature.kind == Kind::recovery)
        entry.terms.recoveryFactor = turbulentRecovery;
    return entry;
}

/// The number of a value among those that came before, from 1; a new one is added.
template <typename Value>
int numberOf(std::vector<Value>& known, const Value& value) {
    const auto found = std::ranges::find(known, value);
    if (found != known.end())
        return static_cast<int>(found - known.begin()) + 1;
    known.push_back(value);
    return static_cast<int>(known.size());
}

} // namespace

std::string nameOf(const FirstTemperature& temperature) {
    char text[48];
    switch (temperature.kind) {
    case Kind::air:
        return "air";
    case Kind::recovery:
        return "recovery temperature of the air";
    case Kind::aboveAir:
        std::snprintf(text, sizeof text, "air %c %.6g K", temperature.kelvin < 0.0 ? '-' : '+',
                      std::abs(temperature.kelvin));
        return text;
    case Kind::fixed:
        std::snprintf(text, sizeof text, "%.6g K", temperature.kelvin);
        return text;
    }
    throw LogicError("unknown kind of temperature");
}

std::vector<FirstSurface> suggestedSurfaces(const NamedParts& parts) {
    const NamesOfParts known(parts);
    std::optional<CodeRule::Of> usual;
    for (const auto kind : {CodeRule::Of::material, CodeRule::Of::object, CodeRule::Of::group})
        if (!usual && known.tells(kind))
            usual = kind;
    SurfacesByName found;
    for (const auto& [part, extent] : parts) {
        // The strongest of its names that says something, or the one of the usual kind.
        std::optional<FirstSurface> best;
        for (const auto& [of, name] : namesOf(part)) {
            if (!known.isOfPart(of, name))
                continue;
            FirstSurface one = suggestion(of, name);
            if (!one.because.empty() && (!best || one.strength > best->strength))
                best = std::move(one);
        }
        if (!best && usual && *usual != CodeRule::Of::group)
            best =
                suggestion(*usual, *usual == CodeRule::Of::material ? part.material : part.object);
        else if (!best && usual && !part.groups.empty())
            best = suggestion(*usual, part.groups.back());
        if (!best) {
            best = suggestion(CodeRule::Of::material, "*");
            best->strength = weakest;
        }
        FirstSurface& surface = found.try_emplace({best->of, best->name}, *best).first->second;
        surface.polygons += extent.polygons;
        surface.area += extent.area;
    }
    for (const auto kind : {CodeRule::Of::object, CodeRule::Of::group})
        joinSeries(found, kind);
    std::vector<FirstSurface> surfaces;
    for (auto& [name, surface] : found)
        surfaces.push_back(std::move(surface));
    std::ranges::stable_sort(surfaces, std::ranges::greater(), &FirstSurface::area);
    return surfaces;
}

FirstSignature firstSignatureOf(const std::vector<FirstSurface>& surfaces,
                                const std::string& title) {
    FirstSignature first;
    first.database.title = title;
    first.database.notes = "Made from the names in the model: first choices, to be refined.";
    std::vector<int> materials;
    std::vector<FirstTemperature> temperatures;
    std::vector<int> strengths;
    for (const FirstSurface& surface : surfaces) {
        const auto& library = materialLibrary().materials;
        const auto found = library.find(surface.libraryMaterial);
        if (found == library.end())
            throw LogicError("no material " + std::to_string(surface.libraryMaterial) +
                             " in the library");
        const int material = numberOf(materials, surface.libraryMaterial),
                  temperature = numberOf(temperatures, surface.temperature);
        first.database.materials[material] = found->second;
        first.database.temperatures[temperature] = entryOf(surface.temperature);
        first.codes.rules.push_back({surface.of, surface.name, {temperature, material}});
        strengths.push_back(surface.strength);
    }
    std::vector<std::size_t> order(strengths.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return strengths[i]; });
    std::vector<CodeRule> rules;
    for (const std::size_t i : order)
        rules.push_back(std::move(first.codes.rules[i]));
    first.codes.rules = std::move(rules);
    return first;
}

} // namespace irsg
