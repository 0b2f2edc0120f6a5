#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "irsg/atmosphere/import/SpectralRun.h"

namespace irsg {

/// Reads the spectral CSV of MODTRAN 6 (FILEOPTIONS.CSVPRNT).
///
/// A run is a block of lines of names and units and then rows of numbers, one column each; a file
/// of several cases has several blocks. A column's name may stand on one line ("freq,tot_trans,
/// pth_thrml,...") or be spread over the lines of the header ("total" over "transmittance"); names
/// are those of tape7, of the spectral library and of the JSON document. A last row of -9999 ends
/// a block.
///
/// A CSV does not say where a run looked. That comes from the input document beside it: FILE.json
/// for FILE.csv, or a document among the .json files of the folder whose CSVPRNT is this file; of
/// its cases those with this CSVPRNT, in their order. Without one, comment lines of the CSV say it,
/// `# ITYPE: 2`, `# IEMSCT: 1`, `# H1: 0.5`, `# H2: 10`, `# ANGLE: 30`, `# RANGE: 11`, in km and
/// degrees by the names of MODTRAN's cards; comments also overrule a document. Where SPECTRAL.XFLAG
/// is M or N, the axis is um or nm and densities are W cm-2 um-1 or uW cm-2 nm-1; a unit in the
/// header that says otherwise is a diagnostic. Written from public descriptions of the format and
/// not yet checked against a file of MODTRAN itself. Throws InputError naming every diagnostic.
std::vector<SpectralRun> readModtranCsv(const std::filesystem::path& file);

/// True for a text whose header has a column of transmittance among at least two that are known.
bool isModtranCsv(std::string_view text);

} // namespace irsg
