#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "irsg/atmosphere/Atmosphere.h"

namespace irsg {

/// A kind of file that holds one atmosphere. A new kind is a row of atmosphereFormats(): what is
/// opened, what people are told and the help of settings come from it.
struct AtmosphereFormat {
    std::string_view words; ///< ".smatatm"
    /// By content, but that .csv is CSV. Throws InputError for a file that cannot be read.
    bool (*recognises)(const std::filesystem::path& file);
    std::shared_ptr<const Atmosphere> (*open)(const std::filesystem::path& file);
};

/// AtmosphereSmart and AtmosphereScatteringLUT (KARMA XML), the spectra of a radiative output (CSV
/// with the comment `analysis: radiative`), a table of our own (.smatatm), results of MODTRAN 4 to
/// 6 (tape7, tape7.scn, CSV, JSON), homogeneous air (CSV with an extinction). The first row that
/// recognises a file opens it.
const std::vector<AtmosphereFormat>& atmosphereFormats();
/// ".xml of AtmosphereSmart, ... or .csv of homogeneous air".
std::string atmosphereFormatWords();

/// The atmosphere of a file, whatever kind it is. Throws InputError for a file that is none of
/// these, for an Environment (see EnvironmentXml.h) and for every diagnostic of one that is.
std::shared_ptr<const Atmosphere> loadAtmosphere(const std::filesystem::path& file);

} // namespace irsg
