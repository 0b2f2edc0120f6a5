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

    /// A product or quotient of a power (W, mW, uW), an area (m-2, cm-2), sr-1 and um-1, nm-1,
    /// (cm-1)-1 or cm: "W m-2 sr-1 um-1", "uW/cm2/sr/nm", "mW/(m2 sr cm-1)", "mW m-2 sr-1 cm", with
    /// raised digits or the Greek letter, too. What remains behind one slash is divided by only
    /// where it would make no sense otherwise. Throws InputError that lists what is known; "W m-2
    /// sr-1 cm-1" is refused, because it may mean per centimetre.
    static SpectralRadianceUnit parse(const std::string& text);
    static std::vector<std::string> known();
    std::string text() const;
    bool operator==(const SpectralRadianceUnit&) const = default;
};

/// Reads a user-defined spectrum (report table 18): cell (0,0) a head of spectralHead(), row 0 the
/// component names, column 0 the shared axis, ascending or descending but strictly monotonic. A
/// `# unit:` line or the heads of the columns ("CO2 [W m-2 sr-1 um-1]") may state the unit; `unit`
/// overrides them; without any, InputError. A `#
/// reference_distance_m:` line may state the distance; `referenceDistance_m` overrides it; with
/// neither, 0. Values per cm-1 become values per um with the Jacobian nu^2 / 1e4, whatever the axis
/// is. Descending axes are reversed. Each node is converted and none is added, so that one spectrum
/// written over um and over cm-1 gives one curve and one in-band radiance; a straight line in cm-1
/// between two nodes differs from one in um by at most (step / nu) / 4 of their difference.
/// Throws InputError naming file, line, column, value and what was expected, all at once.
UserSpectrum readSpectrumCsv(const std::filesystem::path& file,
                             std::optional<SpectralRadianceUnit> unit = std::nullopt,
                             std::optional<double> referenceDistance_m = std::nullopt);
/// Writes it back in um and W m-2 sr-1 um-1, with its unit and reference distance as comments and
/// its calibration applied; every number reads back as the same double. The components must share
/// one axis (LogicError). Throws InputError where the file cannot be written.
void writeSpectrumCsv(const UserSpectrum& spectrum, const std::filesystem::path& file);

enum class FactorAxis { time_s, angle_deg };

/// Reads a factor table (report tables 19 and 20): first cell empty, row 0 component names, column
/// 0 seconds or degrees. The tables are set in the factors of `into` by name (added where absent);
/// a name that is not in `spectrum` is a diagnostic, and so are negative factors, axes that do not
/// ascend, angles outside 0 to 180 and a loop over angle. After an error `into` is what it was.
void readFactorCsv(const std::filesystem::path& file, FactorAxis axis, bool loop,
                   const UserSpectrum& spectrum, ComponentFactors& into);

} // namespace irsg
