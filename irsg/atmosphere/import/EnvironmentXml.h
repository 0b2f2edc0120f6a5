#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "irsg/atmosphere/Environment.h"
#include "irsg/karma/KarmaXml.h"

namespace irsg {

/// The report's Environment parameters (tables 9 and 11): SunAzimuth (0 to 2 pi rad, East of North)
/// and SunElevation (-pi/2 to pi/2 rad), BackgroundRadianceWavelengths (um) and
/// BackgroundRadianceValues (W m-2 sr-1 um-1, at least 0), which are there both or not at all, and
/// the composition: one atmosphere an entry, lowest priority first, ties in the order of the file.
struct EnvironmentParameters {
    SunPosition sun; ///< azimuth 0 and elevation 0.7854 rad where they are not given
    std::optional<Spectrum> background; ///< 0 outside its wavelengths
    std::vector<KarmaComposite> composition;
};

struct EnvironmentReading {
    EnvironmentParameters parameters;
    std::vector<std::string> remarks; ///< defaults that were taken, parameters that are not known
};

/// True for a KARMA file of the type Environment; false for every other file, and for one that
/// cannot be read.
bool isEnvironmentXml(const std::filesystem::path& file);

/// Throws InputError with file and line for every diagnostic: another type, values out of range or
/// of another kind, a background whose arrays differ in number or do not ascend, a composite that
/// has a composition of its own.
EnvironmentReading environmentFromKarma(const KarmaXml& document);
/// Writes the parameters into a document; what else stands there is kept.
void toKarma(const EnvironmentParameters& parameters, KarmaXml& document);
/// A document of their own.
KarmaXml toKarma(const EnvironmentParameters& parameters,
                 const std::string& documentation = "Sun, default background and atmospheres.");

struct LoadedEnvironment {
    Environment environment;
    std::vector<std::string> remarks; ///< of the file alone; each atmosphere has its own
};
/// Reads the file and, with loadAtmosphere, the files of its composition (paths as in
/// resolveKarmaPath). Throws InputError with the diagnostics of all of them together.
LoadedEnvironment loadEnvironment(const std::filesystem::path& file);

} // namespace irsg
