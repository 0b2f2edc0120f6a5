#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "irsg/atmosphere/import/SpectralRun.h"
#include "irsg/atmosphere/import/TextLines.h"

namespace irsg {

/// Reads a tape7 or tape7.scn of MODTRAN 4 or 5 (and the .tp7 of MODTRAN 6, which has the same
/// form): one run or several, each an echo of its cards, a line of column names (two for IEMSCT 0),
/// rows of fixed columns and -9999.
///
/// Tested on the eleven-line headers of MODTRAN 5.2 and 5.3. Cards 1 and 2 are found from the top
/// of a header, the others from its end, so that lines between (user profiles) do no harm. Columns
/// end where their names end; blank cells are blanks, not shifts. IEMSCT 0 to 3 and ITYPE 1 to 3
/// are accepted. Tables of tape7.scn in wavelengths (a first column WAVLEN) are in um, W cm-2 um-1.
/// The geometry is that of the cards, altitudes above GNDALT; a slant or vertical RANGE of 0 is
/// computed as the straight chord from H1, H2 and ANGLE with a warning. Sun: for IEMSCT 3 the
/// elevation is 90 deg - ANGLE, for IEMSCT 2 with IPARM 2 it is 90 deg - PARM2; other IPARM give a
/// warning and no sun position.
///
/// A file that stops before -9999 or before V2 is accepted with a warning that names the last
/// wavenumber; a last row that is cut is dropped. Throws InputError naming every other diagnostic
/// with its line.
std::vector<SpectralRun> readTape7(const std::filesystem::path& file);
/// The same from memory.
std::vector<SpectralRun> parseTape7(const TextLines& text);

/// The cards that the header echoes, by name: MODEL ITYPE IEMSCT IMULT M1..M6 MDEF IM NOPRNT TBOUND
/// SALB; IHAZE ISEASN IVULCN ICSTL ICLD IVSA VIS WSS WHH RAINRT GNDALT; H1 H2 ANGLE RANGE BETA RO
/// LEN; IPARM IPH IDAY ISOURC; PARM1..PARM4 TIME PSIPO, and G where the line goes on to it; V1 V2
/// DV FWHM, in the units of MODTRAN (km, degrees, cm-1). -99 is "not used". `first` is the line of
/// card 1 and `names` the one of the column names. Adds a diagnostic for each cell that is not a
/// number.
std::map<std::string, double> tape7Cards(const TextLines& text, std::size_t first,
                                         std::size_t names, std::vector<Diagnostic>& diagnostics);

/// Geometry of a run from cards in MODTRAN's units by the names above, shared by all importers.
/// Adds diagnostics (at `position`) for an ITYPE, an altitude or a range that cannot be used, and
/// warnings to `run`.
void placeRun(SpectralRun& run, const std::string& file, const std::string& position,
              std::vector<Diagnostic>& diagnostics);

} // namespace irsg
