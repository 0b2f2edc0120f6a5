#include <cmath>
#include <stdexcept>

#include <unistd.h>

#include "irsg/atmosphere/ck/CkNodes.h"
#include "irsg/atmosphere/ck/SensorCkData.h"
#include "irsg/core/CacheStore.h"
#include "irsg/core/Errors.h"
#include "irsg/core/FileReading.h"
#include "tests/fuzz/Readers.h"
#ifdef SMAT_HAS_SCATTERING
#include "irsg/scattering/FinishedBatches.h"
#endif

// Readers of what programs of ours keep for themselves: trained points, batches of photons.

namespace smat::test {

namespace {

namespace fs = std::filesystem;
using File = const fs::path&;

const irsg::RadiativeTransfer& air() {
    static const irsg::RadiativeTransfer clear(
        {irsg::Profile::model(irsg::ModelAtmosphere::usStandard1976), {}},
        irsg::GasTable::shipped());
    return clear;
}

const char* const keptUnder = "a key";
const irsg::CacheStore::Kind kind{"wideband", 1 << 20};

/// Few bins, since they are looked through at every reading.
const irsg::Band& narrowBand() {
    static const irsg::Band band = irsg::Band::topHat(10.0, 10.05);
    return band;
}

std::string widebandText() {
    irsg::CkRequest request;
    request.band = narrowBand();
    return irsg::SensorCkData::prepare(air(), request).cacheText();
}

void readWidebandText(File file) {
    const auto points = irsg::SensorCkData::fromCached(irsg::CkNodes(air(), narrowBand()),
                                                       narrowBand(), irsg::readFile(file));
    if (!points) { // trained anew, without a word
        throw irsg::InputError({file.string(), "", "no points", "points that were kept"});
    }
    const std::vector<double> means = points->sampled(irsg::Spectrum::constant(0.5));
    for (const double mean : means) {
        if (!(std::abs(mean - 0.5) < 1e-9)) {
            throw std::logic_error("a mean of 0.5 that is none");
        }
    }
}

std::string keptBytes() {
    const fs::path folder =
        fs::temp_directory_path() / ("smat-fuzz-kept-" + std::to_string(getpid()));
    irsg::CacheStore(folder, kind).keep(keptUnder, "points");
    const std::string bytes = irsg::readFile(fs::directory_iterator(folder)->path());
    fs::remove_all(folder);
    return bytes;
}

/// A file of the store, which finds it under the name that the key gives it.
void readKept(File file) {
    static const irsg::CacheStore store = [&] {
        const fs::path folder = file.parent_path() / "wideband";
        irsg::CacheStore made(folder, kind);
        made.keep(keptUnder, "");
        const fs::path name = fs::directory_iterator(folder)->path();
        fs::remove(name);
        fs::create_symlink(file, name);
        return made;
    }();
    if (!store.find(keptUnder)) {
        throw irsg::InputError({file.string(), "", "no points", "points that were kept"});
    }
}

#ifdef SMAT_HAS_SCATTERING
const std::string recipe = std::string(irsg::FinishedBatches::firstWords) + "; a";

void readBatches(File file) {
    for (const auto& [key, sums] : irsg::FinishedBatches::read(file, recipe, 2)) {
        if (sums.sums.size() != 2 || sums.squares.size() != 2) {
            throw std::logic_error("a batch of other frequencies");
        }
    }
}
#endif

} // namespace

std::vector<FuzzedReader> keptReaders() {
    return {
        {"kept-file", ".cache", readKept, {}, {keptBytes()}},
        {"kept-points", ".ck", readWidebandText, {}, {widebandText()}},
#ifdef SMAT_HAS_SCATTERING
        {"mtf-batches",
         ".part",
         readBatches,
         {},
         {recipe + "\n0 0 20000 0.5 0.25 0.25 0.0625 .\n0 1 20000 1e-3 1 0 1 .\n"}},
#endif
    };
}

} // namespace smat::test
