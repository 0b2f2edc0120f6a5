#include <algorithm>
#include <array>
#include <utility>

#include "irsg/atmosphere/TabulatedAtmosphere.h"
#include "irsg/atmosphere/TabulatedPoints.h"
#include "irsg/atmosphere/ck/CkCache.h"
#include "irsg/atmosphere/ck/CkTraining.h"

namespace irsg {

namespace {

/// Of many, some that are spread over all.
template <typename Value>
std::vector<Value> spread(const std::vector<Value>& all, std::size_t most) {
    std::vector<Value> some;
    const std::size_t count = std::min(all.size(), most);
    for (std::size_t i = 0; i < count; ++i)
        some.push_back(all[count > 1 ? i * (all.size() - 1) / (count - 1) : 0]);
    return some;
}

CacheKey keyOf(const std::vector<SpectralRun>& runs, const CkRequest& request) {
    CacheKey key;
    key.add(ckTraining).add("runs").add(static_cast<double>(runs.size()));
    for (const SpectralRun& run : runs) {
        const RunGeometry& at = run.geometry;
        key.add(static_cast<double>(run.kind)).add(static_cast<double>(at.path));
        key.add(at.sensorAltitude_m).add(at.targetAltitude_m).add(at.range_m).add(at.elevation_rad);
        key.add(at.sunElevation_rad ? *at.sunElevation_rad : 1e9);
        for (const auto* values :
             {&run.wavenumbers_per_cm, &run.transmittance, &run.pathRadiance_W_m2_sr_um,
              &run.totalRadiance_W_m2_sr_um, &run.solarIrradiance_W_m2_um, &run.scatteringDepth})
            key.addDigest(*values);
    }
    addTo(key, request);
    return key;
}

} // namespace

std::vector<AtmosphericPath> TabulatedAtmosphere::ckPaths(bool heldOut) const {
    constexpr std::size_t mostEnds = 16;
    // Parts of the longest range of two ends; the table reaches from there to no range at all.
    static constexpr std::array trained = {0.002, 0.01, 0.03, 0.08, 0.15, 0.25, 0.4, 0.6, 0.8, 1.0};
    static constexpr std::array between = {0.004, 0.05, 0.2, 0.5, 0.9};
    std::vector<AtmosphericPath> ends = transmittances_.finite.longest();
    // Half way to the next altitudes as well: what lies between runs is another air.
    for (std::size_t i = 0, count = ends.size(); i + 1 < count; ++i)
        ends.push_back({0.5 * (ends[i].sensorAltitude_m + ends[i + 1].sensorAltitude_m),
                        0.5 * (ends[i].targetAltitude_m + ends[i + 1].targetAltitude_m),
                        std::min(ends[i].range_m, ends[i + 1].range_m)});
    std::vector<AtmosphericPath> paths;
    for (const std::vector<AtmosphericPath>& some :
         {spread(ends, mostEnds), spread(transmittances_.toSpace.longest(), mostEnds)})
        for (AtmosphericPath path : some) {
            const double longest_m = path.range_m;
            for (const double part :
                 heldOut ? std::span<const double>(between) : std::span<const double>(trained)) {
                path.range_m = part * longest_m;
                paths.push_back(path);
            }
        }
    return paths;
}

std::shared_ptr<const TabulatedAtmosphere>
TabulatedAtmosphere::of(const std::vector<std::uint32_t>& nodes) const {
    const std::lock_guard lock(ofPoints_->mutex);
    if (const auto known = ofPoints_->known.find(nodes); known != ofPoints_->known.end())
        return known->second;
    std::vector<SpectralRun> some = runs_;
    for (SpectralRun& run : some)
        for (auto* values :
             {&run.wavenumbers_per_cm, &run.transmittance, &run.pathRadiance_W_m2_sr_um,
              &run.totalRadiance_W_m2_sr_um, &run.solarIrradiance_W_m2_um, &run.scatteringDepth}) {
            if (values->empty())
                continue;
            std::vector<double> kept; // wavenumbers ascend
            for (std::size_t i = nodes.size(); i-- > 0;)
                kept.push_back((*values)[values->size() - 1 - nodes[i]]);
            *values = std::move(kept);
        }
    if (ofPoints_->known.size() >= OfPoints::most)
        ofPoints_->known.clear();
    return ofPoints_->known[nodes] =
               std::make_shared<const TabulatedAtmosphere>(std::move(some), name_);
}

std::vector<double> TabulatedAtmosphere::valuesAtPoints(const AtmosphericQuery& query,
                                                        const SensorCkData& points) const {
    return of(points.nodes().nodes)->valuesAt(query, 0, points.size());
}

std::shared_ptr<const SensorCkData> TabulatedAtmosphere::prepareCk(const CkRequest& request) const {
    checkRange(request.band.range());
    const auto [first, last] = nodesAround(request.band.range());
    const std::vector<double> wavelengths_um(
        wavelengths_um_.begin() + static_cast<std::ptrdiff_t>(first),
        wavelengths_um_.begin() + static_cast<std::ptrdiff_t>(last));
    CkAtmosphere known{.nodes = CkNodes(wavelengths_um, first, request.band),
                       .values = {},
                       .paths = ckPaths(false),
                       .sights = spread(backgrounds_.sights(), 40),
                       .heldOut = ckPaths(true)};
    known.values = [&](const AtmosphericQuery& query) -> std::vector<double> {
        if (!supports(query.quantity))
            return {};
        try {
            std::vector<double> values = valuesAt(query, first, last);
            std::ranges::reverse(values); // nodes ascend in wavenumber
            return values;
        } catch (const InputError&) { // the family does not reach there
            return {};
        }
    };
    return cachedOrTrained(ckStore(), keyOf(runs_, request), known.nodes, request.band,
                           [&] { return SensorCkData::prepare(known, *this, request); });
}

} // namespace irsg
