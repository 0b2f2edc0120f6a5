#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "irsg/atmosphere/import/SpectralRun.h"

namespace irsg {

/// Reads a MODTRAN 6 JSON document that holds results (FILEOPTIONS.JSONOPT WRT_OUTPUT together with
/// WRT_INPUT): {"MODTRAN": [{"MODTRANINPUT": {...}, "MODTRANOUTPUT": {"SPECTRA": {"TRANSMITTANCE" |
/// "RADIANCE" | "IRRADIANCE": {"TOT_TRANS": [...], ...}}}}, ...]}, one run a case.
///
/// Used of the input: GEOMETRY (ITYPE, H1ALT, H2ALT, OBSZEN, HRANGE, LENN, RAD_E, IPARM, PARM1 to
/// PARM4, IDAY, GMTIME), RTOPTIONS (IEMSCT, IMULT), ATMOSPHERE (MODEL, CO2MX), AEROSOLS (IHAZE,
/// ISEASN, IVULCN, ICLD, ICSTL, VIS, WSS, WHH, RAINRT), SURFACE (TPTEMP, SURREF, GNDALT), SPECTRAL
/// (V1, V2, DV, FWHM, XFLAG). Enumerations are words (RT_THERMAL_ONLY) or MODTRAN 5's numbers. With
/// both OBSZEN and HRANGE above 0 a slant path ends where they lead (MODTRAN's case 2b), with
/// HRANGE alone at H2ALT. The spectral axis is the array FREQ, WAVENUMBER or WAVELENGTH, and where
/// there is none V1, V1 + DV, ... of the input, if the arrays are that long. Several lines of sight
/// in one case (MLOS), lunar runs and documents without results are refused. Written from public
/// descriptions of the format and not yet checked against a document of MODTRAN itself.
std::vector<SpectralRun> readModtranJson(const std::filesystem::path& file);
/// The same from memory.
std::vector<SpectralRun> parseModtranJson(const std::string& text, const std::string& file);

/// The settings of one case without its results.
struct ModtranCase {
    std::string name;
    std::string csvName; ///< FILEOPTIONS.CSVPRNT
    RunKind kind = RunKind::transmittance;
    SpectralUnit unit = SpectralUnit::wavenumber;
    std::map<std::string, double> cards; ///< by the names of the cards of MODTRAN 5
};
/// All cases of an input document. Throws InputError naming what cannot be used.
std::vector<ModtranCase> parseModtranCases(const std::string& text, const std::string& file);

/// True for text that looks like a MODTRAN 6 document.
bool isModtranJson(std::string_view text);

} // namespace irsg
