#include "smatcore/tools/GasLayerText.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <sstream>

#include "irsg/core/CsvTable.h"
#include "irsg/core/Errors.h"
#include "smatcore/support/NearestNames.h"

namespace smat {

namespace {

using irsg::GasLayer;
using irsg::HotGas;

/// A key with the number of the layer that it names.
struct Field {
    const char* key;
    bool isNeeded;
    double& (*of)(GasLayer&);
};

const std::vector<Field>& fields() {
    static const std::vector<Field> all = {
        {"T_K", true, [](GasLayer& l) -> double& { return l.temperature_K; }},
        {"p_atm", true, [](GasLayer& l) -> double& { return l.pressure_atm; }},
        {"length_m", true, [](GasLayer& l) -> double& { return l.length_m; }},
        {"CO2", false, [](GasLayer& l) -> double& { return l.fraction(HotGas::CO2); }},
        {"H2O", false, [](GasLayer& l) -> double& { return l.fraction(HotGas::H2O); }},
        {"CO", false, [](GasLayer& l) -> double& { return l.fraction(HotGas::CO); }},
        {"CH4", false, [](GasLayer& l) -> double& { return l.fraction(HotGas::CH4); }},
        {"O2", false, [](GasLayer& l) -> double& { return l.oxygenFraction; }},
        {"soot_ppmv", false, [](GasLayer& l) -> double& { return l.soot_ppmv; }}};
    return all;
}

} // namespace

const std::vector<std::string>& gasLayerKeys() {
    static const std::vector<std::string> keys = [] {
        std::vector<std::string> all;
        std::ranges::transform(fields(), std::back_inserter(all), &Field::key);
        return all;
    }();
    return keys;
}

GasLayer gasLayerFromText(const std::string& text, const std::string& name) {
    GasLayer layer;
    std::vector<irsg::Diagnostic> diagnostics;
    std::set<std::string> given;
    std::istringstream entries(text);
    for (std::string entry; std::getline(entries, entry, ',');) {
        const std::size_t sign = entry.find('=');
        const std::string key(irsg::trimmed(entry.substr(0, sign)));
        const auto field = std::ranges::find(fields(), key, &Field::key);
        if (sign == std::string::npos)
            diagnostics.push_back({name, "", "'" + entry + "'", "KEY=NUMBER, as T_K=700"});
        else if (field == fields().end())
            diagnostics.push_back({name, "", key, oneOf(gasLayerKeys(), key)});
        else if (!given.insert(key).second)
            diagnostics.push_back({name, key, "it twice", "each key once"});
        else if (const auto number = irsg::parseNumber(irsg::trimmed(entry.substr(sign + 1))))
            field->of(layer) = *number;
        else
            diagnostics.push_back({name, key, "'" + entry.substr(sign + 1) + "'", "a number"});
    }
    for (const Field& field : fields())
        if (field.isNeeded && !given.contains(field.key))
            diagnostics.push_back({name, field.key, "nothing", "a number"});
    if (diagnostics.empty())
        diagnostics = irsg::gasLayerDiagnostics(layer, name);
    if (!diagnostics.empty())
        throw irsg::InputError(std::move(diagnostics));
    return layer;
}

std::string gasLayerText(const GasLayer& layer) {
    GasLayer copy = layer;
    std::string text;
    for (const Field& field : fields())
        if (field.isNeeded || field.of(copy) != 0.0)
            text += (text.empty() ? "" : ",") + std::string(field.key) + "=" +
                    irsg::numberText(field.of(copy));
    return text;
}

} // namespace smat
