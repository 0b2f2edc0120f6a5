#pragma once

#include <string>

#include "irsg/signature/SignatureDatabase.h"
#include "irsg/signature/SpectralLibrary.h"

namespace irsg {

/// Gives a material the spectra that a file of a library holds: from reflectance or emissivity an
/// opaque one, from transmittance one that does not reflect; n and k stand beside what is there.
/// Remarks on the format, and on values a little outside of 0 to 1, which become the bound. Throws
/// InputError with every line whose value is farther outside; the material then stays.
void takeLibrarySpectrum(const LibrarySpectrum& library, const std::string& file,
                         Material& material);

} // namespace irsg
