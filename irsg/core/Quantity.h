#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace irsg {

/// What the numbers of an axis, a column or an image channel mean. One table labels plots, CSV
/// headers and EXR attributes.
enum class Quantity {
    wavelength,
    wavenumber,
    time,
    range,
    angle,
    azimuth,
    elevation,
    yaw,
    altitude,
    power,
    mach,
    temperature,
    apparentTemperature,
    radiance,
    spectralRadiance,
    intensity,
    contrastIntensity,
    sourceIntensity, ///< with no air between and nothing behind
    spectralIntensity,
    spectralContrastIntensity,
    irradiance,
    totalIrradiance,
    spectralIrradiance,
    transmittance,
    pathRadiance,
    backgroundRadiance,
    solarIrradiance,
    upwardFlux,
    downwardFlux,
    scatteringOpticalDepth,
    emissivity,
    transmissivity,
    pixels,
    index,
    dimensionless
};

struct QuantityInfo {
    std::string_view key;        ///< "contrast_intensity": column and attribute name
    std::string_view label;      ///< "Contrast intensity": axis title
    std::string_view unit;       ///< "W sr-1" as in files; "" when dimensionless
    std::string_view prettyUnit; ///< "W·sr⁻¹" as on plots
};

const QuantityInfo& info(Quantity quantity);
/// The quantity whose info has this key; none of other keys.
std::optional<Quantity> quantityOfKey(std::string_view key);
/// "contrast_intensity [W sr-1]", or the bare key when dimensionless.
std::string columnHeader(Quantity quantity);
/// "Contrast intensity (W·sr⁻¹)".
std::string axisTitle(Quantity quantity);

} // namespace irsg
