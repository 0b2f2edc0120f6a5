#pragma once

#include <filesystem>
#include <memory>

#include "irsg/atmosphere/Atmosphere.h"

namespace irsg {

/// The atmosphere of a file, whatever kind it is: AtmosphereSmart (KARMA XML), a homogeneous one
/// (CSV with an extinction), the spectra of a radiative output (CSV with the comment `analysis:
/// radiative`), a table of our own (.smatatm), results of MODTRAN 4 to 6 (tape7, tape7.scn, CSV,
/// JSON). The content decides, not the name, except that .csv is CSV. Throws InputError for a file
/// that is none of these, for an Environment (see EnvironmentXml.h) and for every diagnostic of one
/// that is.
std::shared_ptr<const Atmosphere> loadAtmosphere(const std::filesystem::path& file);

} // namespace irsg
