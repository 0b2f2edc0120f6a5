#include "irsg/radiance/exchange/LightIntegrals.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <map>

#include "irsg/core/ParallelFor.h"
#include "irsg/radiometry/DotProducts.h"

namespace irsg {

namespace {

/// Kinds that share what is read of the sources.
constexpr std::size_t kindsTogether = mostTogether / 2;
/// Nodes of a block: so few that what kinds share and what is their own stay in the first cache
/// beside those of another thread of the core.
constexpr std::size_t nodesTogether = 64;

std::vector<double> between(const std::vector<std::vector<double>>& sums,
                            const SliceBetween& about) {
    std::vector<double> values = sums[static_cast<std::size_t>(about.below)];
    const std::vector<double>& above = sums[static_cast<std::size_t>(about.above)];
    for (std::size_t i = 0; about.part > 0.0 && i < values.size(); ++i)
        values[i] = std::lerp(values[i], above[i], about.part);
    return values;
}

} // namespace

std::vector<double> LightIntegrals::of(const SurfaceStackId& kind, std::size_t output) const {
    const Taken taken = takenFor(std::span(&kind, 1), output);
    const std::vector<std::vector<double>> sums = sumsOf(taken.kinds, output);
    return between(sums, taken.about.front());
}

std::vector<std::vector<std::vector<double>>>
LightIntegrals::ofAll(const std::vector<SurfaceStackId>& kinds) const {
    const std::size_t outputs = radiometry_.outputs().size();
    std::vector<Taken> taken;
    std::vector<std::vector<std::vector<double>>> sums(outputs); // by output and what it takes
    struct Task {
        std::size_t output, first, count;
    };
    std::vector<Task> tasks;
    for (std::size_t output = 0; output < outputs; ++output) {
        const std::size_t all = taken.emplace_back(takenFor(kinds, output)).kinds.size();
        sums[output].resize(all);
        for (std::size_t first = 0; first < all; first += kindsTogether)
            tasks.push_back({output, first, std::min(kindsTogether, all - first)});
    }
    parallelFor(tasks.size(), [&](std::size_t i) {
        const auto& [output, first, count] = tasks[i];
        std::ranges::move(sumsOf(std::span(taken[output].kinds).subspan(first, count), output),
                          sums[output].begin() + static_cast<std::ptrdiff_t>(first));
    });
    std::vector<std::vector<std::vector<double>>> found(kinds.size());
    parallelFor(kinds.size(), [&](std::size_t k) {
        for (std::size_t output = 0; output < outputs; ++output)
            found[k].push_back(between(sums[output], taken[output].about[k]));
    });
    return found;
}

LightIntegrals::Taken LightIntegrals::takenFor(std::span<const SurfaceStackId> kinds,
                                               std::size_t output) const {
    Taken taken;
    std::map<std::pair<int, int>, int> places; // by front and row
    for (const SurfaceStackId& kind : kinds) {
        const SliceBetween rows = radiometry_.rowsAbout(kind.row, output);
        const auto placeOf = [&](int row) {
            const auto [place, isNew] =
                places.try_emplace({kind.stack, row}, static_cast<int>(taken.kinds.size()));
            if (isNew)
                taken.kinds.push_back({kind.stack, row});
            return place->second;
        };
        const int below = placeOf(rows.below);
        taken.about.push_back({below, placeOf(rows.above), rows.part});
    }
    return taken;
}

const double* LightIntegrals::lightOn(const SurfaceStackId& kind, int term) const {
    const SurfaceRows& rows = radiometry_.rows();
    const AtmosphereSamples& air = radiometry_.air(rows.first(rows.renderedOf(kind.row)));
    return air.light[static_cast<std::size_t>(term)]->data();
}

std::vector<std::vector<double>> LightIntegrals::sumsOf(std::span<const SurfaceStackId> kinds,
                                                        std::size_t output) const {
    const auto& [begin, end] = radiometry_.outputs()[output];
    const std::size_t columns = sources_W_m2_um_.size();
    std::vector<std::vector<double>> all(kinds.size(), std::vector<double>(width(), 0.0));
    // What is to be summed with all kinds: the sources, and what sky and ground give where that is
    // the same for all of them.
    std::vector<const double*> others;
    others.reserve(columns);
    for (const std::vector<double>& source : sources_W_m2_um_)
        others.push_back(source.data());
    std::vector<std::pair<int, std::size_t>> apart;
    std::vector<std::size_t> together;
    for (const auto& [term, place] :
         {std::pair{skyTerm_, std::size_t{0}}, std::pair{groundTerm_, std::size_t{1}}}) {
        if (term < 0)
            continue;
        const double* const first = lightOn(kinds.front(), term);
        if (std::ranges::any_of(kinds, [&, term = term](const SurfaceStackId& kind) {
                return lightOn(kind, term) != first;
            })) {
            apart.emplace_back(term, place);
            continue;
        }
        others.push_back(first);
        together.push_back(place);
    }

    using Block = std::array<double, nodesTogether>;
    // Of each kind what counts between two knots for the first of them, and for the second.
    std::array<Block, 2 * kindsTogether> parts;
    Block passed, reflected; // by what lies before a kind; and by its surface
    const std::size_t wide = std::bit_ceil(2 * kinds.size());
    std::vector<double> products(wide * others.size());
    for (std::size_t first = begin; first < end; first += nodesTogether) {
        const std::size_t count = std::min(nodesTogether, end - first);
        for (std::size_t k = 0; k < kinds.size(); ++k) {
            const bool isBehindSame = k > 0 && kinds[k].stack == kinds[k - 1].stack;
            if (!isBehindSame)
                radiometry_.fillPassed(occluderStacks_.materials(kinds[k].stack), first, count,
                                       passed.data(), true);
            const SurfaceSpectra& surface = radiometry_.surface(kinds[k].row);
            if (!isBehindSame || &surface != &radiometry_.surface(kinds[k - 1].row))
                fillProducts(passed.data(), surface.reflectance.data() + first, count,
                             reflected.data());
            double* const below = parts[2 * k].data();
            double* const above = parts[2 * k + 1].data();
            splitProducts(reflected.data(),
                          radiometry_.air(kinds[k].row).transmittance->data() + first,
                          &knots_.parts[first], count, below, above);
            for (const auto& [term, place] : apart) {
                const double* const light = lightOn(kinds[k], term) + first;
                all[k][place] -= dotProduct(below, light, count) + dotProduct(above, light, count);
            }
        }
        // Nodes that follow each other between the same knots share their sums.
        for (std::size_t from = 0, to = 0; from < count; from = to) {
            const LightKnots::Between& at = knots_.between[first + from];
            while (to < count && knots_.between[first + to] == at)
                ++to;
            std::array<const double*, 2 * kindsTogether> vectors{};
            for (std::size_t v = 0; v < wide; ++v)
                vectors[v] = &parts[v < 2 * kinds.size() ? v : 0][from];
            dotProducts({vectors.data(), wide}, others, first + from, to - from, products.data());
            for (std::size_t k = 0; k < kinds.size(); ++k) {
                double* const low = &all[k][2 + at.low * columns];
                double* const high = &all[k][2 + at.high * columns];
                for (std::size_t c = 0; c < columns; ++c) {
                    low[c] += products[c * wide + 2 * k];
                    high[c] += products[c * wide + 2 * k + 1];
                }
                for (std::size_t i = 0; i < together.size(); ++i) {
                    const double* const own = &products[(columns + i) * wide + 2 * k];
                    all[k][together[i]] -= own[0] + own[1];
                }
            }
        }
    }
    return all;
}

} // namespace irsg
