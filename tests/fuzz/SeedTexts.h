#pragma once

#include <string>

namespace smat::test {

// Small files that are read as they stand, of formats that no sample has.

/// One run of MODTRAN 5: the transmittance of a level path.
std::string tape7Text();
/// Two wavenumbers of MODTRAN 6, with the sun.
std::string modtranCsvText();
std::string modtranJsonText();
/// Two level paths.
std::string tabulatedAtmosphereText();
std::string environmentText();
/// What an analysis of a radiative quantity writes.
std::string radiativeText();
std::string resultJsonText();

} // namespace smat::test
