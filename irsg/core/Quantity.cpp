#include "irsg/core/Quantity.h"

#include <array>

#include "irsg/core/Errors.h"

namespace irsg {

namespace {

struct Entry {
    Quantity quantity;
    QuantityInfo info;
};

constexpr std::array entries = {
    Entry{Quantity::wavelength, {"wavelength", "Wavelength", "um", "µm"}},
    Entry{Quantity::wavenumber, {"wavenumber", "Wavenumber", "cm-1", "cm⁻¹"}},
    Entry{Quantity::time, {"time", "Time", "s", "s"}},
    Entry{Quantity::range, {"range", "Range", "m", "m"}},
    Entry{Quantity::angle, {"angle", "Angle", "deg", "°"}},
    Entry{Quantity::azimuth, {"azimuth", "Azimuth", "deg", "°"}},
    Entry{Quantity::elevation, {"elevation", "Elevation", "deg", "°"}},
    Entry{Quantity::yaw, {"yaw", "Yaw", "deg", "°"}},
    Entry{Quantity::altitude, {"altitude", "Altitude", "m", "m"}},
    Entry{Quantity::power, {"power", "Engine power", "", ""}},
    Entry{Quantity::mach, {"mach", "Mach number", "", ""}},
    Entry{Quantity::temperature, {"temperature", "Temperature", "K", "K"}},
    Entry{Quantity::apparentTemperature,
          {"apparent_temperature", "Apparent temperature", "K", "K"}},
    Entry{Quantity::radiance, {"radiance", "Radiance", "W m-2 sr-1", "W·m⁻²·sr⁻¹"}},
    Entry{Quantity::spectralRadiance,
          {"spectral_radiance", "Spectral radiance", "W m-2 sr-1 um-1", "W·m⁻²·sr⁻¹·µm⁻¹"}},
    Entry{Quantity::intensity, {"intensity", "Intensity", "W sr-1", "W·sr⁻¹"}},
    Entry{Quantity::contrastIntensity,
          {"contrast_intensity", "Contrast intensity", "W sr-1", "W·sr⁻¹"}},
    Entry{Quantity::sourceIntensity, {"source_intensity", "Source intensity", "W sr-1", "W·sr⁻¹"}},
    Entry{Quantity::spectralIntensity,
          {"spectral_intensity", "Spectral intensity", "W sr-1 um-1", "W·sr⁻¹·µm⁻¹"}},
    Entry{Quantity::spectralContrastIntensity,
          {"spectral_contrast_intensity", "Spectral contrast intensity", "W sr-1 um-1",
           "W·sr⁻¹·µm⁻¹"}},
    Entry{Quantity::irradiance, {"irradiance", "Irradiance", "W m-2", "W·m⁻²"}},
    Entry{Quantity::totalIrradiance, {"irradiance_total", "Total irradiance", "W m-2", "W·m⁻²"}},
    Entry{Quantity::spectralIrradiance,
          {"spectral_irradiance", "Spectral irradiance", "W m-2 um-1", "W·m⁻²·µm⁻¹"}},
    Entry{Quantity::transmittance, {"transmittance", "Transmittance", "", ""}},
    Entry{Quantity::pathRadiance,
          {"path_radiance", "Path radiance", "W m-2 sr-1 um-1", "W·m⁻²·sr⁻¹·µm⁻¹"}},
    Entry{Quantity::backgroundRadiance,
          {"background_radiance", "Background radiance", "W m-2 sr-1 um-1", "W·m⁻²·sr⁻¹·µm⁻¹"}},
    Entry{Quantity::solarIrradiance,
          {"solar_irradiance", "Solar irradiance", "W m-2 um-1", "W·m⁻²·µm⁻¹"}},
    Entry{Quantity::upwardFlux, {"up_flux", "Upward flux", "W m-2 um-1", "W·m⁻²·µm⁻¹"}},
    Entry{Quantity::downwardFlux, {"down_flux", "Downward flux", "W m-2 um-1", "W·m⁻²·µm⁻¹"}},
    Entry{Quantity::scatteringOpticalDepth,
          {"scattering_optical_depth", "Scattering optical depth", "", ""}},
    Entry{Quantity::emissivity, {"emissivity", "Emissivity", "", ""}},
    Entry{Quantity::transmissivity, {"transmissivity", "Transmissivity", "", ""}},
    Entry{Quantity::pixels, {"pixels", "Pixels", "", ""}},
    Entry{Quantity::index, {"index", "Index", "", ""}},
    Entry{Quantity::dimensionless, {"value", "Value", "", ""}},
};

// The table is indexed by the enumeration, so that a quantity without a row does not compile.
constexpr bool isComplete() {
    for (std::size_t i = 0; i < entries.size(); ++i)
        if (static_cast<std::size_t>(entries[i].quantity) != i)
            return false;
    return entries.size() == static_cast<std::size_t>(Quantity::dimensionless) + 1;
}
static_assert(isComplete());

} // namespace

const QuantityInfo& info(Quantity quantity) {
    const auto index = static_cast<std::size_t>(quantity);
    if (index >= entries.size())
        throw LogicError("unknown quantity");
    return entries[index].info;
}

std::string columnHeader(Quantity quantity) {
    const QuantityInfo& entry = info(quantity);
    const std::string key(entry.key);
    return entry.unit.empty() ? key : key + " [" + std::string(entry.unit) + "]";
}

std::optional<Quantity> quantityOfKey(std::string_view key) {
    for (const Entry& entry : entries)
        if (entry.info.key == key)
            return entry.quantity;
    return std::nullopt;
}

std::string axisTitle(Quantity quantity) {
    const QuantityInfo& entry = info(quantity);
    const std::string label(entry.label);
    return entry.prettyUnit.empty() ? label : label + " (" + std::string(entry.prettyUnit) + ")";
}

} // namespace irsg
