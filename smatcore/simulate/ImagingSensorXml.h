#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "irsg/core/Errors.h"
#include "irsg/karma/KarmaXml.h"
#include "smatcore/settings/Settings.h"

namespace smat {

/// The report's ImagingSensor parameters (F34). Each is optional: one that a file does not give
/// leaves its setting as it is.
struct ImagingSensorParameters {
    std::optional<double> calculationMode = {};     ///< 1 spectral, 2 wideband correlated-k
    std::optional<double> antialiasingMode = {};    ///< 0 to 5, as render.antialiasing
    std::optional<double> isUniformBackground = {}; ///< 1: one line of sight, 0: rows and columns
    std::optional<double> numberOfBackgroundColumns = {};  ///< of lines of sight
    std::optional<double> numberOfBackgroundRows = {};     ///< of lines of sight
    std::optional<double> useSkyboxBackground = {};        ///< 1: on
    std::optional<double> useTerrainBackground = {};       ///< 1: on
    std::optional<double> skyboxTextureRadianceSlope = {}; ///< W m-2 sr-1 from black to white
    std::optional<double> skyboxTextureColorOffset = {};   ///< texture value that adds 0
    std::optional<double> terrainTextureRadianceSlope = {};
    std::optional<double> terrainTextureColorOffset = {};
    std::optional<double> useAtmosphereScattering = {}; ///< 1: aerosol scattering on

    bool operator==(const ImagingSensorParameters&) const = default;
};

/// What describes one parameter: reading, writing, checking and the manual use it.
struct ImagingSensorParameter {
    std::string_view name; ///< as in the files in circulation
    std::optional<double> ImagingSensorParameters::*field;
    double minimum, maximum;
    bool isWhole;           ///< a code, a count or a switch
    std::string_view range; ///< in words, with the unit
    std::string_view help;
};
std::span<const ImagingSensorParameter> imagingSensorParameters();

struct ImagingSensorReading {
    ImagingSensorParameters parameters;
    std::vector<std::string> remarks; ///< parameters that are not known, with their lines
};

/// Throws InputError with file and line for every diagnostic: another type than ImagingSensor,
/// values of another kind than a number, out of range, or not whole where they must be.
ImagingSensorReading imagingSensorFromKarma(const irsg::KarmaXml& document);
/// Writes the parameters that are given into a document, and removes the others that it knows; what
/// else stands there is kept.
void toKarma(const ImagingSensorParameters& parameters, irsg::KarmaXml& document);
/// A document of their own.
irsg::KarmaXml toKarma(const ImagingSensorParameters& parameters,
                       const std::string& documentation = "Calculation, antialiasing and "
                                                          "background of an imaging sensor.");

/// Parameters as settings, and what they cannot say.
struct ImagingSensorSettings {
    /// A setting that must name files, because a parameter turns them on.
    struct Needed {
        std::string setting, parameter;
    };

    Settings settings;
    std::vector<Needed> needed;
};
ImagingSensorSettings settingsOf(const ImagingSensorParameters& parameters);
/// The settings in effect as parameters: all of them.
ImagingSensorParameters imagingSensorParametersOf(const Settings& settings);

/// A file that was read as settings, to go below what else says them.
struct ImagingSensorFile {
    std::filesystem::path file;
    ImagingSensorSettings set;
    std::vector<std::string> remarks; ///< "ImagingSensor.xml: line 3: Gain is no parameter of ..."

    /// What it turns on must be named somewhere: a diagnostic for each setting that is empty, which
    /// `whose`, "the project", should set.
    std::vector<irsg::Diagnostic> missingIn(const Settings& inEffect,
                                            const std::string& whose) const;
};
/// Throws InputError as irsg::KarmaXml::read and imagingSensorFromKarma do.
ImagingSensorFile readImagingSensor(const std::filesystem::path& file);
/// Writes the settings in effect, on top of what else stands in `own` where that is not empty.
/// Throws InputError.
void writeImagingSensor(const Settings& inEffect, const std::filesystem::path& file,
                        const std::filesystem::path& own = {});

} // namespace smat
