#include "irsg/scene/draw/LayerSort.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <numeric>
#include <vector>

#include "irsg/radiometry/ParallelFor.h"

namespace irsg {

namespace {

/// Pieces that samples are divided into, whatever the number of cores.
constexpr std::size_t parts = 16;

std::uint32_t bitsOf(float value) {
    return std::bit_cast<std::uint32_t>(value);
}

/// One fragment: whole vectors of four words.
void copyFragment(const float* from, std::size_t stride, float* to) {
    for (std::size_t i = 0; i < stride; i += 4)
        std::memcpy(to + i, from + i, 4 * sizeof(float));
}

/// The fragments of one sample, next to each other.
class FragmentsOfSample {
  public:
    FragmentsOfSample(float* first, std::size_t count, std::size_t stride)
        : first_(first), count_(count), stride_(stride) {}

    /// By depth, and by value where depths are equal.
    void sort(std::vector<float>& room) {
        // A handful in runs that are sorted already, as a rule.
        constexpr std::size_t few = 24;
        if (count_ > few)
            return sortMany(room);
        room.resize(stride_);
        for (std::size_t next = 1; next < count_; ++next) {
            if (!isBefore(at(next), at(next - 1)))
                continue;
            copyFragment(at(next), stride_, room.data());
            std::size_t place = next;
            for (; place > 0 && isBefore(room.data(), at(place - 1)); --place)
                copyFragment(at(place - 1), stride_, at(place));
            copyFragment(room.data(), stride_, at(place));
        }
    }

  private:
    float* at(std::size_t i) const { return first_ + i * stride_; }

    bool isBefore(const float* a, const float* b) const {
        if (a[1] != b[1])
            return a[1] > b[1];
        return std::lexicographical_compare(a + 2, a + stride_, b + 2, b + stride_,
                                            [](float x, float y) { return bitsOf(x) < bitsOf(y); });
    }

    void sortMany(std::vector<float>& room) {
        std::vector<std::size_t> order(count_);
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::ranges::sort(order,
                          [&](std::size_t a, std::size_t b) { return isBefore(at(a), at(b)); });
        room.assign(first_, at(count_));
        for (std::size_t i = 0; i < count_; ++i)
            copyFragment(room.data() + order[i] * stride_, stride_, at(i));
    }

    float* first_;
    std::size_t count_, stride_;
};

} // namespace

void gatherFragments(std::span<const float> list, FactorSamples& samples) {
    const std::size_t stride = samples.wordsPerFragment;
    samples.words.resize(list.size());
    samples.lowest = samples.highest = 0;
    if (list.empty())
        return;
    std::uint32_t lowest = bitsOf(list[0]), highest = lowest;
    for (std::size_t i = 0; i < list.size(); i += stride) {
        const std::uint32_t sample = bitsOf(list[i]);
        lowest = std::min(lowest, sample);
        highest = std::max(highest, sample);
    }
    samples.lowest = lowest;
    samples.highest = highest + std::size_t{1};

    // Where samples begin stands a place further up until their fragments have been put there.
    samples.ends.assign(samples.highest - samples.lowest + 2, 0);
    std::uint32_t* ends = samples.ends.data();
    for (std::size_t i = 0; i < list.size(); i += stride)
        ++ends[bitsOf(list[i]) - lowest + 2];
    std::partial_sum(samples.ends.begin(), samples.ends.end(), samples.ends.begin());
    for (std::size_t i = 0; i < list.size(); i += stride)
        copyFragment(&list[i], stride,
                     &samples.words[ends[bitsOf(list[i]) - lowest + 1]++ * stride]);
}

void sortLayers(FactorSamples& samples, int maximumLayers) {
    samples.maximumLayers = static_cast<std::uint32_t>(maximumLayers);
    std::array<int, parts> leftOver{};
    parallelFor(parts, [&](std::size_t part) {
        const std::size_t count = samples.highest - samples.lowest;
        std::vector<float> own;
        for (std::size_t i = beginOfPart(part, parts, count);
             i < beginOfPart(part + 1, parts, count); ++i) {
            const std::uint32_t begin = samples.ends[i], end = samples.ends[i + 1];
            if (end - begin > samples.maximumLayers)
                ++leftOver[part];
            if (end - begin > 1)
                FragmentsOfSample(&samples.words[begin * samples.wordsPerFragment], end - begin,
                                  samples.wordsPerFragment)
                    .sort(own);
        }
    });
    samples.layersLeftOver = std::accumulate(leftOver.begin(), leftOver.end(), 0);
}

} // namespace irsg
