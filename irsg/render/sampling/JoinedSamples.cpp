#include "irsg/render/sampling/JoinedSamples.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>
#include <vector>

#include "irsg/core/ParallelFor.h"

namespace irsg {

namespace {

constexpr std::size_t members = GeometrySamples::samplesOfGroup;

/// What the distances of neighbours may differ by, in units of what is between them across the
/// line of sight: of surfaces that are seen at a grazing angle, and from one to another behind it.
constexpr double steepest = 8.0;

class Joining {
  public:
    Joining(const SurfaceScene& scene, const SampleTile& tile, const JoinLimits& limits,
            GeometrySamples& samples)
        : tile_(tile),
          limits_(limits),
          samples_(samples),
          cells_(tile.blocksWide * tile.samplesAcross) {
        most_ = steepest * scene.camera->sensor().pixelPitch() *
                std::max(tile.cellWidth_px(), tile.cellHeight_px());
    }

    /// Pairs of rows of one part of the tile, each in one row of blocks.
    void joinPart(std::size_t part) {
        const auto rows = static_cast<std::size_t>(tile_.height());
        const auto begin = static_cast<int>(beginOfPart(part, partsOfTile, rows));
        const auto end = static_cast<int>(beginOfPart(part + 1, partsOfTile, rows));
        for (int row = begin + 1; row + 2 < end; ++row)
            if (beginsPair(row, tile_.samplesDown) &&
                tile_.firstColumn(row) == tile_.firstColumn(row + 1))
                joinRows(row);
    }

  private:
    /// Whether a row or column of samples is the first of two in its block.
    static bool beginsPair(int number, int samplesOfBlock) {
        const int within = number % samplesOfBlock;
        return within % 2 == 0 && within + 1 < samplesOfBlock;
    }
    /// Groups of a row and the one below.
    void joinRows(int row) {
        // Cells beside members must count, too.
        std::array<std::vector<double>, 4> weights;
        if (!tile_.isWhole())
            for (int i = 0; i < 4; ++i)
                weights[static_cast<std::size_t>(i)] = tile_.weightsOf(row - 1 + i);
        const auto isInside = [&](int cell) {
            constexpr double whole = 1.0 - 1e-9;
            for (const std::vector<double>& own : weights)
                for (int beside = cell - 1; beside <= cell + 2 && !own.empty(); ++beside)
                    if (own[static_cast<std::size_t>(beside)] < whole)
                        return false;
            return true;
        };
        const std::size_t lower =
            tile_.firstSample +
            static_cast<std::size_t>(tile_.height() - 2 - row) * tile_.stride() +
            static_cast<std::size_t>(tile_.firstColumn(row));
        const std::size_t upper = lower + tile_.stride();
        for (int cell = 1; cell + 2 < cells_; ++cell) {
            if (!beginsPair(cell, tile_.samplesAcross))
                continue;
            const auto c = static_cast<std::size_t>(cell);
            const std::array<std::size_t, members> group{upper + c, upper + c + 1, lower + c,
                                                         lower + c + 1};
            if ((samples_.isOpaque(group[0]) || samples_.isListed(group[0])) && isSmooth(group) &&
                isInside(cell))
                join(group, static_cast<std::size_t>((cell / 2) % 2 + 2 * ((row / 2) % 2)));
        }
    }

    bool isSmooth(std::span<const std::size_t, members> group) {
        return isGasAlike(group) && isOpaqueSmooth(group);
    }
    /// Whether all have nothing before their opaque surface, or the walls of gases alone and about
    /// the same lengths between them.
    bool isGasAlike(std::span<const std::size_t, members> group) {
        constexpr float alike = 0.15f; // of the longest: what emits is smooth in it
        if (std::ranges::none_of(group, [&](std::size_t i) { return samples_.isListed(i); }))
            return true;
        for (std::size_t m = 0; m < members; ++m) {
            walls_[m].clear();
            if (!samples_.isListed(group[m]) || samples_.isLeftOver(group[m]))
                return false;
            samples_.forEachLayer(group[m], [&](const GeometrySamples::Layer& layer) {
                walls_[m].emplace_back(layer.row, layer.distance_m);
            });
        }
        const std::size_t walls = walls_[0].size() - (samples_.isOpaque(group[0]) ? 1 : 0);
        for (std::size_t i = 0; i < walls_[0].size(); ++i) {
            const int row = walls_[0][i].first;
            if (i < walls && !limits_.isGas[static_cast<std::size_t>(row)])
                return false;
            float least_m = 1e30f, greatest_m = 0.0f;
            for (const auto& own : walls_) {
                if (own.size() != walls_[0].size() || own[i].first != row)
                    return false;
                const float length_m = i > 0 ? own[i].second - own[i - 1].second : 0.0f;
                least_m = std::min(least_m, length_m);
                greatest_m = std::max(greatest_m, length_m);
            }
            // Behind the last wall of an even number is no gas.
            if ((i < walls || walls % 2 == 1) && greatest_m - least_m > alike * greatest_m)
                return false;
        }
        return true;
    }
    bool isOpaqueSmooth(std::span<const std::size_t, members> group) const {
        const float row = samples_.opaque[4 * group[0]];
        if (row == 0.0f)
            return std::ranges::none_of(group, [&](std::size_t i) { return samples_.isOpaque(i); });
        const auto drawn = static_cast<std::size_t>(row) - 1;
        if (drawn >= limits_.mostDifference.size() || !(limits_.mostDifference[drawn] > 0.0))
            return false;
        double nearest = samples_.distances_m[group[0]], farthest = nearest;
        for (const std::size_t sample : group) {
            if (samples_.opaque[4 * sample] != row)
                return false;
            nearest = std::min(nearest, static_cast<double>(samples_.distances_m[sample]));
            farthest = std::max(farthest, static_cast<double>(samples_.distances_m[sample]));
        }
        if (farthest - nearest > most_ * nearest)
            return false;
        for (std::size_t f = 0; f < samples_.factorCount; ++f) {
            const double most =
                f < limits_.firstNormal ? limits_.mostDifference[drawn] : limits_.mostBend[drawn];
            float least = samples_.opaqueFactor(group[0], f), greatest = least;
            for (const std::size_t sample : group) {
                least = std::min(least, samples_.opaqueFactor(sample, f));
                greatest = std::max(greatest, samples_.opaqueFactor(sample, f));
            }
            if (static_cast<double>(greatest - least) > most)
                return false;
        }
        return true;
    }

    void join(std::span<const std::size_t, members> group, std::size_t stands) {
        for (std::size_t f = 0; f < samples_.factorCount; ++f) {
            float sum = 0.0f;
            for (const std::size_t sample : group)
                sum += samples_.opaqueFactor(sample, f);
            samples_.opaqueFactor(group[stands], f) = sum / static_cast<float>(members);
        }
        for (std::size_t i = 0; i < members; ++i)
            samples_.groups[group[i]] = static_cast<std::uint8_t>(
                i == stands ? i + 1 : GeometrySamples::ofAnother + members * stands + i);
    }

    const SampleTile& tile_;
    const JoinLimits& limits_;
    GeometrySamples& samples_;
    int cells_;
    double most_ = 0.0;
    /// By member: rows and distances of what lies before its opaque surface, and of that.
    std::array<std::vector<std::pair<int, float>>, members> walls_;
};

} // namespace

void joinSmoothSamples(const SheetScene& sheet, const JoinLimits& limits,
                       GeometrySamples& samples) {
    samples.groups.assign(samples.size(), 0);
    // Each of four has its own length in gas that the eye is in.
    if (!samples.gasesAboutEye.empty())
        return;
    for (std::size_t t = 0; t < sheet.scenes.size(); ++t) {
        const Joining joining(sheet.scenes[t], sheet.sheet.tiles[t], limits, samples);
        parallelFor(partsOfTile, [&](std::size_t part) { Joining(joining).joinPart(part); });
    }
}

void giveToGroups(const SampleSheet& sheet, const GeometrySamples& samples,
                  RadianceSamples& radiances) {
    if (samples.groups.empty())
        return;
    for (const SampleTile& tile : sheet.tiles)
        for (int row = 0; row < tile.height(); ++row) {
            const std::size_t first =
                tile.firstSample + static_cast<std::size_t>(row) * tile.stride();
            for (std::size_t i = first; i < first + static_cast<std::size_t>(tile.width()); ++i)
                if (samples.standsForGroup(i))
                    for (const std::size_t member : samples.groupOf(i, tile.stride()))
                        for (std::size_t k = 0; k < 2; ++k)
                            radiances.planes[2 * member + k] = radiances.planes[2 * i + k];
        }
}

} // namespace irsg
