#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "irsg/signature/ComponentFactors.h"
#include "irsg/signature/UserSpectrum.h"

namespace irsg {

/// Unit of the radiance values of an imported spectrum: an area and power unit, and per what.
struct SpectralRadianceUnit {
    double toW_m2 = 1.0; ///< factor to W m-2 sr-1
    bool perWavenumber = false;

    /// "W m-2 sr-1 um-1", "W cm-2 sr-1 (cm-1)-1", "uW cm-2 sr-1 um-1", ...; throws InputError that
    /// lists what is known.
    static SpectralRadianceUnit parse(const std::string& text);
    static std::vector<std::string> known();
    std::string text() const;
    bool operator==(const SpectralRadianceUnit&) const = default;
};

/// Reads a user-defined spectrum (report table 18): cell (0,0) `um` or `cm-1`, row 0 the component
/// names, column 0 the shared axis, ascending or descending but strictly monotonic. A `# unit:` line
/// may state the unit; `unit` overrides it; with neither, InputError. Values per cm-1 become values
/// per um with the Jacobian nu^2 / 1e4, whatever the axis is. Descending axes are reversed.
/// Wavenumber axes are refined in wavelength until linear interpolation in um follows linear
/// interpolation in cm-1 to 1e-7, so that both give one in-band radiance.
/// Throws InputError naming file, line, column, value and what was expected, all at once.
UserSpectrum readSpectrumCsv(const std::filesystem::path& file,
                             std::optional<SpectralRadianceUnit> unit = std::nullopt,
                             double referenceDistance_m = 0.0);
/// Writes it back in um and W m-2 sr-1 um-1 with its `# unit:` line.
void writeSpectrumCsv(const UserSpectrum& spectrum, const std::filesystem::path& file);

enum class FactorAxis { time_s, angle_deg };

/// Reads a factor table (report tables 19 and 20): first cell empty, row 0 component names, column 0
/// seconds or degrees. The tables are set in the factors of `into` by name (added where absent); a
/// name that is not in `spectrum` is an offence, and so are angles outside 0 to 180.
void readFactorCsv(const std::filesystem::path& file, FactorAxis axis, bool loop,
                   const UserSpectrum& spectrum, ComponentFactors& into);

} // namespace irsg
