#include "smatcore/tools/GasLayerText.h"

#include <utility>

#include "irsg/core/Errors.h"
#include "smatcore/tools/KeyNumbers.h"

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

GasLayer gasLayerFromText(const std::string& text, const std::string& name) {
    std::vector<NumberKey> keys;
    for (const Field& field : fields())
        keys.push_back({field.key, field.isNeeded});
    GasLayer layer;
    std::vector<irsg::Diagnostic> diagnostics =
        readKeyNumbers(text, name, keys, "T_K=700", [&](std::size_t number, double value) {
            fields()[number].of(layer) = value;
        });
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
