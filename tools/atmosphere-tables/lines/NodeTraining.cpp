#include "tools/atmosphere-tables/lines/NodeTraining.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

#include "irsg/core/Errors.h"

namespace irsg::lbl {

namespace {

/// exp for x <= 0 to 2e-7, in a form that compilers turn into vector instructions.
inline float fastExp(float x) {
    const float scaled = std::max(x, -87.0f) * 1.44269504f;
    const auto whole = static_cast<std::int32_t>(scaled - 0.5f); // rounds to nearest, as x <= 0
    const float part = (scaled - static_cast<float>(whole)) * 0.69314718f;
    const float power =
        1.0f +
        part * (1.0f +
                part * (0.5f + part * (0.16666667f +
                                       part * (0.041666667f +
                                               part * (0.0083333333f + part * 0.0013888889f)))));
    return power * std::bit_cast<float>((whole + 127) << 23);
}

/// Optical depth of the vertical path from the ground of each atmosphere to the top of each layer,
/// [layer + 1][nu] with a row of zeros where an atmosphere begins.
class OpticalDepths {
  public:
    OpticalDepths(const FineCrossSections& fine, const CrossSectionGrid& grid,
                  const TrainingPaths& training, std::size_t first, std::size_t count)
        : count_(count), layers_(training.layers.size()), depth_(layers_ * count) {
        std::vector<float> lnCross(count);
        for (std::size_t l = 0; l < layers_; ++l) {
            const TrainingLayer& layer = training.layers[l];
            float* depth = depth_.data() + l * count;
            for (std::size_t g = 0; g < lineGasCount; ++g) {
                const auto& points = fine.lnCrossSection[g];
                const double density_per_m3 = layer.air.density_per_m3(static_cast<Gas>(g));
                if (points.empty() || density_per_m3 <= 0.0)
                    continue;
                const GridStencil around = grid.stencil(static_cast<Gas>(g), layer.air);
                std::ranges::fill(lnCross, 0.0f);
                for (std::size_t k = 0; k < around.count; ++k) {
                    const float* values = points[around.points[k]].data() + first;
                    const float weight = around.weights[k];
                    for (std::size_t i = 0; i < count; ++i)
                        lnCross[i] += weight * values[i];
                }
                // Exponents are kept below 0 by a factor that is larger than any depth that matters
                // and leaves depths down to e^-67.
                const double lnColumn = std::log(density_per_m3 * 1e-4 * layer.thickness_m);
                constexpr float largest = 4.851652e8f, lnLargest = 20.0f;
                const auto shift = static_cast<float>(lnColumn) - lnLargest;
                for (std::size_t i = 0; i < count; ++i)
                    depth[i] += fastExp(std::min(lnCross[i] + shift, 0.0f)) * largest;
            }
        }
    }
    /// Of a path, at one point of the spectrum.
    float along(const TrainingPath& path, std::size_t i) const {
        float sum = 0.0f;
        for (std::size_t l = path.first; l < path.last; ++l)
            sum += depth_[l * count_ + i];
        return sum * static_cast<float>(path.factor);
    }
    const float* layer(std::size_t l) const { return depth_.data() + l * count_; }
    std::size_t count() const { return count_; }

  private:
    std::size_t count_, layers_;
    std::vector<float> depth_;
};

/// Transmittances of all paths over a bin: the mean, and the values at chosen points.
class BinTransmittance {
  public:
    BinTransmittance(const OpticalDepths& depths, const TrainingPaths& training)
        : depths_(depths), training_(training), mean_(training.paths.size()) {
        std::vector<float> depth(depths.count());
        for (std::size_t p = 0; p < training.paths.size(); ++p) {
            const TrainingPath& path = training.paths[p];
            std::ranges::fill(depth, 0.0f);
            for (std::size_t l = path.first; l < path.last; ++l) {
                const float* layer = depths.layer(l);
                for (std::size_t i = 0; i < depth.size(); ++i)
                    depth[i] += layer[i];
            }
            const auto factor = static_cast<float>(-path.factor);
            double sum = 0.0;
            for (std::size_t begin = 0; begin < depth.size(); begin += 64) {
                const std::size_t end = std::min(begin + 64, depth.size());
                float part = 0.0f;
                for (std::size_t i = begin; i < end; ++i)
                    part += fastExp(factor * depth[i]);
                sum += static_cast<double>(part);
            }
            mean_[p] = sum / static_cast<double>(depth.size());
        }
    }
    const std::vector<double>& mean() const { return mean_; }
    std::vector<float> at(std::size_t point) const {
        std::vector<float> column;
        for (const TrainingPath& path : training_.paths)
            column.push_back(std::exp(-depths_.along(path, point)));
        return column;
    }

  private:
    const OpticalDepths& depths_;
    const TrainingPaths& training_;
    std::vector<double> mean_;
};

/// Points spread over the distribution of the absorption, as seen in several layers.
std::vector<std::size_t> candidates(const OpticalDepths& depths, const TrainingPaths& training) {
    constexpr std::size_t quantiles = 16;
    std::vector<std::size_t> chosen, order(depths.count());
    std::iota(order.begin(), order.end(), 0u);
    for (const std::size_t l : training.sorting) {
        const float* layer = depths.layer(l);
        std::ranges::sort(order, {}, [&](std::size_t i) { return layer[i]; });
        for (std::size_t q = 0; q < quantiles; ++q)
            chosen.push_back(order[(2 * q + 1) * order.size() / (2 * quantiles)]);
        chosen.push_back(order.back());
        chosen.push_back(order[order.size() - 1 - order.size() / 100]);
    }
    std::ranges::sort(chosen);
    chosen.erase(std::ranges::unique(chosen).begin(), chosen.end());

    // No more than the selection can look through.
    constexpr std::size_t most = 120;
    if (chosen.size() > most) {
        std::vector<std::size_t> thinned;
        for (std::size_t i = 0; i < most; ++i)
            thinned.push_back(chosen[i * chosen.size() / most]);
        chosen = std::move(thinned);
    }
    return chosen;
}

/// Errors count more where little is absorbed, so that thin paths keep their relative accuracy.
std::vector<double> rowWeights(const std::vector<double>& mean) {
    std::vector<double> weights;
    for (const double transmittance : mean)
        weights.push_back(std::min(1.0 / (0.1 + 1.5 * (1.0 - transmittance)), 4.0));
    return weights;
}

/// True where a gas matters at a point of the spectrum on the longest path anybody looks along.
bool absorbs(Gas gas, const std::vector<std::vector<float>>& points, const CrossSectionGrid& grid,
             std::size_t i) {
    constexpr double length_cm = 3e7, leastDepth = 1e-3;
    constexpr std::array<double, lineGasCount> mostFraction = {0.04, 1e-3, 1e-5, 5e-7,
                                                               1e-6, 3e-6, 0.21};
    const double fraction = mostFraction[static_cast<std::size_t>(gas)];
    for (std::size_t p = 0; p < points.size(); ++p) {
        const std::size_t row = (p / grid.temperatures_K.size()) % grid.pressures_hPa.size();
        const double pressure_hPa = grid.pressures_hPa[row];
        const double here = gas == Gas::H2O && pressure_hPa < 150.0 ? 1e-4 : fraction;
        const double molecules_per_cm2 = here * pressure_hPa * 2.7e16 * length_cm;
        if (static_cast<double>(points[p][i]) > std::log(leastDepth / molecules_per_cm2))
            return true;
    }
    return false;
}

/// What one node absorbs, gas by gas.
void addBlocks(TrainedNodes& trained, std::uint32_t node, const FineCrossSections& fine,
               const CrossSectionGrid& grid, std::size_t point) {
    for (std::size_t g = 0; g < lineGasCount; ++g) {
        const auto& points = fine.lnCrossSection[g];
        if (points.empty() || !absorbs(static_cast<Gas>(g), points, grid, point))
            continue;
        GasTable::Block block{node, static_cast<Gas>(g), {}};
        for (const std::vector<float>& values : points)
            block.lnCrossSection.push_back(values[point]);
        trained.blocks.push_back(std::move(block));
    }
}

} // namespace

TrainedNodes trainNodes(const FineCrossSections& fine, const CrossSectionGrid& grid,
                        const TrainingPaths& training, double lower_per_cm, double upper_per_cm,
                        int baseWidth_per_cm, const std::array<NodeGoals, 3>& goals) {
    TrainedNodes trained;
    for (std::size_t r = 0; r < 3; ++r)
        trained.bins[r].resolution_per_cm = GasTable::resolutions_per_cm[r];

    std::vector<std::vector<float>> nodeColumns; // transmittances of all paths at each node
    std::vector<std::vector<double>> means;      // of each base bin
    std::vector<double> baseLower_per_cm;
    auto append = [&](std::size_t r, double lower, double width, const NodeSelection& selection,
                      const std::vector<std::uint32_t>& nodes) {
        BinSet& set = trained.bins[r];
        set.bins.push_back({lower, lower + width, static_cast<std::uint32_t>(set.nodes.size()),
                            static_cast<std::uint32_t>(selection.columns.size())});
        for (std::size_t i = 0; i < selection.columns.size(); ++i) {
            set.nodes.push_back(nodes[i]);
            set.weights.push_back(static_cast<float>(selection.weights[i]));
        }
        const auto cases = static_cast<double>(training.paths.size());
        trained.squaredError[r] += selection.rmsError * selection.rmsError * cases;
        trained.largestError[r] = std::max(trained.largestError[r], selection.largestError);
        trained.cases[r] += training.paths.size();
    };

    const auto baseIndex =
        static_cast<std::size_t>(std::ranges::find(GasTable::resolutions_per_cm, baseWidth_per_cm) -
                                 GasTable::resolutions_per_cm);
    const auto perBin =
        static_cast<std::size_t>(std::lround(baseWidth_per_cm / fine.grid.step_per_cm));
    for (double lower = lower_per_cm; lower < upper_per_cm - 0.5; lower += baseWidth_per_cm) {
        const auto first = static_cast<std::size_t>(
            std::lround((lower - fine.grid.first_per_cm) / fine.grid.step_per_cm + 0.5));
        const OpticalDepths depths(fine, grid, training, first, perBin);
        const BinTransmittance transmittance(depths, training);
        const std::vector<std::size_t> points = candidates(depths, training);

        TrainingMatrix matrix{
            training.paths.size(), {}, transmittance.mean(), rowWeights(transmittance.mean())};
        for (const std::size_t point : points) {
            const std::vector<float> column = transmittance.at(point);
            matrix.columns.insert(matrix.columns.end(), column.begin(), column.end());
        }
        const NodeSelection selection = selectNodes(matrix, goals[baseIndex]);

        std::vector<std::uint32_t> nodes;
        for (const std::size_t column : selection.columns) {
            const auto node = static_cast<std::uint32_t>(trained.wavenumbers_per_cm.size());
            const std::size_t point = points[column];
            nodes.push_back(node);
            trained.wavenumbers_per_cm.push_back(fine.grid.at(first + point));
            addBlocks(trained, node, fine, grid, first + point);
            const auto values = matrix.column(column);
            nodeColumns.emplace_back(values.begin(), values.end());
        }
        means.push_back(transmittance.mean());
        baseLower_per_cm.push_back(lower);
        for (std::size_t r = 0; r <= baseIndex;
             ++r) // finer bins than the data are those of the data
            append(r, lower, baseWidth_per_cm, selection, nodes);
    }

    // Wider bins choose among the nodes of the narrow ones that they hold.
    for (std::size_t r = baseIndex + 1; r < 3; ++r) {
        const int width_per_cm = GasTable::resolutions_per_cm[r];
        const auto binsInside = static_cast<std::size_t>(width_per_cm / baseWidth_per_cm);
        for (std::size_t base = 0; base < means.size(); base += binsInside) {
            const double lower = baseLower_per_cm[base];
            TrainingMatrix matrix{
                training.paths.size(), {}, std::vector<double>(training.paths.size()), {}};
            for (std::size_t i = base; i < base + binsInside; ++i)
                for (std::size_t p = 0; p < training.paths.size(); ++p)
                    matrix.target[p] += means[i][p] / static_cast<double>(binsInside);
            matrix.rowWeights = rowWeights(matrix.target);
            std::vector<std::uint32_t> inside;
            for (std::uint32_t node = 0; node < nodeColumns.size(); ++node)
                if (trained.wavenumbers_per_cm[node] >= lower &&
                    trained.wavenumbers_per_cm[node] < lower + width_per_cm) {
                    inside.push_back(node);
                    matrix.columns.insert(matrix.columns.end(), nodeColumns[node].begin(),
                                          nodeColumns[node].end());
                }
            const NodeSelection selection = selectNodes(matrix, goals[r]);
            std::vector<std::uint32_t> nodes;
            for (const std::size_t column : selection.columns)
                nodes.push_back(inside[column]);
            append(r, lower, width_per_cm, selection, nodes);
        }
    }
    return trained;
}

void measureNodes(TrainedNodes& nodes, const FineCrossSections& fine, const CrossSectionGrid& grid,
                  const TrainingPaths& training) {
    const auto placeOf = [&](double edge_per_cm) {
        return static_cast<std::size_t>(
            std::lround((edge_per_cm - fine.grid.first_per_cm) / fine.grid.step_per_cm + 0.5));
    };
    std::vector<std::vector<float>> columns(nodes.wavenumbers_per_cm.size());
    std::vector<std::vector<double>> means; // of the narrowest bins
    for (const SpectralBin& bin : nodes.bins.front().bins) {
        const std::size_t first = placeOf(bin.lower_per_cm);
        const OpticalDepths depths(fine, grid, training, first, placeOf(bin.upper_per_cm) - first);
        const BinTransmittance transmittance(depths, training);
        means.push_back(transmittance.mean());
        for (std::size_t node = 0; node < columns.size(); ++node) {
            const double at_per_cm = nodes.wavenumbers_per_cm[node];
            if (at_per_cm >= bin.lower_per_cm && at_per_cm < bin.upper_per_cm)
                columns[node] = transmittance.at(
                    static_cast<std::size_t>(
                        std::lround((at_per_cm - fine.grid.first_per_cm) / fine.grid.step_per_cm)) -
                    first);
        }
    }
    for (std::size_t r = 0; r < nodes.bins.size(); ++r) {
        const BinSet& set = nodes.bins[r];
        nodes.squaredError[r] = nodes.largestError[r] = 0.0;
        nodes.cases[r] = set.bins.size() * training.paths.size();
        for (const SpectralBin& bin : set.bins)
            for (std::size_t p = 0; p < training.paths.size(); ++p) {
                double error = 0.0;
                for (std::uint32_t i = bin.first; i < bin.first + bin.count; ++i)
                    error += static_cast<double>(set.weights[i]) *
                             static_cast<double>(columns[set.nodes[i]].at(p));
                double mean = 0.0, inside = 0.0;
                for (std::size_t b = 0; b < means.size(); ++b)
                    if (const SpectralBin& narrow = nodes.bins.front().bins[b];
                        narrow.lower_per_cm >= bin.lower_per_cm - 1e-6 &&
                        narrow.upper_per_cm <= bin.upper_per_cm + 1e-6) {
                        mean += means[b][p];
                        inside += 1.0;
                    }
                error -= mean / inside;
                nodes.squaredError[r] += error * error;
                nodes.largestError[r] = std::max(nodes.largestError[r], std::abs(error));
            }
    }
}

} // namespace irsg::lbl
