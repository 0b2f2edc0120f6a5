#include "irsg/geometry/model/FirstSignature.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "irsg/core/Errors.h"
#include "irsg/core/Wording.h"
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

/// The first that a name holds counts: what is hot before what is painted, what it is made of
/// before its colour.
constexpr Word words[] = {
    {"afterburner", "nickel alloy, oxidised (exhaust parts)", warmer(700.0)},
    {"exhaust", "nickel alloy, oxidised (exhaust parts)", warmer(400.0)},
    {"nozzle", "nickel alloy, oxidised (exhaust parts)", warmer(400.0)},
    {"tailpipe", "nickel alloy, oxidised (exhaust parts)", warmer(400.0)},
    {"turbine", "nickel alloy, oxidised (exhaust parts)", warmer(400.0)},
    {"muffler", "rusted steel", warmer(250.0)},
    {"funnel", "grey aircraft paint, matt", warmer(60.0)},
    {"stack", "grey aircraft paint, matt", warmer(60.0)},
    {"brake", "rusted steel", warmer(80.0)},
    {"engine", "weathered bare aluminium", warmer(40.0)},
    {"canopy", "acrylic canopy, 8 mm", recovery},
    {"cockpit", "acrylic canopy, 8 mm", recovery},
    {"plexi", "acrylic canopy, 8 mm", recovery},
    {"acryl", "acrylic canopy, 8 mm", recovery},
    {"glass", "window glass, 4 mm", air},
    {"glas", "window glass, 4 mm", air},
    {"window", "window glass, 4 mm", air},
    {"windsh", "window glass, 4 mm", air},
    {"windscreen", "window glass, 4 mm", air},
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

FirstSurface suggestion(const std::string& name) {
    FirstSurface surface;
    surface.name = name;
    surface.libraryMaterial = libraryIndex(otherwise);
    surface.temperature = recovery;
    const std::string lower = lowerCase(name);
    for (const Word& word : words)
        if (lower.find(word.part) != lower.npos) {
            surface.libraryMaterial = libraryIndex(word.material);
            surface.temperature = word.temperature;
            surface.because = word.part;
            break;
        }
    return surface;
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

std::vector<FirstSurface> suggestedSurfaces(const NamesOfKinds& names) {
    // Names of materials say most; of objects and groups only as many as a person looks through.
    constexpr std::size_t most = 100;
    const auto of = [&](CodeRule::Of kind) -> const auto& {
        return names[static_cast<std::size_t>(kind)];
    };
    const auto tells = [&](CodeRule::Of kind) {
        return !of(kind).empty() && (of(kind).size() > 1 || !of(kind).contains("")) &&
               (kind == CodeRule::Of::material || of(kind).size() <= most);
    };
    std::vector<FirstSurface> surfaces;
    for (const auto kind : {CodeRule::Of::material, CodeRule::Of::object, CodeRule::Of::group}) {
        if (!tells(kind))
            continue;
        for (const auto& [name, faces] : of(kind)) {
            FirstSurface surface = suggestion(name);
            surface.of = kind;
            surface.polygons = faces.polygons;
            surface.area = faces.area;
            surfaces.push_back(std::move(surface));
        }
        break;
    }
    if (surfaces.empty()) {
        FirstSurface all = suggestion("*");
        for (const auto& [name, faces] : of(CodeRule::Of::material)) {
            all.polygons += faces.polygons;
            all.area += faces.area;
        }
        surfaces.push_back(std::move(all));
    }
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
    }
    return first;
}

} // namespace irsg
