#include "irsg/scene/draw/LayerSort.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace irsg {

namespace {

float asFloat(std::uint32_t bits) {
    return std::bit_cast<float>(bits);
}

/// Fragments of every sample next to each other, near to far. Only samples from `lowest` to before
/// `highest` have any; of those, sample i owns fragments[first[i - lowest]] to before
/// fragments[first[i - lowest + 1]], each the index of a fragment of `wordsPerFragment` words.
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
    for (std::size_t i = 0; i < samples; ++i)
        sorted.first[i + 1] += sorted.first[i];
    sorted.fragments.resize(count);
    std::vector<std::uint32_t> next(sorted.first.begin(), sorted.first.end() - 1);
    for (std::size_t i = 0; i < count; ++i)
        sorted.fragments[next[sampleOf(i)]++] = static_cast<std::uint32_t>(i);

    // A handful of layers each: by depth, and by value where depths are equal. Depths are positive
    // floats, whose bits order as they do.
    for (std::size_t i = 0; i < samples; ++i) {
        auto begin = sorted.fragments.begin() + sorted.first[i];
        auto end = sorted.fragments.begin() + sorted.first[i + 1];
        if (end - begin < 2)
            continue;
        std::sort(begin, end, [&](std::uint32_t a, std::uint32_t b) {
            const std::uint32_t* wa = &words[a * wordsPerFragment];
            const std::uint32_t* wb = &words[b * wordsPerFragment];
            if (wa[1] != wb[1])
                return wa[1] > wb[1];
            return std::lexicographical_compare(wa + 2, wa + wordsPerFragment, wb + 2,
                                                wb + wordsPerFragment);
        });
    }
    return sorted;
}

} // namespace

int layUnderTransparent(const std::vector<std::uint32_t>& words, int maximumLayers,
                        std::vector<float>& planes) {
    if (words.empty())
        return 0;
    constexpr std::size_t wordsPerFragment = 4;
    const Sorted sorted = sortFragments(words, wordsPerFragment);

    int leftOver = 0;
    for (std::size_t i = sorted.lowest; i < sorted.highest; ++i) {
        auto [begin, end] = sorted.of(i);
        if (begin == end)
            continue;
        if (end - begin > static_cast<std::uint32_t>(maximumLayers)) {
            end = begin + static_cast<std::uint32_t>(maximumLayers);
            ++leftOver;
        }
        double radiance = 0.0, transmitted = 1.0;
        for (std::uint32_t k = begin; k < end; ++k) {
            const std::uint32_t* fragment = &words[sorted.fragments[k] * wordsPerFragment];
            radiance += transmitted * static_cast<double>(asFloat(fragment[2]));
            transmitted *= 1.0 - static_cast<double>(asFloat(fragment[3]));
        }
        radiance += transmitted * static_cast<double>(planes[2 * i]);
        transmitted *= 1.0 - static_cast<double>(planes[2 * i + 1]);
        planes[2 * i] = static_cast<float>(radiance);
        planes[2 * i + 1] = static_cast<float>(1.0 - transmitted);
    }
    return leftOver;
}

void gatherFactorLayers(const std::vector<std::uint32_t>& words, const std::vector<float>& opaque,
                        const std::vector<float>& opaqueDistance_m, bool fluxes, int maximumLayers,
                        FactorSamples& samples) {
    const auto ground = [fluxes](float sky) { return fluxes ? 1.0f - sky : 0.0f; };
    constexpr std::size_t wordsPerFragment = 8;
    const std::size_t count = opaque.size() / 4;
    const Sorted sorted = sortFragments(words, wordsPerFragment);

    samples.layersLeftOver = 0;
    samples.layers.clear();
    samples.first.assign(count + 1, 0);
    for (std::size_t i = 0; i < count; ++i) {
        samples.first[i] = static_cast<std::uint32_t>(samples.layers.size());
        auto [begin, end] = sorted.of(i);
        if (end - begin > static_cast<std::uint32_t>(maximumLayers)) {
            end = begin + static_cast<std::uint32_t>(maximumLayers);
            ++samples.layersLeftOver;
        }
        for (std::uint32_t k = begin; k < end; ++k) {
            const std::uint32_t* w = &words[sorted.fragments[k] * wordsPerFragment];
            samples.layers.push_back({static_cast<int>(asFloat(w[2])) - 1, asFloat(w[4]),
                                      ground(asFloat(w[5])), asFloat(w[5]), asFloat(w[6]),
                                      asFloat(w[3])});
        }
        const float* o = &opaque[4 * i];
        if (o[0] > 0.0f)
            samples.layers.push_back({static_cast<int>(o[0]) - 1, o[1], ground(o[2]), o[2], o[3],
                                      opaqueDistance_m.empty() ? 0.0f : opaqueDistance_m[i]});
    }
    samples.first[count] = static_cast<std::uint32_t>(samples.layers.size());
}

} // namespace irsg
