#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "irsg/atmosphere/import/SpectralRun.h"

namespace irsg {

/// Reads a MODTRAN 6 JSON document that holds results (FILEOPTIONS.JSONOPT WRT_OUTPUT, best
/// together with WRT_INPUT): {"MODTRAN": [{"MODTRANINPUT": {...}, "MODTRANOUTPUT": {"SPECTRA":
/// {"TRANSMITTANCE" | "RADIANCE" | "IRRADIANCE": {"TOT_TRANS": [...], ...}}}}, ...]}, one run a
/// case and line of sight.
///
/// Used of the input: GEOMETRY (ITYPE, H1ALT, H2ALT, OBSZEN, HRANGE, LENN, RAD_E, IPARM, PARM1 to
/// PARM4, IDAY, GMTIME, MLOS), RTOPTIONS (IEMSCT, IMULT), ATMOSPHERE (MODEL, CO2MX), AEROSOLS
/// (IHAZE, ISEASN, IVULCN, ICLD, ICSTL, VIS, WSS, WHH, RAINRT), SURFACE (TPTEMP, SURREF, GNDALT),
/// SPECTRAL (V1, V2, DV, FWHM, XFLAG). Enumerations are words (RT_THERMAL_ONLY) or MODTRAN 5's
/// numbers. With both OBSZEN and HRANGE above 0 a slant path ends where they lead (MODTRAN's case
/// 2b), with HRANGE alone at H2ALT. The spectral axis is the array FREQ, WAVENUMBER or WAVELENGTH,
/// and where there is none V1, V1 + DV, ... of the input, if the arrays are that long.
///
/// Several lines of sight (GEOMETRY.MLOS, an array of objects with keys of GEOMETRY; what one lacks
/// is GEOMETRY's) have as many results: MODTRANOUTPUT, SPECTRA or the group in it is an array then.
/// A case without MODTRANINPUT is that of the input document in the same folder whose
/// FILEOPTIONS.JSONPRNT names this file. Lunar runs and documents without results are refused.
/// Written from public descriptions of the format and not yet checked against a document of
/// MODTRAN itself.
std::vector<SpectralRun> readModtranJson(const std::filesystem::path& file);

/// The settings of one line of sight of a case without its results.
struct ModtranCase {
    std::string name;
    std::string csvName;    ///< FILEOPTIONS.CSVPRNT
    std::string jsonName;   ///< FILEOPTIONS.JSONPRNT
    std::size_t number = 0; ///< of the case in its document
    RunKind kind = RunKind::transmittance;
    SpectralUnit unit = SpectralUnit::wavenumber;
    std::map<std::string, double> cards; ///< by the names of the cards of MODTRAN 5
};
/// All cases of an input document, each with its lines of sight. Throws InputError naming what
/// cannot be used.
std::vector<ModtranCase> parseModtranCases(const std::string& text, const std::string& file);
/// Those of the first document in the folder of `file` whose cases name it (`name` is csvName or
/// jsonName); empty where none does. The document of the same name with .json comes first, and
/// counts where none of its cases names anything else.
std::vector<ModtranCase> modtranCasesBeside(const std::filesystem::path& file,
                                            std::string ModtranCase::*name);

/// Results from memory; `beside` are the cases of those that stand there without their input.
std::vector<SpectralRun> parseModtranJson(const std::string& text, const std::string& file,
                                          const std::vector<ModtranCase>& beside = {});

/// True for text that looks like a MODTRAN 6 document.
bool isModtranJson(std::string_view text);

} // namespace irsg
