#pragma once

#include <filesystem>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "irsg/atmosphere/engine/RadiativeTransfer.h"
#include "irsg/atmosphere/import/SpectralRun.h"

// Published MODTRAN results beside those of our own air with the same settings. The test holds
// them to bounds; the program atmosphere-accuracy prints all of them.

namespace irsg::modtran {

/// A part of the spectrum over which results are averaged, in wavelength.
struct BandLimits {
    std::string name;
    double lower_per_cm = 0.0, upper_per_cm = 0.0;
};

/// One file: its run, and what the file itself does not tell.
struct PublishedFile {
    std::string name;        ///< below modtran/
    double co2_ppmv = 365.0; ///< of tape6; 365 where no file tells
    std::vector<BandLimits> bands;
};
/// For the tests that are held to each.
inline void PrintTo(const PublishedFile& file, std::ostream* out) {
    *out << file.name;
}
const std::vector<PublishedFile>& publishedFiles();

/// Means over bins brought to other wavenumbers with a triangular slit.
class Slit {
  public:
    /// `fwhm_per_cm`: full width of the slit at half of its height.
    Slit(const RadiativeTransfer& transfer, std::vector<double> wavenumbers_per_cm,
         double fwhm_per_cm);

    const NodeSet& nodes() const { return nodes_; }
    std::vector<double> at(const std::vector<double>& nodeValues) const;

  private:
    struct Bin {
        double lower_per_cm, upper_per_cm;
        std::vector<double> weights;
    };
    std::vector<double> wavenumbers_per_cm_;
    double fwhm_per_cm_;
    NodeSet nodes_;
    std::vector<Bin> bins_;
};

/// The mean over a band in wavelength of values at wavenumbers (linear between).
double bandMean(const std::vector<double>& wavenumbers_per_cm, const std::vector<double>& values,
                const BandLimits& band);

/// What is compared, on the wavenumbers of the file. Vectors that a run does not have are empty.
struct ModtranComparison {
    std::vector<double> wavenumbers_per_cm;
    std::vector<double> transmittance = {}, theirTransmittance = {};
    std::vector<double> radiance = {}, theirRadiance = {}; ///< of the path, W m-2 sr-1 um-1
    std::vector<double> scatteredSun = {};                 ///< ours, a part of the radiance
    std::vector<double> sunlight = {}, theirSunlight = {}; ///< normal to the beam, W m-2 um-1
    std::vector<double> reference = {}; ///< black body of the air at the sensor, or sun
};

/// In-band results and the bounds of the comparison: transmittance within 0.015; path radiance
/// within 3 %, or 2 % of the black body of the air at the sensor; sunlight within 3 %, or 2 % of
/// the sun above the air.
struct InBand {
    BandLimits band;
    double transmittance = 0.0, theirTransmittance = 0.0;
    /// Of path radiance or sunlight, where the run has it.
    std::optional<double> radiance = {}, theirRadiance = {}, reference = {};

    double transmittanceError() const { return transmittance - theirTransmittance; }
    /// Over the bound: 1 is the largest that is accepted.
    double radianceShare() const;
    bool holds() const;
};

/// The settings of a run as our air.
AtmosphericModel atmosphereOf(const SpectralRun& run, double co2_ppmv);
/// Reads and computes. Throws InputError where the file cannot be read.
ModtranComparison compare(const std::filesystem::path& folder, const PublishedFile& file);
std::vector<InBand> inBand(const ModtranComparison& comparison, const PublishedFile& file);

/// Columns of the file with one transmittance per absorber, and ours; at the end water's lines once
/// more as they are where air alone broadens them.
struct AbsorberComparison {
    std::string column;               ///< "H2O", "H2O CONT", ...
    std::vector<double> ours, theirs; ///< at the wavenumbers of the file
};
struct AbsorberComparisons {
    std::vector<double> wavenumbers_per_cm;
    std::vector<AbsorberComparison> absorbers = {};
};
AbsorberComparisons compareAbsorbers(const std::filesystem::path& folder);

} // namespace irsg::modtran
