#include "tools/atmosphere-tables/Command.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <iostream>

#include "irsg/radiometry/GaussLegendre.h"
#include "tools/atmosphere-tables/FineSpectrum.h"
#include "tools/atmosphere-tables/lines/CompleteLines.h"

// How well and how fast three methods give the transmittance of 5 cm-1 over the training paths: a
// statistical band model (Malkmus, Curtis-Godson), k-distributions gas by gas with random overlap,
// and the spectral nodes that are shipped.

namespace smat::tables {

namespace {

using namespace irsg;
using namespace irsg::lbl;

constexpr double binWidth_per_cm = 5.0;
constexpr int quantiles = 8;

/// What one gas does in one bin and one layer, in the terms of each method, per vertical layer.
struct GasLayer {
    std::vector<double> depth;              ///< line by line, at every point
    std::array<double, quantiles> sorted{}; ///< means of the sorted depths around Gauss's points
    double mean = 0.0;                      ///< mean depth
    double widthOverSpacing = 0.0;          ///< Lorentz half width times effective line density
};

/// Lines of a gas in a bin as a statistical model sees them: (sum sqrt S)^2 / sum S a bin.
double effectiveDensity_per_cm(const LineList& gas, const PartitionSums& partition,
                               double lower_per_cm, double temperature_K) {
    double roots = 0.0, sum = 0.0;
    const auto first =
        std::ranges::lower_bound(gas.lines, lower_per_cm, {}, &Line::wavenumber_per_cm);
    for (auto line = first;
         line != gas.lines.end() && line->wavenumber_per_cm < lower_per_cm + binWidth_per_cm;
         ++line) {
        const double S =
            line->intensity * partition.ratioTo296(gas.gas, line->isotopologue, temperature_K) *
            std::exp(-1.438776877 * line->lowerEnergy_per_cm * (1.0 / temperature_K - 1.0 / 296.0));
        roots += std::sqrt(S);
        sum += S;
    }
    return sum > 0.0 ? roots * roots / sum / binWidth_per_cm : 0.0;
}

struct Bin {
    std::vector<std::array<GasLayer, lineGasCount>> layers;
};

Bin binOf(const FineCrossSections& fine, const CrossSectionGrid& grid,
          const TrainingPaths& training, const std::vector<LineList>& gases,
          const PartitionSums& partition, double lower_per_cm) {
    const auto first = static_cast<std::size_t>(
        std::lround((lower_per_cm - fine.grid.first_per_cm) / fine.grid.step_per_cm + 0.5));
    const auto count =
        static_cast<std::size_t>(std::lround(binWidth_per_cm / fine.grid.step_per_cm));
    const GaussRule& rule = gaussLegendre(quantiles);
    Bin bin;
    for (const TrainingLayer& layer : training.layers) {
        std::array<GasLayer, lineGasCount> all;
        for (const LineList& gas : gases) {
            const auto g = static_cast<std::size_t>(gas.gas);
            const auto& points = fine.lnCrossSection[g];
            if (points.empty())
                continue;
            const GridStencil around = grid.stencil(gas.gas, layer.air);
            const double column = layer.air.density_per_m3(gas.gas) * 1e-4 * layer.thickness_m;
            GasLayer& own = all[g];
            own.depth.resize(count);
            for (std::size_t i = 0; i < count; ++i) {
                double ln = 0.0;
                for (std::size_t k = 0; k < around.count; ++k)
                    ln += static_cast<double>(around.weights[k]) *
                          static_cast<double>(points[around.points[k]][first + i]);
                own.depth[i] = std::exp(ln) * column;
                own.mean += own.depth[i] / static_cast<double>(count);
            }
            // A quantile's k is the mean of the sorted values over the share of its weight.
            std::vector<double> sorted = own.depth;
            std::ranges::sort(sorted);
            double begin = 0.0;
            for (std::size_t q = 0; q < quantiles; ++q) {
                const double end = begin + rule.weights[q] * static_cast<double>(count);
                const auto a = static_cast<std::size_t>(begin);
                const auto b =
                    std::max(a + 1, std::min(count, static_cast<std::size_t>(std::lround(end))));
                for (std::size_t i = a; i < b; ++i)
                    own.sorted[q] += sorted[i] / static_cast<double>(b - a);
                begin = end;
            }
            const double lorentz_per_cm = 0.07 * layer.air.pressure_hPa / 1013.25 *
                                          std::pow(296.0 / layer.air.temperature_K, 0.7);
            own.widthOverSpacing =
                lorentz_per_cm *
                effectiveDensity_per_cm(gas, partition, lower_per_cm, layer.air.temperature_K);
        }
        bin.layers.push_back(std::move(all));
    }
    return bin;
}

double lineByLine(const Bin& bin, const TrainingPath& path, std::vector<double>& depth) {
    std::ranges::fill(depth, 0.0);
    for (std::size_t l = path.first; l < path.last; ++l)
        for (const GasLayer& gas : bin.layers[l])
            for (std::size_t i = 0; i < gas.depth.size(); ++i)
                depth[i] += gas.depth[i];
    double sum = 0.0;
    for (const double d : depth)
        sum += std::exp(-d * path.factor);
    return sum / static_cast<double>(depth.size());
}

double bandModel(const Bin& bin, const TrainingPath& path) {
    double transmittance = 1.0;
    for (std::size_t g = 0; g < lineGasCount; ++g) {
        double depth = 0.0, width = 0.0; // Curtis and Godson: widths weighted with amounts
        for (std::size_t l = path.first; l < path.last; ++l) {
            const GasLayer& gas = bin.layers[l][g];
            depth += gas.mean;
            width += gas.mean * gas.widthOverSpacing;
        }
        depth *= path.factor;
        width *= path.factor;
        if (depth <= 0.0 || width <= 0.0)
            continue;
        const double y = width / depth; // alpha / d
        const double half = 0.5 * 3.14159265358979 * y;
        transmittance *= std::exp(-half * (std::sqrt(1.0 + 2.0 * depth / half) - 1.0));
    }
    return transmittance;
}

double kDistribution(const Bin& bin, const TrainingPath& path) {
    const GaussRule& rule = gaussLegendre(quantiles);
    double transmittance = 1.0;
    for (std::size_t g = 0; g < lineGasCount; ++g) {
        double own = 0.0;
        for (std::size_t q = 0; q < quantiles; ++q) {
            double depth = 0.0;
            for (std::size_t l = path.first; l < path.last; ++l)
                depth += bin.layers[l][g].sorted[q];
            own += rule.weights[q] * std::exp(-depth * path.factor);
        }
        transmittance *= own;
    }
    return transmittance;
}

/// The nodes' depths per layer, so that the time is that of a path through air that is prepared, as
/// for the other methods.
struct NodeBin {
    std::vector<double> weights;
    std::vector<std::vector<double>> depth; ///< [layer][node]
};

double spectralNodes(const NodeBin& bin, const TrainingPath& path) {
    double transmittance = 0.0;
    for (std::size_t n = 0; n < bin.weights.size(); ++n) {
        double depth = 0.0;
        for (std::size_t l = path.first; l < path.last; ++l)
            depth += bin.depth[l][n];
        transmittance += bin.weights[n] * std::exp(-depth * path.factor);
    }
    return transmittance;
}

struct Score {
    double squares = 0.0, largest = 0.0, seconds = 0.0;
    std::size_t cases = 0;

    template <typename Method>
    void run(const std::vector<double>& truth, const TrainingPaths& training, Method method) {
        std::vector<double> values(truth.size());
        const auto start = std::chrono::steady_clock::now();
        for (std::size_t p = 0; p < truth.size(); ++p)
            values[p] = method(training.paths[p]);
        seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        for (std::size_t p = 0; p < truth.size(); ++p) {
            const double error = std::abs(values[p] - truth[p]);
            squares += error * error;
            largest = std::max(largest, error);
        }
        cases += truth.size();
    }
    void print(const char* name) const {
        std::printf("| %s | %.4f | %.3f | %.0f |\n", name,
                    std::sqrt(squares / static_cast<double>(cases)), largest,
                    1e9 * seconds / static_cast<double>(cases));
    }
};

} // namespace

void makeStudy(const Folders& folders) {
    const PartitionSums partition = PartitionSums::read(folders.data / "lines" / "partition");
    const std::vector<LineList> gases = completeLineLists(folders.data);
    const CrossSectionGrid grid = crossSectionGrid();
    const TrainingPaths training = trainingPaths(modelAtmospheres());
    std::printf("transmittance of 5 cm-1, %zu paths through %zu layers of six atmospheres\n",
                training.paths.size(), training.layers.size());
    std::printf(
        "| cm-1 | method | RMS error | largest | ns a path and bin |\n|---|---|---|---|---|\n");
    for (const double lower_per_cm : {660.0, 960.0, 1200.0, 2040.0, 2280.0, 2880.0, 4800.0}) {
        const Piece piece{lower_per_cm, lower_per_cm + 60.0, 1, 0.002};
        const FineCrossSections fine = fineCrossSections(gases, partition, grid, piece);
        const TrainedNodes nodes = trainNodes(fine, grid, training, piece.lower_per_cm,
                                              piece.upper_per_cm, 1, nodeGoals());
        Score band, distribution, sampling;
        for (const SpectralBin& at : nodes.bins[1].bins) {
            const Bin bin = binOf(fine, grid, training, gases, partition, at.lower_per_cm);
            std::vector<double> truth, depth(bin.layers[0][0].depth.size());
            for (const auto& gas : bin.layers[0])
                depth.resize(std::max(depth.size(), gas.depth.size()));
            for (const TrainingPath& path : training.paths)
                truth.push_back(lineByLine(bin, path, depth));
            NodeBin own;
            own.depth.assign(bin.layers.size(), {});
            for (std::uint32_t i = at.first; i < at.first + at.count; ++i) {
                own.weights.push_back(static_cast<double>(nodes.bins[1].weights[i]));
                const double nu = nodes.wavenumbers_per_cm[nodes.bins[1].nodes[i]];
                const auto point = static_cast<std::size_t>(
                    std::lround((nu - at.lower_per_cm) / fine.grid.step_per_cm - 0.5));
                for (std::size_t l = 0; l < bin.layers.size(); ++l) {
                    double sum = 0.0;
                    for (const GasLayer& gas : bin.layers[l])
                        sum += gas.depth.empty() ? 0.0 : gas.depth[point];
                    own.depth[l].push_back(sum);
                }
            }
            band.run(truth, training, [&](const TrainingPath& p) { return bandModel(bin, p); });
            distribution.run(truth, training,
                             [&](const TrainingPath& p) { return kDistribution(bin, p); });
            sampling.run(truth, training,
                         [&](const TrainingPath& p) { return spectralNodes(own, p); });
        }
        char name[64];
        auto print = [&](const Score& score, const char* method) {
            std::snprintf(name, sizeof name, "%g-%g | %s", piece.lower_per_cm, piece.upper_per_cm,
                          method);
            score.print(name);
        };
        print(band, "band model");
        print(distribution, "k-distribution, 8 points a gas");
        print(sampling, "spectral nodes");
        std::fflush(stdout);
    }
}

} // namespace smat::tables
