#pragma once

#include <string>

#include "irsg/gas/GasSpectrum.h"
#include "irsg/signature/SignatureDatabase.h"

namespace smat {

/// The material of a gas: meshes of it are zones of this gas (irsg::Material::isGas).
irsg::Material gasMaterial(const irsg::GasLayer& gas, const std::string& name,
                           const std::string& notes);

/// Under which name and indices entries of a gas go to a database.
struct GasEntryPlace {
    std::string name;
    int material = 0, temperature = 0;
};

/// Throws InputError naming each index that is taken; with `isSpectrum` the name, too, where a
/// spectrum has it.
void checkGasEntryPlace(const irsg::SignatureDatabase& database, const GasEntryPlace& place,
                        bool isSpectrum);

/// Adds a layer as a gas zone: its material, and a temperature entry of its temperature; its length
/// is that of the mesh. Throws as checkGasEntryPlace().
void addGasZone(irsg::SignatureDatabase& database, const irsg::GasLayer& layer,
                const GasEntryPlace& place);

/// What layers look like as one surface.
struct GasSurface {
    irsg::UserSpectrum spectrum; ///< of one component, W m-2 sr-1 um-1
    /// 1 less transmissivity, and transmissivity: it reflects nothing.
    irsg::Material material;
    irsg::TemperatureEntry temperature; ///< names the spectrum
};

/// Layers alone, without what is behind them and without an atmosphere. Nodes are the middles of
/// the cells and both ends of the band, outside of which the surface emits nothing. Throws
/// InputError for what irsg::gasSpectrum refuses.
GasSurface gasSurface(irsg::GasRequest request);

/// Adds it under this name and these indices. Throws as checkGasEntryPlace().
void addGasSurface(irsg::SignatureDatabase& database, GasSurface surface,
                   const GasEntryPlace& place);

} // namespace smat
