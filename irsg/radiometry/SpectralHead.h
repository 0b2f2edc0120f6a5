#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace irsg {

/// What a spectral axis counts in.
enum class SpectralAxis { wavelength, nanometres, angstroms, wavenumber };

/// What the head of a column calls a spectral axis.
struct SpectralHead {
    std::optional<SpectralAxis> axis; ///< none: a wavelength without a unit
    bool isInAir = false;             ///< wavelengths in air, says the head
};

/// The axis that a head names, one rule for every reader: a unit alone (`um`, `nm`, `angstrom`,
/// `cm-1` and their other spellings: `µm`, `micron`, `nanometre`, `Å`, `1/cm`, `cm^-1`), or with
/// one of the words of columnWords() for wavelength or wavenumber before it in any of the forms
/// `wavelength [um]`, `Wellenlänge (µm)`, `wavelength_um`, `lambda/nm`, `longueur d'onde en nm`;
/// capitals do not count. A wavenumber without a unit is one in cm-1. No value for any other
/// head.
std::optional<SpectralHead> spectralHead(std::string_view head);

/// "'um', 'nm', 'angstrom', 'cm-1', 'wavelength [um]', ... or 'wavenumber [cm-1]'".
const std::string& spectralHeads();

/// The axis of values whose head names no unit: wavelengths from 0.1 to 100 are in um; with
/// `isWavelength`, those of 100 to 100000 in nm, which could be wavenumbers without. No value where
/// the numbers do not tell.
std::optional<SpectralAxis> axisOfValues(const std::vector<double>& values, bool isWavelength);

/// Of a value on an axis.
double wavelengthOn_um(SpectralAxis axis, double value);
/// "um", "nm", "angstrom" or "cm-1", as in columnUnits().
const char* axisUnit(SpectralAxis axis);

} // namespace irsg
