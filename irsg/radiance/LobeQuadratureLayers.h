#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "irsg/radiance/LobeAims.h"
#include "irsg/radiance/LobePaths.h"
#include "irsg/radiance/LobeQuadrature.h"
#include "irsg/render/rays/RayVectors.h"
#include "irsg/render/rays/TileSamples.h"

namespace irsg {

/// Of a drawing.
struct LobeQuadrature::Tile {
    /// Neighbours whose normals differ by more are those of another face.
    static constexpr double mostBend = 0.5;

    const SurfaceScene* scene = nullptr;
    const SampleTile* tile = nullptr;
    EyeDirections directions;
    Vec3 zenith, sun, towards; ///< the last the level part of the sun's, a unit vector
    std::optional<SunShadows::OpenPaths> open;
    const LightExchange* exchange = nullptr; ///< there where `open` is
    /// Of the facets that a sample follows one in so many; one that stands for four twice as many.
    std::size_t step = 1;
    /// What rays are aimed at, and where these spheres are, in the world; there where `open` is.
    const LobeAims* aims = nullptr;
    std::vector<Vec3> aimsAt_m;

    /// The normal of the opaque surface of a sample, and its row + 1; 0 for none.
    static std::pair<float, Vec3> opaqueAt(const GeometrySamples& samples, std::size_t sample,
                                           std::size_t first) {
        const auto number = [&](std::size_t f) {
            return static_cast<double>(samples.opaqueFactor(sample, f));
        };
        return {samples.opaque[4 * sample], {number(first), number(first + 1), number(first + 2)}};
    }
    /// The same from group to group, which are twice as far apart; `sample` has the mean.
    Vec3 changeOfGroup(const GeometrySamples& samples, std::size_t sample, bool isDown,
                       std::size_t first) const {
        constexpr std::size_t members = GeometrySamples::samplesOfGroup;
        const auto group = samples.groupOf(sample, tile->stride());
        std::array<Vec3, members> normals;
        Vec3 stands = opaqueAt(samples, sample, first).second * static_cast<double>(members);
        for (std::size_t i = 0; i < members; ++i)
            if (group[i] != sample) {
                normals[i] = opaqueAt(samples, group[i], first).second;
                stands = stands - normals[i];
            }
        for (std::size_t i = 0; i < members; ++i)
            if (group[i] == sample)
                normals[i] = stands;
        return isDown ? normals[2] + normals[3] - normals[0] - normals[1]
                      : normals[1] + normals[3] - normals[0] - normals[2];
    }
    /// How the normal changes from sample to sample along rows or columns, from the side that
    /// bends less.
    Vec3 change(const GeometrySamples& samples, std::size_t sample, int column, int row,
                bool isDown, std::size_t first) const {
        if (samples.standsForGroup(sample))
            return changeOfGroup(samples, sample, isDown, first);
        const auto [own, normal] = opaqueAt(samples, sample, first);
        Vec3 least;
        double square = mostBend * mostBend;
        for (const int step : {-1, 1}) {
            const int x = column + (isDown ? 0 : step), y = row + (isDown ? step : 0);
            if (x < 0 || y < 0 || x >= tile->width() || y >= tile->height())
                continue;
            const auto [other, next] = opaqueAt(samples, indexOf(*tile, x, y), first);
            const Vec3 difference = next - normal;
            if (other == own && product(difference, difference) < square) {
                square = product(difference, difference);
                least = difference;
            }
        }
        return least;
    }
};

/// A layer of a directional surface.
struct LobeQuadrature::DirectionalLayer {
    const GeometrySamples::Layer& layer;
    const SurfaceModel& model;
    const SpecularEnvironmentGrid& grid;
    Vec3 along; ///< from the eye
    SurfaceAxes axes;
    SurfaceDirection to;
    std::uint32_t sample = 0, number = 0; ///< number among those of the sample
    int firstLobe = 0;                    ///< row
    std::size_t step = 1;                 ///< of the facets that are followed
    int raysOfAim = 1;                    ///< to each sphere

    std::size_t lobes() const {
        std::size_t count = 0;
        while (count < model.components() && model.hasLobe(count))
            ++count;
        return count;
    }
    int rowOf(std::size_t component) const { return firstLobe + static_cast<int>(component); }
    int rowOfAtmosphere(std::size_t component, std::size_t place) const {
        return rowOf(model.components() + component * grid.places().size() + place);
    }
    int rowOfSurfaces(std::size_t component) const {
        return rowOf(model.components() + lobes() * grid.places().size() + component);
    }
};

/// What the lobes of a layer meet, in parts of their albedos.
struct LobeQuadrature::Mirrored {
    bool isOpen = false; ///< all meet the atmosphere; no more is told
    /// The rest is told of what is met in place of the atmosphere, all of which a table has.
    bool isBesideTable = false;
    std::vector<LobePaths::Part> atmosphere; ///< by place of the grid, through nothing
    LobePaths::Found found;                  ///< and what else there is of the atmosphere

    void clear() {
        isOpen = isBesideTable = false;
        atmosphere.clear();
        found.clear();
    }
};

} // namespace irsg
