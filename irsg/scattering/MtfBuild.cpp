#include "irsg/scattering/MtfBuild.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>
#include <sstream>

#include "irsg/core/Collect.h"
#include "irsg/core/Errors.h"
#include "irsg/core/ParallelFor.h"
#include "irsg/radiometry/Units.h"
#include "irsg/scattering/FinishedBatches.h"
#include "irsg/scattering/PhotonTracer.h"
#include "irsg/scattering/WaterIndex.h"

namespace irsg {

namespace {

constexpr double speedOfLight_um_s = 299792458e6;
constexpr std::uint64_t photonsOfBatch = 20'000;
/// Part of the progress that the optics of the droplets are.
constexpr double shareOfOptics = 0.2;

struct ParticleScattering {
    PhaseFunction phase;
    double albedo;
};

ParticleScattering scatteringOf(const MtfRecipe& recipe, const std::function<bool(double)>& tell) {
    if (recipe.aerosol)
        return {PhaseFunction::henyeyGreenstein(recipe.aerosol->asymmetry), recipe.aerosol->albedo};
    DropletOptics optics =
        dropletOptics(recipe.sizes, waterIndex(recipe.wavelength_um), recipe.wavelength_um, tell);
    const double albedo = optics.albedo();
    return {std::move(optics.phase), albedo};
}

std::vector<PhotonEstimate> tracePhotons(const MtfRecipe& recipe, const PhaseFunction& phase,
                                         const std::vector<double>& frequencies,
                                         const std::function<bool(double)>& tell,
                                         const std::optional<std::filesystem::path>& resume) {
    const auto batches =
        static_cast<std::size_t>((recipe.photons + photonsOfBatch - 1) / photonsOfBatch);
    const std::size_t count = recipe.opticalDepths.size() * batches;
    std::vector<PhotonTracer> tracers;
    for (const double depth : recipe.opticalDepths)
        tracers.emplace_back(phase, recipe.layers, depth, frequencies);
    std::optional<FinishedBatches> finished;
    if (resume)
        finished.emplace(*resume, recipe.signature(), frequencies.size());
    std::vector<PhotonSums> sums(count);
    std::mutex telling;
    std::size_t done = 0;
    std::atomic<bool> stopped = false;
    parallelFor(count, [&](std::size_t i) {
        const FinishedBatches::Key key{i / batches, i % batches};
        if (stopped)
            return;
        if (const PhotonSums* known = finished ? finished->find(key) : nullptr) {
            sums[i] = *known;
        } else {
            const std::uint64_t first = key.second * photonsOfBatch;
            sums[i] = tracers[key.first].trace(recipe.seed + (key.first << 32), key.second,
                                               std::min(photonsOfBatch, recipe.photons - first));
            if (finished)
                finished->keep(key, sums[i]);
        }
        const std::lock_guard lock(telling);
        ++done;
        if (tell && !tell(shareOfOptics + (1.0 - shareOfOptics) * static_cast<double>(done) /
                                              static_cast<double>(count)))
            stopped = true;
    });
    if (stopped)
        throw Cancelled{};
    std::vector<PhotonEstimate> result;
    for (std::size_t m = 0; m < tracers.size(); ++m) {
        PhotonSums all;
        for (std::size_t b = 0; b < batches; ++b)
            all.add(sums[m * batches + b]);
        result.push_back(tracers[m].estimate(all));
    }
    return result;
}

} // namespace

void MtfRecipe::check() const {
    std::vector<Diagnostic> diagnostics;
    const auto need = [&](bool isRight, const char* what, const std::string& value,
                          const char* expected) {
        if (!isRight)
            diagnostics.push_back({"", what, value, expected});
    };
    need(wavelength_um >= 0.4 && wavelength_um <= 14.0, "wavelength",
         numberText(wavelength_um) + " um", "0.4 to 14 um");
    need(!opticalDepths.empty() && opticalDepths.size() <= 1000, "optical depths",
         std::to_string(opticalDepths.size()) + " of them", "1 to 1000 of them");
    double last = 0.0;
    for (const double depth : opticalDepths) {
        need(depth > last && depth <= 50.0, "optical depth", numberText(depth),
             "ascending numbers above 0, at most 50");
        last = depth;
    }
    need(fieldOfView_rad > 0.0 && fieldOfView_rad <= pi, "field of view",
         numberText(degrees(fieldOfView_rad)) + " deg", "above 0, at most 180 deg");
    need(frequencies >= 3 && frequencies <= 10000, "frequencies", std::to_string(frequencies),
         "3 to 10000");
    need(lowestFrequency_per_rad > 0.0 && highestFrequency_per_rad > lowestFrequency_per_rad &&
             highestFrequency_per_rad <= 1e7,
         "frequencies",
         numberText(lowestFrequency_per_rad) + " to " + numberText(highestFrequency_per_rad),
         "0 < lowest < highest <= 1e7 cycles per radian");
    need(photons >= 1 && photons <= 1'000'000'000'000u, "photons", std::to_string(photons),
         "1 to 1e12");
    if (aerosol) {
        need(aerosol->albedo >= 0.0 && aerosol->albedo <= 1.0, "albedo of the aerosol",
             numberText(aerosol->albedo), "0 to 1");
        collect(diagnostics, [&] { PhaseFunction::henyeyGreenstein(aerosol->asymmetry); });
    } else {
        collect(diagnostics, [&] { sizes.nodes(); });
    }
    collect(diagnostics, [&] { normalised(layers); });
    if (!diagnostics.empty())
        throw InputError(std::move(diagnostics));
}

std::string MtfRecipe::signature() const {
    std::ostringstream out;
    out.precision(17);
    out << FinishedBatches::firstWords << "; ";
    if (aerosol)
        out << "asymmetry " << aerosol->asymmetry;
    else
        out << sizes.description();
    out << "; " << wavelength_um << "; " << fieldOfView_rad << "; " << lowestFrequency_per_rad
        << " " << highestFrequency_per_rad << " " << frequencies << "; " << photons << " " << seed
        << ";";
    for (const double depth : opticalDepths)
        out << ' ' << depth;
    for (const ScatteringLayer& layer : layers)
        out << "; " << layer.thickness << ':' << layer.concentration;
    return out.str();
}

BuiltMtf buildMtf(const MtfRecipe& recipe, const std::function<bool(double)>& tell,
                  const std::optional<std::filesystem::path>& resume) {
    recipe.check();
    const auto toldOptics = [&](double part) { return !tell || tell(shareOfOptics * part); };
    const ParticleScattering optics = scatteringOf(recipe, toldOptics);
    const std::vector<double> frequencies = mtfFrequencies(
        recipe.lowestFrequency_per_rad, recipe.highestFrequency_per_rad, recipe.frequencies);
    std::vector<std::vector<double>> values, errors;
    if (recipe.method == MtfRecipe::Method::monteCarlo) {
        for (PhotonEstimate& estimate :
             tracePhotons(recipe, optics.phase, frequencies, tell, resume)) {
            values.push_back(std::move(estimate.mtf));
            errors.push_back(std::move(estimate.standardError));
        }
    } else {
        const SmallAngleMtf theory(optics.phase, recipe.layers, frequencies.back());
        for (const double depth : recipe.opticalDepths) {
            if (tell && !tell(0.9))
                throw Cancelled{};
            values.push_back(theory.curve(depth, frequencies).values());
        }
    }
    const double diameter_m = recipe.aerosol ? 0.0 : 1e-6 * recipe.sizes.meanDiameter_um();
    const MtfHeader header{recipe.fieldOfView_rad, pi, diameter_m,
                           speedOfLight_um_s / recipe.wavelength_um};
    if (tell)
        tell(1.0);
    return {MtfDatabase(header, frequencies, recipe.opticalDepths, std::move(values)),
            std::move(errors), optics.albedo, optics.phase.asymmetry(),
            optics.phase.forwardFraction()};
}

} // namespace irsg
