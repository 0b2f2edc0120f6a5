#include "irsg/scene/draw/LayerSort.h"

#include <algorithm>
#include <array>
#include <bit>
#include <numeric>
#include <utility>

#include "irsg/radiometry/ParallelFor.h"

namespace irsg {

namespace {

/// Pieces that samples are divided into, whatever the number of cores.
constexpr std::size_t parts = 16;

float asFloat(std::uint32_t bits) {
    return std::bit_cast<float>(bits);
}

/// Fragments of every sample next to each other, near to far. Only samples from `lowest` to before
/// `highest` have any; of those, sample i owns fragments[first[i - lowest]] to before
/// fragments[first[i - lowest + 1]], each the number of a fragment.
struct Sorted {
    std::size_t lowest = 0, highest = 0;
    std::vector<std::uint32_t> first;
    std::vector<std::uint32_t> fragments;

    std::pair<std::uint32_t, std::uint32_t> of(std::size_t sample) const {
        if (sample < lowest || sample >= highest)
            return {0, 0};
        return {first[sample - lowest], first[sample - lowest + 1]};
    }
};

Sorted sortFragments(const std::vector<std::uint32_t>& words, std::size_t wordsPerFragment) {
    const std::size_t count = words.size() / wordsPerFragment;
    Sorted sorted;
    if (count == 0)
        return sorted;
    sorted.lowest = words[0];
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t sample = words[i * wordsPerFragment];
        sorted.lowest = std::min(sorted.lowest, sample);
        sorted.highest = std::max(sorted.highest, sample + 1);
    }
    const std::size_t samples = sorted.highest - sorted.lowest;

    // Counting sort by sample.
    auto sampleOf = [&](std::size_t i) { return words[i * wordsPerFragment] - sorted.lowest; };
    sorted.first.assign(samples + 1, 0);
    for (std::size_t i = 0; i < count; ++i)
        ++sorted.first[sampleOf(i) + 1];
    std::partial_sum(sorted.first.begin(), sorted.first.end(), sorted.first.begin());
    sorted.fragments.resize(count);
    std::vector<std::uint32_t> next(sorted.first.begin(), sorted.first.end() - 1);
    for (std::size_t i = 0; i < count; ++i)
        sorted.fragments[next[sampleOf(i)]++] = static_cast<std::uint32_t>(i);

    // A handful of layers each: by depth, and by value where depths are equal. Depths are positive
    // floats, whose bits order as they do.
    const auto isBefore = [&](std::uint32_t a, std::uint32_t b) {
        const std::uint32_t* wa = &words[a * wordsPerFragment];
        const std::uint32_t* wb = &words[b * wordsPerFragment];
        if (wa[1] != wb[1])
            return wa[1] > wb[1];
        return std::lexicographical_compare(wa + 2, wa + wordsPerFragment, wb + 2,
                                            wb + wordsPerFragment);
    };
    parallelFor(parts, [&](std::size_t part) {
        for (std::size_t i = beginOfPart(part, parts, samples);
             i < beginOfPart(part + 1, parts, samples); ++i)
            if (sorted.first[i + 1] - sorted.first[i] > 1)
                std::sort(sorted.fragments.begin() + sorted.first[i],
                          sorted.fragments.begin() + sorted.first[i + 1], isBefore);
    });
    return sorted;
}

/// Layers of a part of the samples, numbered from 0.
struct Part {
    std::size_t begin = 0, end = 0;
    std::size_t layers = 0;
    int leftOver = 0;
};

} // namespace

void gatherLayers(const DrawnLayers& drawn, int maximumLayers, FactorSamples& samples) {
    const std::size_t count = drawn.opaque.size() / 4, factors = drawn.factorCount;
    samples.width = drawn.width;
    samples.height = drawn.height;
    samples.factorCount = factors;
    const Sorted sorted = sortFragments(drawn.words, drawn.wordsPerFragment);
    const auto kept = static_cast<std::uint32_t>(maximumLayers);

    // How many layers each sample has, then where they begin.
    samples.first.assign(count + 1, 0);
    std::array<Part, parts> all;
    parallelFor(parts, [&](std::size_t p) {
        Part& part = all[p];
        part.begin = beginOfPart(p, parts, count);
        part.end = beginOfPart(p + 1, parts, count);
        for (std::size_t i = part.begin; i < part.end; ++i) {
            const auto [begin, end] = sorted.of(i);
            part.leftOver += end - begin > kept ? 1 : 0;
            samples.first[i] = static_cast<std::uint32_t>(part.layers);
            part.layers += std::min(end - begin, kept) + (drawn.opaque[4 * i] > 0.0f ? 1u : 0u);
        }
    });
    std::size_t layers = 0;
    samples.layersLeftOver = 0;
    std::array<std::size_t, parts> firstOf{};
    for (std::size_t p = 0; p < parts; ++p) {
        firstOf[p] = layers;
        layers += all[p].layers;
        samples.layersLeftOver += all[p].leftOver;
    }
    samples.first[count] = static_cast<std::uint32_t>(layers);
    samples.rows.resize(layers);
    samples.distances_m.resize(layers);
    samples.factors.resize(layers * factors);

    parallelFor(parts, [&](std::size_t p) {
        for (std::size_t i = all[p].begin; i < all[p].end; ++i) {
            auto layer = samples.first[i] += static_cast<std::uint32_t>(firstOf[p]);
            auto [begin, end] = sorted.of(i);
            end = std::min(end, begin + kept);
            for (std::uint32_t k = begin; k < end; ++k, ++layer) {
                const std::uint32_t* w = &drawn.words[sorted.fragments[k] * drawn.wordsPerFragment];
                samples.rows[layer] = static_cast<std::int32_t>(asFloat(w[2])) - 1;
                samples.distances_m[layer] = asFloat(w[3]);
                for (std::size_t f = 0; f < factors; ++f)
                    samples.factors[layer * factors + f] = asFloat(w[4 + f]);
            }
            const float* o = &drawn.opaque[4 * i];
            if (!(o[0] > 0.0f))
                continue;
            samples.rows[layer] = static_cast<std::int32_t>(o[0]) - 1;
            samples.distances_m[layer] = drawn.distances_m.empty() ? 0.0f : drawn.distances_m[i];
            for (std::size_t f = 0; f < factors; ++f)
                samples.factors[layer * factors + f] =
                    f < 3 ? o[1 + f] : drawn.moreFactors[4 * i + f - 3];
        }
    });
}

} // namespace irsg
