#include "irsg/render/sampling/LayerSort.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <numeric>
#include <type_traits>
#include <vector>

#include "irsg/core/ParallelFor.h"

namespace irsg {

namespace {

/// Pieces that samples are divided into, whatever the number of cores.
constexpr std::size_t parts = 16;

std::uint32_t bitsOf(float value) {
    return std::bit_cast<std::uint32_t>(value);
}

/// Calls work(stride), with a stride that is known when this is compiled for the usual one.
template <typename Work>
void withStride(std::size_t stride, const Work& work) {
    constexpr std::size_t usual = 8; // up to four factors
    if (stride == usual)
        work(std::integral_constant<std::size_t, usual>());
    else
        work(stride);
}

/// One fragment: whole vectors of four words.
template <typename Stride>
[[gnu::always_inline]] inline void copyFragment(const float* from, Stride stride, float* to) {
    for (std::size_t i = 0; i < stride; i += 4)
        std::memcpy(to + i, from + i, 4 * sizeof(float));
}

/// The fragments of one sample, next to each other.
template <typename Stride>
class FragmentsOfSample {
  public:
    FragmentsOfSample(float* first, std::size_t count, Stride stride)
        : first_(first), count_(count), stride_(stride) {}

    /// By depth, and by value where depths are equal.
    void sort(std::vector<float>& room) {
        // A handful in runs that are sorted already, as a rule.
        constexpr std::size_t few = 24;
        if (count_ > few)
            return sortMany(room);
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
    std::size_t count_;
    [[no_unique_address]] Stride stride_;
};

} // namespace

void gatherFragments(std::span<const float> list, GeometrySamples& samples) {
    samples.words.resize(list.size());
    samples.lowest = samples.highest = 0;
    if (list.empty())
        return;
    // Where samples begin stands a place further up until their fragments have been put there.
    samples.ends.assign(samples.size() + 2, 0);
    std::uint32_t* const ends = samples.ends.data();
    withStride(samples.wordsPerFragment, [&](auto stride) {
        std::uint32_t lowest = bitsOf(list[0]), highest = lowest;
        for (std::size_t i = 0; i < list.size(); i += stride) {
            const std::uint32_t sample = bitsOf(list[i]);
            lowest = std::min(lowest, sample);
            highest = std::max(highest, sample);
            ++ends[sample + 2];
        }
        samples.lowest = lowest;
        samples.highest = highest + std::size_t{1};
        std::partial_sum(ends + lowest + 2, ends + highest + 3, ends + lowest + 2);
        float* const words = samples.words.data();
        for (std::size_t i = 0; i < list.size(); i += stride)
            copyFragment(&list[i], stride, words + ends[bitsOf(list[i]) + 1]++ * stride);
    });
}

void sortLayers(GeometrySamples& samples, int maximumLayers) {
    samples.maximumLayers = static_cast<std::uint32_t>(maximumLayers);
    std::array<int, parts> leftOver{};
    parallelFor(parts, [&](std::size_t part) {
        const std::size_t count = samples.highest - samples.lowest;
        const std::uint32_t* const ends = samples.ends.data() + samples.lowest;
        std::vector<float> own(samples.wordsPerFragment);
        withStride(samples.wordsPerFragment, [&](auto stride) {
            for (std::size_t i = beginOfPart(part, parts, count);
                 i < beginOfPart(part + 1, parts, count); ++i) {
                const std::uint32_t begin = ends[i], end = ends[i + 1];
                if (end - begin > samples.maximumLayers)
                    ++leftOver[part];
                if (end - begin > 1)
                    FragmentsOfSample(&samples.words[begin * stride], end - begin, stride)
                        .sort(own);
            }
        });
    });
    samples.layersLeftOver = std::accumulate(leftOver.begin(), leftOver.end(), 0);
}

} // namespace irsg
