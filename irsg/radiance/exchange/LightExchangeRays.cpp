#include <algorithm>
#include <cmath>
#include <limits>

#include "irsg/radiance/exchange/LightExchangeMaking.h"
#include "irsg/radiometry/Units.h"
#include "irsg/render/rays/LightDirections.h"

namespace irsg {

namespace {

/// Rays that are followed behind the ground, of a body, and of a patch.
constexpr std::size_t raysToGround = 500'000, fewestToGround = 128, mostToGround = 1024;

} // namespace

bool LightExchange::leavesThroughBack(const Making& making, std::size_t body, Ray ray,
                                      double upTo_m) {
    const SunShadows::Caster& caster = making.casters[body];
    ray.to_m = upTo_m - caster.mesh->rounding_m();
    RayHit hit;
    std::vector<RayHit> through;
    return caster.mesh->meet(ray, making.withBacks[body], 0.0, hit, through) &&
           caster.uses.isCulled(hit);
}

bool LightExchange::hasOthersAbove(const Making& making, std::size_t body,
                                   std::uint32_t patch) const {
    const ExchangeMesh& mesh = bodies_[body].light->nodes().mesh();
    const SunShadows::Caster& caster = making.casters[body];
    for (const std::uint32_t cell : bodies_[body].light->nodes().cellsOf(patch)) {
        const Vec3 up = making.toWorld[body] * mesh.normal(cell);
        for (const Vec3& corner : mesh.cornersAt_m(cell)) {
            const Vec3 from_m = caster.pose.toWorld(corner);
            for (const std::size_t other : making.near[body]) {
                const Making::Sphere& sphere = making.spheres[other];
                if (dot(up, sphere.centre_m - from_m) > -1.001 * sphere.radius_m)
                    return true;
            }
        }
    }
    return false;
}

void LightExchange::takeWithOthers(Making& making, std::size_t body, std::uint32_t patch) const {
    const BodyLight& light = *bodies_[body].light;
    const ExchangeNodes& nodes = light.nodes();
    const ExchangeMesh& mesh = nodes.mesh();
    const SunShadows::Caster& caster = making.casters[body];
    const std::uint32_t number = firstReceiver_[body] + patch;
    const auto near = nodes.near(patch);
    const bool seesGround = making.isNearGround[body] && looksDown(making, body, patch);
    const bool isMetByOthers = making.meetsTerrain[body] || hasOthersAbove(making, body, patch);
    const auto wantedToGround = static_cast<std::uint32_t>(
        seesGround ? std::clamp(raysToGround / nodes.nodes(), fewestToGround, mostToGround) : 0);
    const std::uint32_t count =
        light.sent(patch) > 0 ? light.sent(patch) : std::max(making.raysToOthers, wantedToGround);
    // As many as do for what the ground reflects, each for some of all.
    const std::uint32_t toGround = std::min(count, wantedToGround);
    const BodyLight::Rays rays(nodes, patch);
    std::vector<float> scales(light.scalesOf(patch).begin(), light.scalesOf(patch).end());
    if (scales.empty()) {
        std::vector<double> weights(near.size());
        for (std::uint32_t i = 0; i < count; ++i)
            for (const ExchangeNodes::Share& own :
                 ExchangeNodes::OfPlace(nodes, rays.at(i).from.place))
                weights[nodes.placeNear(patch, own.node)] += static_cast<double>(own.part);
        for (std::size_t i = 0; i < near.size(); ++i) {
            making.told[number][i].rays = weights[i];
            scales.push_back(static_cast<float>(
                weights[i] > 0.0 ? static_cast<double>(near[i].area_m2) /
                                       (weights[i] * nodes.areaOf_m2(near[i].node))
                                 : 0.0));
        }
    }
    std::vector<float> scalesOfGround;
    for (const float scale : scales)
        scalesOfGround.push_back(
            toGround > 0 ? scale * static_cast<float>(count) / static_cast<float>(toGround) : 0.0f);
    const PieceUse& use = caster.uses[static_cast<std::size_t>(nodes.pieceOf(patch))];
    const bool isGas = use.transparent && use.pane == 0;
    RayHit hit;
    std::vector<RayHit> through;
    struct Pane {
        double distance_m = 0.0;
        std::size_t body = 0;
        ExchangeMesh::Place place;
        bool isOneWay = false; ///< of its own body
    };
    std::vector<Pane> panes; // that the ray passes
    std::vector<OccluderMaterial> passed;
    auto met = light.raysOf(patch).begin();
    const auto lastMet = light.raysOf(patch).end();
    const bool isApart = making.isApart(body);
    for (std::uint32_t i = 0; i < count; ++i) {
        if (!isMetByOthers && i >= toGround) {
            if (met == lastMet)
                break;
            i = met->index; // other rays meet nothing
        }
        const BodyLight::LightStart start = rays.at(i);
        const Vec3 from_m = caster.pose.toWorld(start.ray.origin_m);
        const Vec3 along = making.toWorld[body] * start.ray.direction;
        double nearest_m = std::numeric_limits<double>::infinity();
        double nearestBack_m = std::numeric_limits<double>::infinity();
        ExchangeMesh::Place place;
        std::size_t metBody = body;
        bool isOneWay = false;
        panes.clear();
        for (; met != lastMet && met->index == i; ++met) {
            if (!met->meetsAnything())
                continue;
            isOneWay = met->isOneWay;
            nearest_m = static_cast<double>(met->distance_m);
            if (making.isPane(body, mesh.pieceOf(met->place.cell))) {
                panes.push_back({nearest_m, body, met->place, met->isOneWay});
                nearest_m = std::numeric_limits<double>::infinity();
            } else {
                place = met->place;
            }
        }
        const auto isBefore = [&](std::size_t c) {
            const SunShadows::Caster& other = making.casters[c];
            const Rotation& toMesh = making.toMesh[c];
            const Ray there{toMesh * (from_m - other.pose.position_m), toMesh * along, 0.0,
                            nearest_m};
            bool isMet = other.mesh->meet(there, making.withBacks[c], 0.0, hit, through);
            if (isMet && other.uses.isCulled(hit)) {
                nearestBack_m = std::min(nearestBack_m, hit.distance_m + other.mesh->rounding_m());
                isMet = other.mesh->meet(there, other.uses, 0.0, hit, through);
            }
            return isMet && hit.distance_m < nearest_m;
        };
        for (const std::size_t other : making.near[body]) {
            if (!making.spheres[other].isMetBy(from_m, along))
                continue;
            if (isBefore(other)) {
                nearest_m = hit.distance_m;
                place = bodies_[other].light->mesh().placeOf(hit);
                metBody = other;
            }
            BodyLight::sortPassed(making.casters[other].uses, through);
            for (const RayHit& pane : through)
                panes.push_back(
                    {pane.distance_m, other, bodies_[other].light->mesh().placeOf(pane), false});
        }
        const bool isTerrain =
            making.meetsTerrain[body] && along.z > 0.0 && isBefore(making.terrainNumber);
        if (isTerrain)
            nearest_m = hit.distance_m;
        std::erase_if(panes, [&](const Pane& pane) {
            return pane.distance_m >= nearest_m || pane.place.cell == ExchangeMesh::none;
        });
        std::ranges::stable_sort(panes, {}, &Pane::distance_m);
        panes.resize(std::min(panes.size(), BodyLight::mostPassed));
        const auto tell = [&](auto add) {
            for (const ExchangeNodes::Share& share :
                 ExchangeNodes::OfPlace(nodes, start.from.place)) {
                const std::size_t n = nodes.placeNear(patch, share.node);
                add(share.node, making.told[number][n], share.part * scales[n]);
            }
        };
        if (isTerrain && panes.empty()) {
            // Terrain is ground, wherever it stands.
            tell([](std::uint32_t, Making::Told& told, float part) {
                told.sky += static_cast<double>(part);
                told.ground -= static_cast<double>(part);
            });
            continue;
        }
        const bool meetsGround =
            i < toGround && along.z < 0.0 && place.cell == ExchangeMesh::none && !isTerrain;
        if (panes.empty() && place.cell == ExchangeMesh::none) {
            if (meetsGround)
                reflectOnGround(making, body, patch, start, i, {}, scalesOfGround);
            continue;
        }
        tell([&](std::uint32_t, Making::Told& told, float part) {
            (along.z > 0.0 ? told.sky : told.ground) += static_cast<double>(part);
        });
        passed.clear();
        const auto meet = [&](std::size_t there, const ExchangeMesh::Place& at, bool isSeenAlone) {
            tellOfSun(making, number, passed, there, at, [&](auto add) {
                tell([&](std::uint32_t node, Making::Told&, float part) {
                    add(firstReceiver_[body] + node, part);
                });
            });
            if (there == body && isApart) // its pairs are known
                return;
            FoundThrough::Behind* const behind =
                passed.empty() ? nullptr : &making.found[number].bySet[passed];
            std::vector<LightPart>& parts = isSeenAlone
                                                ? (behind ? behind->oneWay : making.oneWay[number])
                                                : (behind ? behind->parts : making.parts[number]);
            const ExchangeNodes& nodesThere = bodies_[there].light->nodes();
            const auto senders = ExchangeNodes::OfPlace(nodesThere, at).ofSenders(nodesThere);
            tell([&](std::uint32_t node, Making::Told&, float part) {
                for (const ExchangeNodes::Share& sender : senders)
                    parts.push_back({firstReceiver_[body] + node, firstSender_[there] + sender.node,
                                     part * sender.part});
            });
        };
        for (const Pane& pane : panes) {
            const bool isOut =
                pane.isOneWay || nearestBack_m < pane.distance_m ||
                (pane.body != body && leavesThroughBack(making, body, start.ray, pane.distance_m));
            meet(pane.body, pane.place, isGas || isOut);
            Making::pass(passed, making.paneOf(pane.body, bodies_[pane.body].light->mesh().pieceOf(
                                                              pane.place.cell)));
        }
        if (place.cell == ExchangeMesh::none || isTerrain) {
            // Terrain is ground.
            tell([&](std::uint32_t node, Making::Told&, float part) {
                leave(making, number, passed, near.size(), nodes.placeNear(patch, node),
                      along.z > 0.0 && !isTerrain, static_cast<double>(part));
            });
            if (meetsGround)
                reflectOnGround(making, body, patch, start, i, passed, scalesOfGround);
            continue;
        }
        if (metBody != body)
            isOneWay = leavesThroughBack(making, body, start.ray, nearest_m);
        meet(metBody, place, isGas || isOneWay || nearestBack_m < nearest_m);
    }
    mergeParts(making.parts[number]);
    mergeParts(making.oneWay[number]);
    if (!making.sunParts.empty())
        mergeParts(making.sunParts[number]);
}

bool LightExchange::looksDown(const Making& making, std::size_t body, std::uint32_t patch) const {
    constexpr double levelCosine = 0.999;
    const ExchangeMesh& mesh = bodies_[body].light->mesh();
    return std::ranges::any_of(
        bodies_[body].light->nodes().cellsOf(patch), [&](std::uint32_t cell) {
            return (making.toWorld[body] * mesh.normal(cell)).z < levelCosine;
        });
}

void LightExchange::reflectOnGround(Making& making, std::size_t body, std::uint32_t patch,
                                    const BodyLight::LightStart& start, std::uint32_t index,
                                    std::vector<OccluderMaterial> passed,
                                    std::span<const float> scales) const {
    const SunShadows::Caster& caster = making.casters[body];
    const Vec3 from_m = caster.pose.toWorld(start.ray.origin_m);
    const Vec3 along = making.toWorld[body] * start.ray.direction;
    if (!(from_m.z > 0.0) || !(along.z < 0.0))
        return;
    Vec3 place_m = from_m - along * (from_m.z / along.z);
    place_m.z = 1e-6 * from_m.z;
    std::vector<std::size_t> above = making.near[body];
    above.push_back(body);
    if (std::ranges::none_of(above, [&](std::size_t other) {
            const Vec3 to_m = making.spheres[other].centre_m - place_m;
            return making.spheres[other].radius_m * making.spheres[other].radius_m >
                   Making::negligiblePart * making.error * dot(to_m, to_m);
        }))
        return;
    Making::pass(passed, groundMaterial);
    const ExchangeNodes& nodes = bodies_[body].light->nodes();
    const std::uint32_t number = firstReceiver_[body] + patch;
    const ExchangeNodes::OfPlace own(nodes, start.from.place);
    const auto tell = [&](auto add) {
        for (const ExchangeNodes::Share& share : own)
            add(share.node, share.part * scales[nodes.placeNear(patch, share.node)]);
    };
    const auto takeAway = [&](double OutsideLight::*which, double most) {
        std::vector<OutsideLight>& leaving = making.found[number].bySet[passed].leaving;
        leaving.resize(nodes.near(patch).size());
        tell([&](std::uint32_t node, float part) {
            leaving[nodes.placeNear(patch, node)].*which -= most * static_cast<double>(part);
        });
    };
    // Another sequence than that of the ray, turned by the patch (Roberts).
    const auto coordinate = [&](double step, double turn) {
        const double at = 0.5 + step * index + turn * number;
        return at - std::floor(at);
    };
    const Vec3 up = cosineDirection({0, 0, 1}, coordinate(0.7548776662466927, 0.6180339887498949),
                                    coordinate(0.5698402909980532, 0.4142135623730950));
    double nearest_m = std::numeric_limits<double>::infinity();
    std::size_t metBody = body;
    ExchangeMesh::Place met;
    RayHit hit;
    std::vector<RayHit> through;
    for (const std::size_t other : above) {
        const SunShadows::Caster& there = making.casters[other];
        const Rotation& toMesh = making.toMesh[other];
        if (!making.spheres[other].isMetBy(place_m, up) ||
            !there.mesh->meet(
                {toMesh * (place_m - there.pose.position_m), toMesh * up, 0.0, nearest_m},
                there.uses, 0.0, hit, through) ||
            hit.distance_m >= nearest_m)
            continue;
        nearest_m = hit.distance_m;
        met = bodies_[other].light->mesh().placeOf(hit);
        metBody = other;
    }
    if (met.cell != ExchangeMesh::none) {
        takeAway(&OutsideLight::sky, 1.0);
        tellOfSun(making, number, passed, metBody, met, [&](auto add) {
            tell([&](std::uint32_t node, float part) { add(firstReceiver_[body] + node, part); });
        });
        const ExchangeNodes& nodesThere = bodies_[metBody].light->nodes();
        std::vector<LightPart>& parts = making.found[number].bySet[passed].oneWay;
        for (const ExchangeNodes::Share& sender :
             ExchangeNodes::OfPlace(nodesThere, met).ofSenders(nodesThere))
            tell([&](std::uint32_t node, float part) {
                parts.push_back({firstReceiver_[body] + node, firstSender_[metBody] + sender.node,
                                 part * sender.part});
            });
    }
    const LightSources& sources = making.sources;
    if (!sources.isSunOn || !sources.isSunShadowed || sources.sunAlways >= 0.0 ||
        !(sources.towardsSun.z > 0.0))
        return;
    std::vector<int> pieces;
    for (const std::size_t other : above) {
        const SunShadows::Caster& there = making.casters[other];
        const Rotation& toMesh = making.toMesh[other];
        pieces.clear();
        if (there.mesh->letsPass(
                {toMesh * (place_m - there.pose.position_m), toMesh * sources.towardsSun},
                there.uses, nullptr, pieces))
            continue;
        takeAway(&OutsideLight::sun, sources.towardsSun.z);
        return;
    }
}

} // namespace irsg
