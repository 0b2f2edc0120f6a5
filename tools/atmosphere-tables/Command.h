#pragma once

#include <filesystem>
#include <utility>
#include <vector>

namespace smat::tables {

/// Where the public data lie and where the tables go.
struct Folders {
    std::filesystem::path data; ///< the folder with lines/, lowtran/, continuum/, profiles/, solar/
    std::filesystem::path out;  ///< resources/atmosphere
    /// Of the gases: parts of the spectrum to compute anew, the rest is that of the table that is
    /// in `out` already; none: all of it.
    std::vector<std::pair<double, double>> renew_per_cm = {};
    /// Of the gases: parts of the table in `out` whose errors are computed anew, no more.
    std::vector<std::pair<double, double>> measure_per_cm = {};
};

/// Each writes one kind of table, says on standard output from what and how, and throws
/// irsg::InputError for data that are missing or damaged.
void makeProfiles(const Folders& folders);
void makeParticles(const Folders& folders);
void makeSolarSpectrum(const Folders& folders);
void makeContinuum(const Folders& folders);
void makeGases(const Folders& folders);
/// What tests hold the spectral mode to (tests/data/atmosphere): takes a quarter of an hour.
void makeTruth(const Folders& folders);
/// The spectra of the samples' plumes; `out` is the folder of the samples.
void makePlumes(const Folders& folders);
/// Narrow-band tables of hot gas; the numbers of NIST lie beside `data`, in hotgas/.
void makeHotGas(const Folders& folders);
/// Cross sections of hot gas and air at the same wavenumbers.
void makeHotGasSamples(const Folders& folders);
/// Prints speed and error of a band model, of k-distributions and of spectral nodes; writes
/// nothing.
void makeStudy(const Folders& folders);

} // namespace smat::tables
