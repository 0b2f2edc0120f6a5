#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "benchmarks/atmosphere/Table.h"
#include "irsg/atmosphere/ck/SensorCkData.h"
#include "irsg/atmosphere/engine/AtmosphericColumn.h"
#include "irsg/atmosphere/engine/NodeColumn.h"
#include "irsg/radiometry/Planck.h"

namespace irsg::accuracy {

namespace {

constexpr SunPosition night{0.0, -0.5 * std::numbers::pi};
constexpr std::array<double, 6> targets_K = {250.0, 300.0, 400.0, 700.0, 1200.0, 2200.0};
/// Paths that no training has.
constexpr std::array<AtmosphericPath, 12> paths = {{{2, 2, 700},
                                                    {2, 2, 7e3},
                                                    {2, 250, 3.3e3},
                                                    {20, 2000, 9e3},
                                                    {1000, 20, 14e3},
                                                    {2500, 2500, 25e3},
                                                    {4000, 1200, 17e3},
                                                    {3000, 10000, 14e3},
                                                    {8000, 8000, 55e3},
                                                    {10000, 500, 30e3},
                                                    {12000, 9000, 100e3},
                                                    {18000, 14000, 60e3}}};

/// What every node of the spectral mode counts in an integral over the band.
std::vector<double> nodeWeights(const RadiativeTransfer& transfer, const SpectralRange& range,
                                const NodeSet& set) {
    // A spectrum is linear in the values of its nodes: one bin after the other is 1.
    const BinSet& bins = transfer.gases().bins(transfer.air().resolution_per_cm);
    std::size_t bin = 0;
    while (bins.nodes[bins.bins[bin].first] != set.nodes.front())
        ++bin;
    std::vector<double> weights;
    while (weights.size() < set.nodes.size()) {
        const SpectralBin& own = bins.bins[bin++];
        std::vector<double> values(set.nodes.size(), 0.0);
        std::fill_n(values.begin() + static_cast<std::ptrdiff_t>(weights.size()), own.count, 1.0);
        const Spectrum hat = transfer.spectrum(range, values);
        const Spectrum* factors[] = {&hat};
        const double share_um = integrateProduct(factors, range);
        for (std::uint32_t i = own.first; i < own.first + own.count; ++i)
            weights.push_back(share_um * static_cast<double>(bins.weights[i]));
    }
    return weights;
}

/// The classical correlated k: nodes sorted by their absorption in one layer of air into groups,
/// and within a group the mean absorption of every layer and the mean Planck radiance.
class SortedGroups {
  public:
    SortedGroups(const RadiativeTransfer& transfer, const NodeSet& set,
                 const std::vector<double>& weights)
        : transfer_(transfer),
          set_(set),
          weights_(weights),
          air_(transfer.air().profile, {}, GasTable::shipped()),
          column_(air_, set.nodes, set.wavenumbers_per_cm, 5.0) {}

    /// `isEven`: groups of equal width in the band, else of equal steps of ln absorption.
    void sort(std::size_t count, bool isEven) {
        const auto reference = column_.extinction(air_.placeOf(2000.0).layer);
        std::vector<std::size_t> order(set_.nodes.size());
        std::iota(order.begin(), order.end(), 0u);
        std::ranges::sort(order, {}, [&](std::size_t i) { return reference[i]; });
        const double least = std::log(static_cast<double>(reference[order.front()]));
        const double most = std::log(static_cast<double>(reference[order.back()]));
        double all = 0.0, before = 0.0;
        for (const double weight : weights_)
            all += weight;
        groupOf_.assign(order.size(), 0);
        for (const std::size_t i : order) {
            const double part =
                isEven ? (before + 0.5 * weights_[i]) / all
                       : (std::log(static_cast<double>(reference[i])) - least) / (most - least);
            groupOf_[i] =
                std::min(count - 1, static_cast<std::size_t>(part * static_cast<double>(count)));
            before += weights_[i];
        }
        width_.assign(count, 0.0);
        for (std::size_t i = 0; i < order.size(); ++i)
            width_[groupOf_[i]] += weights_[i];
        extinction_.assign(air_.levelCount() * count, 0.0);
        for (std::size_t level = 0; level < air_.levelCount(); ++level) {
            const auto row = column_.extinction(level);
            for (std::size_t i = 0; i < order.size(); ++i)
                extinction_[level * count + groupOf_[i]] +=
                    weights_[i] * static_cast<double>(row[i]) / width_[groupOf_[i]];
        }
    }

    /// In-band radiance of black targets at the far end of a path, as the sensor sees it.
    std::vector<double> apparent(const AtmosphericPath& path) const {
        const std::size_t count = width_.size();
        std::vector<double> transmittance(count, 1.0), radiance(count, 0.0);
        for (const RaySegment& segment : transfer_.tracer().between(path).segments) {
            const auto nearB = planck(air_.profile().at(segment.startAltitude_m).temperature_K);
            const auto farB = planck(air_.profile().at(segment.endAltitude_m).temperature_K);
            const auto level = static_cast<std::size_t>(segment.layer);
            for (std::size_t g = 0; g < count; ++g) {
                const double depth =
                    segment.length_m *
                    ((1.0 - segment.meanFraction) * extinction_[level * count + g] +
                     segment.meanFraction * extinction_[(level + 1) * count + g]);
                const double left = std::exp(-depth);
                const double slope = depth > 1e-4 ? (1.0 - left) / depth - left : 0.5 * depth;
                radiance[g] +=
                    transmittance[g] * (nearB[g] * (1.0 - left) + (farB[g] - nearB[g]) * slope);
                transmittance[g] *= left;
            }
        }
        std::vector<double> sums;
        for (const double target_K : targets_K) {
            const auto target = planck(target_K);
            double sum = 0.0;
            for (std::size_t g = 0; g < count; ++g)
                sum += radiance[g] + transmittance[g] * target[g];
            sums.push_back(sum);
        }
        return sums;
    }

  private:
    /// Integrals of Planck's function over the groups.
    std::vector<double> planck(double temperature_K) const {
        std::vector<double> sums(width_.size(), 0.0);
        for (std::size_t i = 0; i < groupOf_.size(); ++i)
            sums[groupOf_[i]] += weights_[i] * planckRadiance_W_m2_sr_um(
                                                   1e4 / set_.wavenumbers_per_cm[i], temperature_K);
        return sums;
    }

    const RadiativeTransfer& transfer_;
    const NodeSet& set_;
    const std::vector<double>& weights_;
    AtmosphericColumn air_;
    NodeColumn column_;
    std::vector<std::size_t> groupOf_;
    std::vector<double> width_, extinction_;
};

/// Apparent in-band radiance of the targets from values at nodes.
std::vector<double> apparent(const std::vector<double>& transmittance,
                             const std::vector<double>& radiance,
                             const std::vector<double>& wavenumbers_per_cm,
                             const std::vector<double>& weights) {
    std::vector<double> sums;
    for (const double target_K : targets_K) {
        double sum = 0.0;
        for (std::size_t i = 0; i < weights.size(); ++i)
            sum += weights[i] *
                   (radiance[i] + transmittance[i] * planckRadiance_W_m2_sr_um(
                                                         1e4 / wavenumbers_per_cm[i], target_K));
        sums.push_back(sum);
    }
    return sums;
}

struct Score {
    double squares = 0.0, largest = 0.0, count = 0.0;

    void add(const std::vector<double>& values, const std::vector<double>& truth) {
        for (std::size_t i = 0; i < truth.size(); ++i) {
            const double error = std::abs(values[i] / truth[i] - 1.0);
            squares += error * error;
            largest = std::max(largest, error);
            count += 1.0;
        }
    }
    double rms() const { return std::sqrt(squares / count); }
};

} // namespace

void widebandTables(const Output& output) {
    constexpr std::array<SpectralRange, 4> ranges = {
        {{1.5, 2.5}, {3.0, 5.0}, {4.1, 4.5}, {8.0, 12.0}}};
    constexpr std::array<std::size_t, 7> counts = {5, 10, 20, 40, 80, 150, 250};
    Table table(
        "Wideband points against the spectral mode: error of the apparent in-band radiance of "
        "black targets of 250 to 2200 K over 12 paths that were not trained, in three "
        "atmospheres (tropical, subarctic winter, US 1976)",
        {"µm", "points", "trained, RMS", "largest", "sorted by absorption, RMS", "largest"});
    for (const SpectralRange& range : ranges) {
        std::array<Score, counts.size()> trained, sorted[2];
        std::array<std::size_t, counts.size()> used{};
        for (const ModelAtmosphere model :
             {ModelAtmosphere::tropical, ModelAtmosphere::subarcticWinter,
              ModelAtmosphere::usStandard1976}) {
            AtmosphericModel air{Profile::model(model), {}};
            air.scattering = ScatteringMode::single;
            const RadiativeTransfer transfer(air, GasTable::shipped());
            const NodeSet set = transfer.nodesOf(range);
            const std::vector<double> weights = nodeWeights(transfer, range, set);
            std::vector<std::vector<double>> truth;
            for (const AtmosphericPath& path : paths)
                truth.push_back(apparent(transfer.transmittance(set, path),
                                         transfer.pathRadiance(set, path, night),
                                         set.wavenumbers_per_cm, weights));
            SortedGroups groups(transfer, set, weights);
            for (std::size_t c = 0; c < counts.size(); ++c) {
                CkRequest request;
                request.band = Band::topHat(range.min_um, range.max_um);
                request.sun = night;
                request.largestError = 0.0;
                request.mostPoints = counts[c];
                const SensorCkData ck = SensorCkData::prepare(transfer, request);
                used[c] = std::max(used[c], ck.size());
                for (std::size_t p = 0; p < paths.size(); ++p)
                    trained[c].add(apparent(transfer.transmittance(ck.nodes(), paths[p]),
                                            transfer.pathRadiance(ck.nodes(), paths[p], night),
                                            ck.nodes().wavenumbers_per_cm, ck.weights_um()),
                                   truth[p]);
                for (const bool isEven : {false, true}) {
                    groups.sort(counts[c], isEven);
                    for (std::size_t p = 0; p < paths.size(); ++p)
                        sorted[isEven][c].add(groups.apparent(paths[p]), truth[p]);
                }
            }
        }
        std::vector<Curve> curves = {{"points [1]", {}},
                                     {"trained RMS [%]", {}},
                                     {"trained largest [%]", {}},
                                     {"sorted RMS [%]", {}},
                                     {"sorted largest [%]", {}}};
        for (std::size_t c = 0; c < counts.size(); ++c) {
            const Score& best =
                sorted[0][c].rms() < sorted[1][c].rms() ? sorted[0][c] : sorted[1][c];
            const double percent[] = {100.0 * trained[c].rms(), 100.0 * trained[c].largest,
                                      100.0 * best.rms(), 100.0 * best.largest};
            const std::string points =
                used[c] < counts[c]
                    ? std::to_string(counts[c]) + " (" + std::to_string(used[c]) + " needed)"
                    : std::to_string(counts[c]);
            table.add({text("%g", range.min_um) + text("-%g", range.max_um), points,
                       text("%.3f %%", percent[0]), text("%.2f %%", percent[1]),
                       text("%.3f %%", percent[2]), text("%.2f %%", percent[3])});
            curves[0].values.push_back(static_cast<double>(counts[c]));
            for (std::size_t i = 0; i < 4; ++i)
                curves[i + 1].values.push_back(percent[i]);
        }
        writeCurves(output, "wideband-" + text("%g", range.min_um) + text("-%g", range.max_um),
                    "error of wideband points", curves);
    }
    table.print();
}

} // namespace irsg::accuracy
