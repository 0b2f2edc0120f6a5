#pragma once

// What the files of LightExchange share, and nobody else includes.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "irsg/radiance/exchange/LightExchange.h"

namespace irsg {

/// What is at hand while an exchange is made.
struct LightExchange::Making {
    /// Of the error that is asked for: bodies that fill less of a hemisphere, as bright as they are
    /// beside the other, are left out. At the usual error that is 0.001 of what a place that faces
    /// them receives, and less than a tenth of what is stated for inter-reflection.
    static constexpr double negligiblePart = 0.2;

    /// A bounding sphere in the world.
    struct Sphere {
        Vec3 centre_m;
        double radius_m = 0.0;

        bool isMetBy(const Vec3& from_m, const Vec3& along) const {
            const Vec3 to = centre_m - from_m;
            const double ahead_m = dot(to, along), square_m2 = dot(to, to);
            const double radius2_m2 = radius_m * radius_m;
            return square_m2 <= radius2_m2 ||
                   (ahead_m > 0.0 && square_m2 - ahead_m * ahead_m <= radius2_m2);
        }
    };
    /// What a patch tells a node near it: what is lost of sky and ground and, as areas in
    /// m2, how much of it sees the sky, with published weights or without.
    struct Told {
        double sky = 0.0, ground = 0.0;
        double rays = 0.0; ///< that began there, of patches that see nothing of their own body
        double open_m2 = 0.0, weighted_m2 = 0.0;
    };
    const std::vector<SunShadows::Caster>& casters;
    const LightSources& sources;
    std::vector<Rotation> toWorld{}, toMesh{};        ///< by caster
    std::vector<Sphere> spheres{};                    ///< by body
    std::vector<std::vector<std::size_t>> near{};     ///< bodies that a body may see
    std::vector<std::vector<std::size_t>> shading{};  ///< casters that may shade a body
    std::vector<bool> meetsTerrain{}, isNearGround{}; ///< by body
    const SunShadows::Caster* terrain = nullptr;
    std::size_t terrainNumber = 0;
    std::uint32_t raysToOthers = 0;
    double error = 0.0;                                    ///< of view factors
    std::vector<PieceUses> withBacks{};                    ///< by caster, see PieceUses
    std::vector<std::vector<LightPart>> parts{}, oneWay{}; ///< by patch
    std::vector<std::vector<Told>> told{};                 ///< by patch and near node
    std::vector<float> sunOnCells{}; ///< as factors; none: it lights all alike
    /// What the sun gives a cell beside the means of senders at its corners, and its drawn row.
    struct SunBeside {
        std::array<float, 3> atCorners;
        std::uint32_t row;

        float at(float u, float v) const {
            return (1.0f - u - v) * atCorners[0] + u * atCorners[1] + v * atCorners[2];
        }
    };
    /// By cell: through nothing (0), and through `through_[set - 1]`; none where no sun is.
    std::vector<std::vector<SunBeside>> sunBeside{};
    std::vector<std::vector<LightPart>> sunParts{}; ///< by patch, of receivers and rows
    std::vector<FoundThrough> found{};              ///< by patch; none without panes
    /// By cell: what the sun gives it through sets of materials, as factors.
    std::vector<std::vector<std::pair<std::vector<OccluderMaterial>, float>>> sunThrough{};

    std::vector<std::shared_ptr<const TurnedBody>> turned{}; ///< by body that is alone, else null

    double area_m2(const std::vector<Body>& bodies, std::size_t body, std::uint32_t cell) const {
        return turned[body] && !turned[body]->areas_m2.empty()
                   ? turned[body]->areas_m2[cell]
                   : bodies[body].light->mesh().area_m2(cell);
    }
    Vec3 normal(const std::vector<Body>& bodies, std::size_t body, std::uint32_t cell) const {
        return turned[body] && !turned[body]->normals.empty()
                   ? turned[body]->normals[cell]
                   : bodies[body].light->mesh().normal(cell);
    }
    /// The material of a transparent piece.
    OccluderMaterial paneOf(std::size_t body, std::size_t piece) const {
        return {casters[body].entity, casters[body].materials[piece]};
    }
    bool isPane(std::size_t body, std::size_t piece) const {
        return casters[body].uses[piece].pane > 0;
    }
    /// What a ray has passed with one more.
    static void pass(std::vector<OccluderMaterial>& set, const OccluderMaterial& material) {
        set.insert(std::ranges::upper_bound(set, material), material);
    }

    /// Of a patch: what the sun gives through what its rays have passed, and through one of
    /// `passages` beyond that.
    std::vector<LightPart>& sunPartsOf(std::uint32_t number, const OccluderStacks& passages,
                                       std::vector<OccluderMaterial> passed, std::size_t set) {
        if (set > 0)
            for (const OccluderMaterial& material : passages.materials(static_cast<int>(set)))
                pass(passed, material);
        return passed.empty() ? sunParts[number] : found[number].bySet[passed].sun;
    }

    /// Height of the highest place of the terrain, m.
    double terrainTop_m() const {
        double top_m = -1e300;
        for (std::size_t piece = 0; piece < terrain->mesh->pieces(); ++piece)
            for (unsigned f = 0; f < terrain->mesh->facetsOf(piece); ++f)
                for (const Vec3& corner : terrain->mesh->facet(piece, f).corners_m)
                    top_m = std::max(top_m, terrain->pose.toWorld(corner).z);
        return top_m;
    }
    bool isAlone(std::size_t body) const {
        return near[body].empty() && !meetsTerrain[body] && !isNearGround[body];
    }
    bool areAllAlone() const {
        for (std::size_t body = 0; body < near.size(); ++body)
            if (!isAlone(body))
                return false;
        return true;
    }
    /// Whether what a body sees of itself is what it sees of itself alone: others are outside of
    /// its sphere.
    bool isApart(std::size_t body) const {
        return !meetsTerrain[body] && std::ranges::none_of(near[body], [&](std::size_t other) {
            return length(spheres[other].centre_m - spheres[body].centre_m) <=
                   spheres[other].radius_m + spheres[body].radius_m;
        });
    }
    /// Whether light falls on a patch at all.
    static bool isSeen(const Body& body, std::uint32_t patch) {
        return body.light->nodes().patchArea_m2(patch) > 0.0;
    }
};

template <typename ForEachOwn>
void LightExchange::tellOfSun(Making& making, std::uint32_t number,
                              const std::vector<OccluderMaterial>& passed, std::size_t metBody,
                              const ExchangeMesh::Place& met, ForEachOwn forEachOwn) const {
    if (making.sunParts.empty())
        return;
    for (std::size_t set = 0; set < making.sunBeside.size(); ++set) {
        if (making.sunBeside[set].empty())
            continue;
        const Making::SunBeside& sun = making.sunBeside[set][firstCell_[metBody] + met.cell];
        const float beside = sun.at(met.u, met.v);
        if (beside == 0.0f)
            continue;
        std::vector<LightPart>& parts = making.sunPartsOf(number, passages_, passed, set);
        forEachOwn([&](std::uint32_t receiver, float part) {
            parts.push_back({receiver, sun.row, part * beside});
        });
    }
}

} // namespace irsg
