#include "irsg/signature/EntryFields.h"

#include <algorithm>
#include <array>
#include <utility>

#include "irsg/gas/GasLayer.h"
#include "irsg/radiometry/Units.h"
#include "irsg/signature/SurfaceModels.h"

namespace irsg {

namespace {

/// Speed of sound in air of 288.15 K, m/s.
constexpr double soundSpeed_m_s = 340.3;
/// The highest Mach number and altitude axis in km that are taken for what they are.
constexpr double highestMach = 30.0;
constexpr double highestAltitude_km = 30.0;
/// cos^N with a higher N sends everything along the normal.
constexpr double steepestN = 100.0;

using Terms = TemperatureTerms;
constexpr double none = NumberRules::none;

constexpr NumberRules opticalConstant{
    .expected = "a number of at least 0", .least = 0.0, .step = 0.1};
constexpr NumberRules reflectivity{
    .expected = "a number of at least 0", .least = 0.0, .step = 0.01, .isFraction = true};

constexpr NumberRules moleFraction{.expected = "a mole fraction from 0 to 1",
                                   .least = 0.0,
                                   .most = 1.0,
                                   .step = 0.01,
                                   .isFraction = true};

template <typename Entry>
bool always(const Entry& /*entry*/) {
    return true;
}

const auto termRows = std::to_array<EntryField<Terms>>({
    {.key = "base_K",
     .column = "base_K",
     .member = &Terms::base_K,
     .label = "T0",
     .word = "T0",
     .unit = "K",
     .help = "T0: what does not depend on the air",
     .isRequired = always<Terms>},
    {.key = "ambientFactor",
     .column = "ambient_factor",
     .member = &Terms::ambientFactor,
     .label = "a",
     .word = "a",
     .help = "a: the part of the ambient temperature that counts",
     .number = {.likely = "a share of the air's temperature of at least 0",
                .likelyLeast = 0.0,
                .step = 0.05},
     .isRequired = always<Terms>},
    {.key = "recoveryFactor",
     .column = "recovery_factor",
     .member = &Terms::recoveryFactor,
     .label = "r",
     .word = "r",
     .help = "r: recovery factor of the heating by the air that passes, 0.85 laminar, 0.89 "
             "turbulent, 1 on a stagnation line",
     .number = {.likely = "a recovery factor from 0 to 1 (0.85 laminar, 0.89 turbulent)",
                .likelyLeast = 0.0,
                .likelyMost = 1.0,
                .mostPercent = 100.0,
                .step = 0.01}},
    {.key = "ambientOffset_K",
     .column = "ambient_offset_K",
     .member = &Terms::ambientOffset_K,
     .label = "ΔT",
     .word = "delta T",
     .unit = "K",
     .help = "ΔT: above or below the ambient temperature, times a"},
    {.key = "time_s",
     .column = "time_s",
     .member = &Terms::time,
     .label = "f(t)",
     .word = "f(time)",
     .unit = "K",
     .help = "What time adds",
     .table = {.axis = "time",
               .unit = "s",
               .value = "rise",
               .position = [](const EntityState& at) { return at.time_s; },
               .mayLoop = true}},
    {.key = "power",
     .column = "power",
     .member = &Terms::power,
     .label = "f(power)",
     .word = "f(power)",
     .unit = "K",
     .help = "What the engine's power adds",
     .table = {.axis = "power setting",
               .value = "rise",
               .position = [](const EntityState& at) { return at.power; },
               .step = 0.1}},
    {.key = "altitude_m",
     .column = "altitude_m",
     .member = &Terms::altitude,
     .label = "f(altitude)",
     .word = "f(altitude)",
     .unit = "K",
     .help = "What altitude adds",
     .table = {.axis = "altitude",
               .unit = "m",
               .value = "rise",
               .position = [](const EntityState& at) { return at.altitude_m; },
               .suspicion = {.low = 1e-3,
                             .high = highestAltitude_km,
                             .expected = "an altitude in m",
                             .remedy = "km taken for m? Multiply the axis by 1000",
                             .factor = 1e3},
               .step = 1000.0}},
    {.key = "mach",
     .column = "mach",
     .member = &Terms::mach,
     .label = "f(M)",
     .word = "f(Mach)",
     .unit = "K",
     .help = "What speed adds",
     .table = {.axis = "Mach number",
               .value = "rise",
               .position = [](const EntityState& at) { return at.mach; },
               .suspicion = {.low = highestMach,
                             .high = none,
                             .expected = "a Mach number of at most 30",
                             .remedy = "m/s taken for Mach? Divide the axis by 340.3",
                             .factor = 1.0 / soundSpeed_m_s},
               .step = 0.1}},
    {.key = "ambient_K",
     .column = "ambient_K",
     .member = &Terms::ambient,
     .label = "f(T_amb)",
     .word = "f(ambient)",
     .unit = "K",
     .help = "What the temperature of the air adds where a · T_amb is not enough: parts that are "
             "heated, cooled or measured on several days",
     .table = {.axis = "temperature of the air",
               .unit = "K",
               .value = "rise",
               .position = [](const EntityState& at) { return at.ambient_K; },
               .suspicion = {.low = -80.0,
                             .high = 100.0,
                             .expected = "temperatures of air in K",
                             .remedy = "degrees Celsius taken for K? Add 273.15 to the axis",
                             .factor = 1.0,
                             .offset = 273.15},
               .step = 10.0},
     .since = 2},
});

const auto factorRows = std::to_array<EntryField<ComponentFactor>>({
    {.key = "component",
     .column = "component",
     .member = &ComponentFactor::component,
     .isRequired = always<ComponentFactor>},
    {.key = "constant",
     .column = "constant",
     .member = &ComponentFactor::constant,
     .label = "Constant",
     .word = "constant factor",
     .help = "Factor of this component; a table over time stands in its place",
     .number = {.expected = "a factor of at least 0", .least = 0.0, .step = 0.1}},
    {.key = "time_s",
     .column = "time_s",
     .member = &ComponentFactor::time,
     .label = "over time",
     .word = "time factor",
     .help = "Factor over time, in place of the constant",
     .table = {.axis = "time",
               .unit = "s",
               .value = "factor",
               .position = [](const EntityState& at) { return at.time_s; },
               .mayLoop = true,
               .leastValue = 0.0,
               .firstValue = 1.0}},
    {.key = "angle_deg",
     .column = "angle_deg",
     .member = &ComponentFactor::angle,
     .label = "over angle",
     .word = "angle factor",
     .help = "Factor over the angle from the nose, times the constant or that over time",
     .table = {.axis = "angle from the nose",
               .unit = "deg",
               .value = "factor",
               .position = [](const EntityState& at) { return degrees(at.aspectAngle_rad); },
               .leastValue = 0.0,
               .leastPosition = 0.0,
               .mostPosition = 180.0,
               .suspicion = {.low = pi / 2.0 - 0.01,
                             .high = pi + 0.01,
                             .expected = "angles in degrees",
                             .remedy = "radians taken for degrees? Multiply the axis by 57.29578",
                             .factor = degrees(1.0)},
               .step = 30.0,
               .firstValue = 1.0}},
    {.key = "selection",
     .column = "selection",
     .member = &ComponentFactor::selection,
     .label = "Selection",
     .word = "selection",
     .help = "What counts: the tables, or the constant alone. What does not is kept",
     .since = 5},
});

const auto temperatureRows = std::to_array<EntryField<TemperatureEntry>>({
    {.key = "name",
     .column = "name",
     .member = &TemperatureEntry::name,
     .label = "Name",
     .isRequired = always<TemperatureEntry>},
    {.key = "mode",
     .column = "mode",
     .member = &TemperatureEntry::mode,
     .label = "Mode",
     .isRequired = always<TemperatureEntry>},
    {.key = "terms",
     .column = "terms",
     .member = &TemperatureEntry::terms,
     .isRequired =
         [](const TemperatureEntry& entry) { return entry.mode == EmissionMode::temperature; }},
    {.key = "factors", .column = "factors", .member = &TemperatureEntry::factors},
    {.key = "userSpectrum",
     .column = "user_spectrum",
     .member = &TemperatureEntry::userSpectrum,
     .label = "Spectrum"},
    {.key = "notes", .column = "notes", .member = &TemperatureEntry::notes, .label = "Notes"},
});

const auto materialRows = std::to_array<EntryField<Material>>({
    {.key = "name",
     .column = "name",
     .member = &Material::name,
     .label = "Name",
     .isRequired = always<Material>},
    {.key = "emissivity",
     .column = "emissivity",
     .member = &Material::emissivity,
     .label = "Emissivity",
     .word = "emissivity",
     .isRequired = always<Material>},
    {.key = "transmissivity",
     .column = "transmissivity",
     .member = &Material::transmissivity,
     .label = "Transmissivity",
     .word = "transmissivity"},
    {.key = "nAngleFactor",
     .column = "n_angle_factor",
     .member = &Material::nAngleFactor,
     .label = "N",
     .word = "N angle factor",
     .help = "N of cos^N: 0 emits alike in all directions, larger values along the normal. For "
             "temperatures and for user-defined spectra",
     .number = {.expected = "a number of at least 0",
                .least = 0.0,
                .likely = "N of at most 100: 0 is a diffuse emitter, 3 already a beam",
                .likelyMost = steepestN,
                .step = 0.25}},
    {.key = "notes", .column = "notes", .member = &Material::notes, .label = "Notes"},
    {.key = "surfaceModel",
     .column = "surface_model",
     .member = &Material::surfaceModel,
     .label = "Surface model",
     .word = "surface model",
     .help = "How it reflects over directions: Lambertian, facets whose "
             "slopes follow GGX or Beckmann, the models of Sandford and "
             "Robertson or of Shell, or as a table was measured. With facets, "
             "emissivity is that along the normal",
     .words = surfaceModelNames,
     .since = 4},
    {.key = "roughness",
     .column = "roughness",
     .member = &Material::roughness,
     .label = "Roughness",
     .word = "roughness",
     .help = "Of the facets: the root of twice their mean square slope. 0.02 is a polished "
             "sheet, 0.1 to 0.3 gloss or metal as it comes, 0.5 and more a matt coat",
     .page = "surface",
     .number = {.expected = "a number from 0.001 to 1",
                .least = leastRoughness,
                .most = 1.0,
                .step = 0.05},
     .since = 4},
    {.key = "refractiveIndex",
     .column = "refractive_index",
     .member = &Material::refractiveIndex,
     .label = "Refractive index n",
     .word = "refractive index",
     .help = "n of the bulk, in place of the emissivity; 0: not known",
     .page = "surface",
     .csv = "n",
     .number = opticalConstant,
     .since = 4},
    {.key = "extinction",
     .column = "extinction",
     .member = &Material::extinction,
     .label = "Extinction k",
     .word = "extinction",
     .help = "k of the bulk, beside its refractive index",
     .page = "surface",
     .csv = "k",
     .number = opticalConstant,
     .since = 4},
    {.key = "diffuseReflectivity",
     .column = "diffuse_reflectivity",
     .member = &Material::diffuseReflectivity,
     .label = "Diffuse reflectivity",
     .word = "diffuse reflectivity",
     .help = "The diffuse part of Sandford and Robertson's model and of "
             "Shell's, over the hemisphere",
     .page = "surface",
     .number = reflectivity,
     .since = 6},
    {.key = "volumeReflectivity",
     .column = "volume_reflectivity",
     .member = &Material::volumeReflectivity,
     .label = "Volume reflectivity",
     .word = "volume reflectivity",
     .help = "The part of Shell's model that comes from below the surface, pi "
             "times that per steradian",
     .page = "surface",
     .number = reflectivity,
     .since = 6},
    {.key = "grazingFactor",
     .column = "grazing_factor",
     .member = &Material::grazingFactor,
     .label = "b",
     .word = "b",
     .help = "b of Sandford and Robertson's model: how soon emissivity falls towards grazing "
             "angles, from 0 (not at all) to 1",
     .page = "surface",
     .number = {.expected = "a number from 0 to 1", .least = 0.0, .most = 1.0, .step = 0.05},
     .since = 6},
    {.key = "shadowTau_deg",
     .column = "shadow_tau_deg",
     .member = &Material::shadowTau_deg,
     .label = "τ of shadowing",
     .word = "tau",
     .unit = "deg",
     .help = "Of Maxwell and Beard's shadowing in Shell's model: the smaller, the sooner "
             "facets are hidden from light that comes and goes obliquely",
     .page = "surface",
     .number = {.expected = "an angle from 0.1 to 1000 deg", .least = 0.1, .most = 1000.0},
     .since = 6},
    {.key = "shadowOmega_deg",
     .column = "shadow_omega_deg",
     .member = &Material::shadowOmega_deg,
     .label = "Ω of shadowing",
     .word = "omega",
     .unit = "deg",
     .help = "Of Maxwell and Beard's shadowing in Shell's model: the smaller, the more facets "
             "that are tilted are hidden",
     .page = "surface",
     .number = {.expected = "an angle from 0.1 to 1000 deg", .least = 0.1, .most = 1000.0},
     .since = 6},
    {.key = "reflectanceTable",
     .column = "reflectance_table",
     .member = &Material::reflectanceTable,
     .label = "Table",
     .word = "table of reflectance",
     .help = "Measured reflectance over directions",
     .page = "surface",
     .since = 6},
    {.key = "gasPressure_atm",
     .column = "gas_pressure_atm",
     .member = &Material::gasPressure_atm,
     .label = "Gas pressure",
     .word = "gas pressure",
     .unit = "atm",
     .help = "Above 0, closed meshes of this material are filled with a gas of this total pressure "
             "and of the temperature of their faces; emissivity, transmissivity and surface model "
             "then say nothing",
     .page = "gas",
     .number = {.expected = "0, or a pressure up to 10 atm",
                .least = 0.0,
                .most = GasLayerLimits::densest_atm,
                .step = 0.1},
     .since = 7},
    {.key = "gasCO2",
     .column = "gas_co2",
     .member = &Material::gasCO2,
     .label = "CO2",
     .word = "CO2",
     .help = "Mole fraction of carbon dioxide; the rest of the gas is nitrogen",
     .page = "gas",
     .number = moleFraction,
     .since = 7},
    {.key = "gasH2O",
     .column = "gas_h2o",
     .member = &Material::gasH2O,
     .label = "H2O",
     .word = "H2O",
     .help = "Mole fraction of water vapour; the rest of the gas is nitrogen",
     .page = "gas",
     .number = moleFraction,
     .since = 7},
    {.key = "gasCO",
     .column = "gas_co",
     .member = &Material::gasCO,
     .label = "CO",
     .word = "CO",
     .help = "Mole fraction of carbon monoxide; the rest of the gas is nitrogen",
     .page = "gas",
     .number = moleFraction,
     .since = 7},
    {.key = "gasCH4",
     .column = "gas_ch4",
     .member = &Material::gasCH4,
     .label = "CH4",
     .word = "CH4",
     .help = "Mole fraction of methane; the rest of the gas is nitrogen",
     .page = "gas",
     .number = moleFraction,
     .since = 7},
    {.key = "gasO2",
     .column = "gas_o2",
     .member = &Material::gasO2,
     .label = "O2",
     .word = "O2",
     .help = "Mole fraction of oxygen, which emits nothing but broadens lines; the rest of the gas "
             "is nitrogen",
     .page = "gas",
     .number = moleFraction,
     .since = 7},
    {.key = "gasSoot_ppmv",
     .column = "gas_soot_ppmv",
     .member = &Material::gasSoot_ppmv,
     .label = "Soot",
     .word = "soot",
     .unit = "ppmv",
     .help = "Volume fraction of soot in the gas, times 1e6",
     .page = "gas",
     .number = {.expected = "a number from 0 to 1000",
                .least = 0.0,
                .most = GasLayerLimits::mostSoot_ppmv,
                .step = 0.01},
     .since = 7},
});

const auto spectrumRows = std::to_array<EntryField<UserSpectrum>>({
    {.key = "referenceDistance_m",
     .column = "reference_distance_m",
     .member = &UserSpectrum::referenceDistance_m,
     .label = "Reference distance",
     .word = "reference distance",
     .unit = "m",
     .help = "The air between the source and this distance is inside the measurement already: a "
             "nearer sensor sees it unchanged, a farther one through the rest of the air",
     .number = {.expected = "a distance of at least 0 m", .least = 0.0}},
    {.key = "calibrationFactor",
     .column = "calibration_factor",
     .member = &UserSpectrum::calibrationFactor,
     .label = "Calibration",
     .word = "calibration factor",
     .help = "Multiplies every component wherever this spectrum is used: what a later calibration "
             "found of the measurement, whose curves stay as they were imported",
     .number = {.expected = "a factor of at least 0",
                .least = 0.0,
                .likely = "a correction from 0.1 to 10",
                .likelyLeast = 0.1,
                .likelyMost = 10.0,
                .step = 0.01},
     .since = 3},
    {.key = "importedUnit", .column = "imported_unit", .member = &UserSpectrum::importedUnit},
    {.key = "notes", .column = "notes", .member = &UserSpectrum::notes, .label = "Notes"},
});

constexpr NamedChoice<EmissionMode> modes[] = {{EmissionMode::temperature, "temperature"},
                                               {EmissionMode::userSpectrum, "userSpectrum"}};
constexpr NamedChoice<FactorSelection> selections[] = {{FactorSelection::table, "table"},
                                                       {FactorSelection::constant, "constant"}};

template <typename Entry>
int versionOf(const Entry& entry, std::span<const EntryField<Entry>> fields) {
    int version = 1;
    for (const EntryField<Entry>& field : fields)
        if (field.saysSomething(entry))
            version = std::max(version, field.since);
    return version;
}

} // namespace

std::span<const EntryField<TemperatureTerms>> termFields() {
    return termRows;
}

std::span<const EntryField<ComponentFactor>> geometryBuffers() {
    return factorRows;
}

std::span<const EntryField<TemperatureEntry>> temperatureFields() {
    return temperatureRows;
}

std::span<const EntryField<Material>> materialFields() {
    return materialRows;
}

std::span<const EntryField<UserSpectrum>> spectrumFields() {
    return spectrumRows;
}

int formatVersionOf(const SignatureDatabase& database) {
    int version = 1;
    const auto count = [&](const auto& entry, auto fields) {
        version = std::max(version, versionOf(entry, fields));
    };
    for (const auto& [index, entry] : database.temperatures) {
        count(entry, temperatureFields());
        count(entry.terms, termFields());
        for (const ComponentFactor& factor : entry.factors)
            count(factor, geometryBuffers());
    }
    for (const auto& [index, material] : database.materials)
        count(material, materialFields());
    for (const auto& [name, spectrum] : database.spectra)
        count(spectrum, spectrumFields());
    return version;
}

int newestFormatVersion() {
    int newest = 1;
    const auto count = [&](auto fields) {
        for (const auto& field : fields)
            newest = std::max(newest, field.since);
    };
    count(termFields());
    count(geometryBuffers());
    count(temperatureFields());
    count(materialFields());
    count(spectrumFields());
    return newest;
}

std::span<const NamedChoice<EmissionMode>> choicesOf(EmissionMode /*any*/) {
    return modes;
}

std::span<const NamedChoice<FactorSelection>> choicesOf(FactorSelection /*any*/) {
    return selections;
}

} // namespace irsg
