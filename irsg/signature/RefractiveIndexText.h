#pragma once

#include <string>
#include <string_view>

#include "irsg/signature/SpectralLibrary.h"

namespace irsg {

/// Whether a text is a file of refractiveindex.info (YAML).
bool beginsAsRefractiveIndex(std::string_view text);

/// Its data sets: tables of n, k or both in um, and formulas of n (DispersionFormula.h) over their
/// wavelength_range, as nodes that follow them to 1e-5, with k of 0 where no data set has any. Each
/// quantity once. InputError with the line for everything else.
LibrarySpectrum readRefractiveIndex(std::string_view text, const std::string& file);

} // namespace irsg
