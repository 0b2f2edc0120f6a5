#include "irsg/geometry/model/IndexNames.h"

#include <algorithm>
#include <cctype>

namespace irsg {
namespace {

/// A letter or two and a number, as OpenFlight's modellers name beads.
bool isIdentifier(const std::string& name) {
    const auto isLetter = [](unsigned char c) { return std::isalpha(c) != 0; };
    const auto isDigit = [](unsigned char c) { return std::isdigit(c) != 0; };
    const auto number = std::ranges::find_if_not(name, isLetter);
    return number - name.begin() <= 2 && std::all_of(number, name.end(), isDigit);
}

/// By index: polygons that have it.
using Counts = std::map<int, long>;

Counts countsOf(const std::map<IrCodes, long>& codes, int IrCodes::*which) {
    Counts counts;
    for (const auto& [code, polygons] : codes)
        counts[code.*which] += polygons;
    return counts;
}

std::map<int, std::string> namesBy(const NamesOfKinds& kinds, int IrCodes::*which) {
    // Every polygon stands once among the materials, under "" where it has none.
    Counts all;
    if (!kinds.empty())
        for (const auto& [name, faces] : kinds.front())
            for (const auto& [index, polygons] : countsOf(faces.codes, which))
                all[index] += polygons;

    std::map<int, std::string> names;
    std::map<int, double> best;
    for (const auto& kind : kinds) {
        for (const auto& [name, faces] : kind) {
            if (isIdentifier(name))
                continue;
            for (const auto& [index, both] : countsOf(faces.codes, which)) {
                const long either = faces.polygons + all[index] - both;
                const double share = static_cast<double>(both) / static_cast<double>(either);
                if (share > std::max(0.5, best[index])) {
                    best[index] = share;
                    names[index] = name;
                }
            }
        }
    }
    return names;
}

std::string nameIn(const std::map<int, std::string>& names, int index, const char* kind) {
    const auto found = names.find(index);
    return found != names.end() ? found->second : kind + std::to_string(index);
}

} // namespace

IndexNames::IndexNames(const NamesOfKinds& names)
    : temperatures_(namesBy(names, &IrCodes::temperature)),
      materials_(namesBy(names, &IrCodes::material)) {}

std::string IndexNames::ofTemperature(int index) const {
    return nameIn(temperatures_, index, "temperature ");
}

std::string IndexNames::ofMaterial(int index) const {
    return nameIn(materials_, index, "material ");
}

SignatureDatabase blackDatabase(const std::map<IrCodes, CodeUse>& codes, const IndexNames& names,
                                const std::string& title) {
    SignatureDatabase database;
    database.title = title;
    for (const auto& [pair, use] : codes) {
        TemperatureEntry& entry = database.temperatures[pair.temperature];
        entry.name = names.ofTemperature(pair.temperature);
        entry.terms = TemperatureTerms::ofAmbient();
        database.materials[pair.material].name = names.ofMaterial(pair.material);
    }
    return database;
}

} // namespace irsg
