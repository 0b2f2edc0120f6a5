#include "smatcore/tools/GasLayerText.h"

#include <utility>

#include "irsg/core/Errors.h"
#include "smatcore/tools/KeyNumbers.h"

namespace smat {

namespace {

using irsg::GasLayer;
using irsg::HotGas;

} // namespace

const std::vector<GasLayerField>& gasLayerFields() {
    static const std::vector<GasLayerField> all = {
        {.key = "T_K",
         .label = "Temperature",
         .unit = "K",
         .help = "Uniform in the layer",
         .step = 10.0,
         .isNeeded = true,
         .of = [](GasLayer& l) -> double& { return l.temperature_K; }},
        {.key = "p_atm",
         .label = "Pressure",
         .unit = "atm",
         .help = "Total pressure of all gases of the layer",
         .step = 0.1,
         .isNeeded = true,
         .of = [](GasLayer& l) -> double& { return l.pressure_atm; }},
        {.key = "length_m",
         .label = "Length",
         .unit = "m",
         .help = "Along the line of sight",
         .step = 0.1,
         .isNeeded = true,
         .of = [](GasLayer& l) -> double& { return l.length_m; }},
        {.key = "CO2",
         .label = "CO2",
         .unit = "",
         .help = "Mole fraction of carbon dioxide; the rest of the gas is nitrogen",
         .step = 0.01,
         .of = [](GasLayer& l) -> double& { return l.fraction(HotGas::CO2); }},
        {.key = "H2O",
         .label = "H2O",
         .unit = "",
         .help = "Mole fraction of water vapour; the rest of the gas is nitrogen",
         .step = 0.01,
         .of = [](GasLayer& l) -> double& { return l.fraction(HotGas::H2O); }},
        {.key = "CO",
         .label = "CO",
         .unit = "",
         .help = "Mole fraction of carbon monoxide; the rest of the gas is nitrogen",
         .step = 0.01,
         .of = [](GasLayer& l) -> double& { return l.fraction(HotGas::CO); }},
        {.key = "CH4",
         .label = "CH4",
         .unit = "",
         .help = "Mole fraction of methane; the rest of the gas is nitrogen",
         .step = 0.01,
         .of = [](GasLayer& l) -> double& { return l.fraction(HotGas::CH4); }},
        {.key = "O2",
         .label = "O2",
         .unit = "",
         .help = "Mole fraction of oxygen, which emits nothing but broadens lines",
         .step = 0.01,
         .of = [](GasLayer& l) -> double& { return l.oxygenFraction; }},
        {.key = "soot_ppmv",
         .label = "Soot",
         .unit = "ppmv",
         .help = "Volume fraction of soot, times 1e6",
         .step = 0.01,
         .of = [](GasLayer& l) -> double& { return l.soot_ppmv; }}};
    return all;
}

GasLayer gasLayerFromText(const std::string& text, const std::string& name) {
    std::vector<NumberKey> keys;
    for (const GasLayerField& field : gasLayerFields())
        keys.push_back({field.key, field.isNeeded});
    GasLayer layer;
    std::vector<irsg::Diagnostic> diagnostics =
        readKeyNumbers(text, name, keys, "T_K=700", [&](std::size_t number, double value) {
            gasLayerFields()[number].of(layer) = value;
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
    for (const GasLayerField& field : gasLayerFields())
        if (field.isNeeded || field.of(copy) != 0.0)
            text += (text.empty() ? "" : ",") + std::string(field.key) + "=" +
                    irsg::numberText(field.of(copy));
    return text;
}

} // namespace smat
