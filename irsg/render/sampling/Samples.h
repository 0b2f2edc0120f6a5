#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace irsg {

/// Drawn factors that a shader has room for.
inline constexpr std::size_t mostFactors = 7;
/// Of them, components of a normal, behind all others.
inline constexpr std::size_t normalFactors = 3;

/// Which of the numbers of a lobe a layer's factor is multiplied with.
enum class LobeRole { emission, flux, sun };

/// Which part of a lobe lies at which place of a SpecularEnvironmentGrid, at nodes between which it
/// is linear (LobeQuadratureTable). It grows while samples refer to it.
class SpecularEnvironmentTable {
  public:
    std::size_t components = 0, places = 0;
    std::vector<float> shares;       ///< by node, component and place; a component's add up to 1
    std::vector<std::uint32_t> keys; ///< of nodes, whose order is that in which they were asked for

    std::size_t valuesOfNode() const { return components * places; }
    const float* of(std::uint32_t node) const { return &shares[node * valuesOfNode()]; }
};

/// Room for so many samples is kept from one picture to the next.
inline constexpr std::size_t mostSamplesCached = 1'000'000;

/// One window of samples, bottom row first.
struct RadianceSamples {
    int width = 0, height = 0;
    std::vector<float> planes; ///< premultiplied radiance and opacity, interleaved
    int layersLeftOver = 0;    ///< samples with more layers than the scene allows
};

/// One window of samples, bottom row first, each with the surfaces that it meets and what geometry
/// makes of them: factors, which know no wavelength (surface.frag.glsl, LayerSort).
struct GeometrySamples {
    int width = 0, height = 0;
    std::size_t factorCount = 0; ///< drawn factors of a layer

    /// (row + 1, first three factors) of the opaque surface of each sample, row + 1 = 0 for none.
    std::vector<float> opaque;
    std::vector<float> moreFactors; ///< the next four of each sample, or empty
    std::vector<float> distances_m; ///< of the opaque surface of each sample, or empty
    /// Fragments of transparent surfaces: (the bits of the sample's number, depth, row + 1,
    /// distance) and the factors, padded to whole vectors of four words.
    std::vector<float> words;
    std::size_t wordsPerFragment = 8; ///< 8 for up to four factors

    /// Those of every sample stand next to each other; once sorted, near to far. Only samples from
    /// `lowest` to before `highest` have any; such a sample i owns those from ends[i] to before
    /// ends[i + 1], of which the first `maximumLayers` count.
    std::size_t lowest = 0, highest = 0;
    std::vector<std::uint32_t> ends;
    std::uint32_t maximumLayers = 0;
    int layersLeftOver = 0; ///< samples that have more

    /// Rows of gases that the eye is in.
    std::vector<int> gasesAboutEye;

    /// Light that a layer gets through transparent surfaces between it and the sun: what it adds to
    /// one of the layer's factors, times what those materials let through.
    struct Through {
        std::uint32_t sample = 0;
        std::uint32_t layer = 0; ///< number among those of the sample, front to back
        std::uint32_t set = 0;   ///< of `throughSets`
        std::uint32_t factor = 0;
        float value = 0.0f;
    };
    std::vector<Through> through; ///< by sample and layer, ascending
    /// Sorted sets of transparent materials: (entity, material index), each as often as it occurs.
    std::vector<std::vector<std::pair<int, int>>> throughSets;
    /// Part of the sun that the nearest layer of each sample sees, or empty where that was not
    /// asked for; what is transparent hides nothing of it.
    std::vector<float> sunVisibility;

    /// Part of its hemisphere in which the nearest layer of each sample sees sky and ground, or
    /// empty likewise.
    std::vector<float> skyVisibility;

    /// Where on its surface a layer is, for the light that surfaces send each other: a place as
    /// LightExchange names it, and the weights of the second and third corner there.
    struct Place {
        static constexpr std::uint32_t none = 0xffffffffu;
        std::uint32_t cell = none;
        float u = 0.0f, v = 0.0f;
    };
    std::vector<Place> opaquePlaces;   ///< by sample, or empty
    std::vector<Place> fragmentPlaces; ///< by fragment, or empty

    /// What a layer of a directional surface sends beside what a Lambertian one of equal
    /// hemispherical reflectance would, in one row of SurfaceRows that is drawn nowhere: its
    /// factors are the layer's times these numbers, which may be negative (LobeQuadrature).
    struct Lobe {
        std::uint32_t sample = 0;
        std::uint32_t layer = 0; ///< number among those of the sample, front to back
        int row = 0;
        float emission = 0.0f, flux = 0.0f, sun = 0.0f;
    };
    std::vector<Lobe> lobes;         ///< by sample and layer, ascending
    std::vector<LobeRole> lobeRoles; ///< by factor

    /// What lobes of a layer mirror of the air: each component's scale times the mean of three
    /// nodes of a table is the coverage of a row of SurfaceRows for each place, behind each other
    /// from `row` on, first by component.
    struct Specular {
        std::uint32_t sample = 0;
        std::uint32_t layer = 0; ///< number among those of the sample, front to back
        int row = 0;
        std::uint32_t table = 0;  ///< of `specularTables`
        std::uint32_t scales = 0; ///< the first of them in `specularScales`
        std::array<std::uint32_t, 3> nodes{};
        std::array<float, 3> weights{};
    };
    std::vector<Specular> speculars; ///< by sample and layer, ascending
    std::vector<float> specularScales;
    std::vector<std::shared_ptr<const SpecularEnvironmentTable>> specularTables;

    /// What lobes of a layer reflect of another surface: the place where they meet it, as
    /// LightExchange names it, with a weight, in a row of SurfaceRows that is drawn nowhere. Of the
    /// atmosphere behind panes and further mirrors there is no place.
    struct Reflected {
        std::uint32_t sample = 0;
        std::uint32_t layer = 0; ///< number among those of the sample, front to back
        int row = 0;
        float weight = 0.0f;
        Place from;
        std::uint32_t set = 0; ///< of `reflectedSets`
    };
    std::vector<Reflected> reflected; ///< by sample and layer, ascending
    /// What this light has passed on its way to the layer, sorted: panes, and components of other
    /// mirrors (mirrorMaterial). The first is nothing.
    std::vector<std::vector<std::pair<int, int>>> reflectedSets;

    /// Where one of two by two samples stands for all (joinSmoothSamples): 0 for a sample that is
    /// alone; 1 + its number in the group for the one that stands for it: upper left, upper right,
    /// lower left, lower right; for the others, which are empty, `ofAnother` + 4 times the number
    /// of that one + their own. Or empty: all are alone.
    std::vector<std::uint8_t> groups;
    static constexpr std::uint8_t ofAnother = 16;
    static constexpr std::size_t samplesOfGroup = 4;
    bool standsForGroup(std::size_t sample) const {
        return !groups.empty() && groups[sample] != 0 && groups[sample] < ofAnother;
    }
    bool isOfAnother(std::size_t sample) const {
        return !groups.empty() && groups[sample] >= ofAnother;
    }
    /// The samples that one stands for, in that order; `stride` from one row to the next.
    std::array<std::size_t, samplesOfGroup> groupOf(std::size_t sample, std::size_t stride) const {
        return groupFrom(sample, static_cast<std::size_t>(groups[sample]) - 1, stride);
    }
    /// The sample that stands for one, which may be itself.
    std::size_t standingFor(std::size_t sample, std::size_t stride) const {
        if (!isOfAnother(sample))
            return sample;
        const auto numbers = static_cast<std::size_t>(groups[sample] - ofAnother);
        return groupFrom(sample, numbers % 4, stride)[numbers / 4];
    }

    /// What a sample counts beside others of its block for what gas emits (shareOutGas), or empty:
    /// all count 1.
    std::vector<float> gasShares;
    double gasShare(std::size_t sample) const {
        return gasShares.empty() ? 1.0 : static_cast<double>(gasShares[sample]);
    }

    /// Nothing is known of shadows, of light between surfaces and of lobes.
    void forgetLight() {
        groups.clear();
        gasShares.clear();
        through.clear();
        lobes.clear();
        speculars.clear();
        reflected.clear();
        reflectedSets.clear();
        specularScales.clear();
        specularTables.clear();
        sunVisibility.clear();
        skyVisibility.clear();
        opaquePlaces.clear();
        fragmentPlaces.clear();
    }

    std::size_t size() const { return opaque.size() / 4; }
    bool isOpaque(std::size_t sample) const { return opaque[4 * sample] > 0.0f; }
    /// A factor of the opaque surface of a sample.
    float& opaqueFactor(std::size_t sample, std::size_t f) {
        return f < 3 ? opaque[4 * sample + 1 + f] : moreFactors[4 * sample + f - 3];
    }
    float opaqueFactor(std::size_t sample, std::size_t f) const {
        return f < 3 ? opaque[4 * sample + 1 + f] : moreFactors[4 * sample + f - 3];
    }
    bool isListed(std::size_t sample) const {
        return sample >= lowest && sample < highest && ends[sample] != ends[sample + 1];
    }
    /// The fragments of a sample that count, near to far: the first and the one behind the last.
    std::pair<std::size_t, std::size_t> fragmentsOf(std::size_t sample) const {
        if (sample < lowest || sample >= highest)
            return {0, 0};
        const std::uint32_t begin = ends[sample];
        return {begin, std::min(ends[sample + 1], begin + maximumLayers)};
    }
    /// Whether it has more layers than count.
    bool isLeftOver(std::size_t sample) const {
        return isListed(sample) && fragmentsOf(sample).second < ends[sample + 1];
    }
    bool isEmpty(std::size_t sample) const {
        return (!isOpaque(sample) && !isListed(sample)) || isOfAnother(sample);
    }

    struct Layer {
        int row = 0; ///< of the drawing
        /// 0 for an opaque surface where distances were not asked for.
        float distance_m = 0.0f;
        std::span<const float> factors;
        /// 0 for light alone, which a layer that was visited already gets through something.
        float coverage = 1.0f;
        const Place* place = nullptr; ///< null where light between surfaces is no matter
        /// Coverage is then what the layer makes of diffuse light, and its row sends no more.
        bool isLobe = false;
    };
    /// Calls visit(layer) for the layers of a sample, front to back and the opaque one last.
    template <typename Visit>
    [[gnu::always_inline]] void forEachLayer(std::size_t sample, const Visit& visit) const {
        const auto [begin, end] = fragmentsOf(sample);
        for (std::size_t i = begin; i < end; ++i)
            visit(fragment(i));
        if (!isOpaque(sample))
            return;
        const float* first = &opaque[4 * sample];
        Layer layer{static_cast<int>(first[0]) - 1,
                    distances_m.empty() ? 0.0f : distances_m[sample],
                    {first + 1, factorCount},
                    1.0f,
                    opaquePlaces.empty() ? nullptr : &opaquePlaces[sample],
                    false};
        if (factorCount <= 3)
            return visit(layer);
        std::array<float, mostFactors> all{first[1], first[2], first[3]};
        std::copy_n(&moreFactors[4 * sample], factorCount - 3, all.begin() + 3);
        layer.factors = {all.data(), factorCount};
        visit(layer);
    }

  private:
    static std::array<std::size_t, samplesOfGroup> groupFrom(std::size_t sample, std::size_t number,
                                                             std::size_t stride) {
        const std::size_t left = sample - number % 2;
        const std::size_t upper = number / 2 == 0 ? left : left + stride;
        return {upper, upper + 1, upper - stride, upper - stride + 1};
    }
    [[gnu::always_inline]] Layer fragment(std::size_t number) const {
        const float* w = &words[number * wordsPerFragment];
        return {static_cast<int>(w[2]) - 1,
                w[3],
                {w + 4, factorCount},
                1.0f,
                fragmentPlaces.empty() ? nullptr : &fragmentPlaces[number],
                false};
    }
};

} // namespace irsg
