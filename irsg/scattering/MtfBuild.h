#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "irsg/scattering/MtfDatabase.h"
#include "irsg/scattering/SizeDistribution.h"
#include "irsg/scattering/SmallAngleMtf.h"

namespace irsg {

/// An aerosol of which the mean optics are known, not the sizes: it scatters by the function of
/// Henyey and Greenstein, as the air does that has it.
struct HazeAerosol {
    std::string name;
    double albedo = 1.0;    ///< 0 to 1
    double asymmetry = 0.7; ///< -0.98 to 0.98
};

/// What an MTF database is made of.
struct MtfRecipe {
    enum class Method { smallAngle, monteCarlo };
    Method method = Method::smallAngle;
    SizeDistribution sizes;             ///< of droplets of water
    std::optional<HazeAerosol> aerosol; ///< in place of the droplets; its sizes are unknown (0)
    double wavelength_um = 4.0;         ///< 0.4 to 14
    std::vector<double> opticalDepths{0.25, 0.5, 1.0, 2.0, 3.0, 4.0, 6.0, 8.0}; ///< scattering
    std::vector<ScatteringLayer> layers{{}}; ///< from the sensor to the target
    double fieldOfView_rad = 1.0;
    double lowestFrequency_per_rad = 0.05, highestFrequency_per_rad = 1e5;
    int frequencies = 201;
    std::uint64_t photons = 1'000'000; ///< for each optical depth
    std::uint64_t seed = 1;

    /// Throws InputError with every diagnostic.
    void check() const;
    /// All that the result depends on, in one line.
    std::string signature() const;
};

struct BuiltMtf {
    MtfDatabase database;
    /// By optical depth and frequency; empty for the small-angle method.
    std::vector<std::vector<double>> standardErrors;
    double albedo = 1.0, asymmetry = 0.0, forwardFraction = 1.0; ///< of the particles
};

/// Makes a database. `tell` is told the part that is done, 0 to 1, and stops the work where it says
/// false: then Cancelled is thrown. Finished batches of photons are kept in `resume`, where a file
/// is named, and taken from there by the next call with an equal recipe; what another recipe left
/// is written over, and a file of anybody else is refused. Whoever has the result removes the file.
BuiltMtf buildMtf(const MtfRecipe& recipe, const std::function<bool(double)>& tell = {},
                  const std::optional<std::filesystem::path>& resume = {});

} // namespace irsg
