#include "smatcore/tools/GasEntries.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "irsg/core/Errors.h"
#include "irsg/core/ProgramVersion.h"
#include "irsg/radiometry/Units.h"
#include "smatcore/tools/GasLayerText.h"

namespace smat {

namespace {

std::string layerNotes(const std::vector<irsg::GasLayer>& layers) {
    std::string notes = "layers of hot gas, in order from the sensor:";
    for (const irsg::GasLayer& layer : layers)
        notes += " " + gasLayerText(layer) + ";";
    return notes + " " + irsg::programWithVersion();
}

} // namespace

void checkGasEntryPlace(const irsg::SignatureDatabase& database, const GasEntryPlace& place,
                        bool isSpectrum) {
    std::vector<irsg::Diagnostic> diagnostics;
    const auto check = [&](bool isTaken, const char* what, const std::string& value) {
        if (isTaken)
            diagnostics.push_back({what, "", value + ", which is taken", "one that is free"});
    };
    check(database.materials.contains(place.material), "material index",
          std::to_string(place.material));
    check(database.temperatures.contains(place.temperature), "temperature index",
          std::to_string(place.temperature));
    check(isSpectrum && database.spectra.contains(place.name), "name", place.name);
    if (!diagnostics.empty())
        throw irsg::InputError(std::move(diagnostics));
}

irsg::Material gasMaterial(const irsg::GasLayer& gas, const std::string& name,
                           const std::string& notes) {
    irsg::Material material;
    material.name = name;
    material.gasPressure_atm = gas.pressure_atm;
    material.gasCO2 = gas.fraction(irsg::HotGas::CO2);
    material.gasH2O = gas.fraction(irsg::HotGas::H2O);
    material.gasCO = gas.fraction(irsg::HotGas::CO);
    material.gasCH4 = gas.fraction(irsg::HotGas::CH4);
    material.gasO2 = gas.oxygenFraction;
    material.gasSoot_ppmv = gas.soot_ppmv;
    material.notes = notes;
    return material;
}

void addGasZone(irsg::SignatureDatabase& database, const irsg::GasLayer& layer,
                const GasEntryPlace& place) {
    checkGasEntryPlace(database, place, false);
    const std::string notes = "a layer of hot gas, " + gasLayerText(layer);
    database.materials.emplace(place.material, gasMaterial(layer, place.name, notes));
    irsg::TemperatureEntry temperature;
    temperature.name = place.name;
    temperature.terms.base_K = layer.temperature_K;
    temperature.notes = notes;
    database.temperatures.emplace(place.temperature, std::move(temperature));
}

GasSurface gasSurface(irsg::GasRequest request) {
    request.background_K.reset();
    const irsg::GasSpectrum gas = irsg::gasSpectrum(request);
    std::vector<double> wavelengths_um, radiance, transmittance;
    const auto add = [&](double wavelength_um, const irsg::GasSpectrum::Cell& cell) {
        if (!wavelengths_um.empty() && wavelength_um <= wavelengths_um.back())
            return;
        wavelengths_um.push_back(wavelength_um);
        radiance.push_back(cell.radiance_W_m2_sr_um);
        transmittance.push_back(std::clamp(cell.transmittance, 0.0, 1.0));
    };
    add(request.band.min_um, gas.cells.back());
    for (auto cell = gas.cells.rbegin(); cell != gas.cells.rend(); ++cell)
        add(irsg::wavelengthFromWavenumber_um(0.5 * (cell->lower_per_cm + cell->upper_per_cm)),
            *cell);
    add(request.band.max_um, gas.cells.front());

    GasSurface surface;
    const std::string notes = layerNotes(request.layers);
    surface.spectrum.importedUnit = "W m-2 sr-1 um-1";
    surface.spectrum.notes = notes;
    surface.spectrum.components = {
        {"gas",
         irsg::Spectrum(wavelengths_um, radiance, irsg::Spectrum::Outside::zero, "radiance")}};
    surface.material.transmissivity = irsg::Spectrum(wavelengths_um, transmittance);
    surface.material.emissivity =
        surface.material.transmissivity.mapped([](double tau) { return 1.0 - tau; });
    surface.material.notes = notes;
    surface.temperature.mode = irsg::EmissionMode::userSpectrum;
    // Not used in this mode, and read where a person switches to the other one.
    surface.temperature.terms.base_K =
        std::ranges::max(request.layers, {}, &irsg::GasLayer::temperature_K).temperature_K;
    surface.temperature.notes = notes;
    return surface;
}

void addGasSurface(irsg::SignatureDatabase& database, GasSurface surface,
                   const GasEntryPlace& place) {
    checkGasEntryPlace(database, place, true);
    surface.spectrum.name = surface.material.name = surface.temperature.name =
        surface.temperature.userSpectrum = place.name;
    database.spectra.emplace(place.name, std::move(surface.spectrum));
    database.materials.emplace(place.material, std::move(surface.material));
    database.temperatures.emplace(place.temperature, std::move(surface.temperature));
}

} // namespace smat
