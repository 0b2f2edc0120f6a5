#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

#include "irsg/core/ParallelFor.h"
#include "irsg/core/StageReport.h"
#include "irsg/radiance/exchange/LightExchangeMaking.h"
#include "irsg/radiometry/Units.h"
#include "irsg/render/rays/LightDirections.h"

namespace irsg {

namespace {

/// Columns that stand for all lines of sight through the gas of an entity.
constexpr std::size_t mostGasColumns = 16;
/// Rays of all patches of a body, and of one.
constexpr std::size_t raysToGas = std::size_t{1} << 21, fewestToGas = 128, mostToGas = 1024;
/// The cone about a gas is left for the whole hemisphere from nearer than this, in radii.
constexpr double leastDistance = 1.05;

} // namespace

/// What the rays of a patch find that have met gas.
struct LightExchange::GasRays {
    enum class Behind { nothing, sender, sky, ground };
    /// Light that has passed gas on its way to a ray's start, or is emitted by it.
    struct Found {
        ExchangeMesh::Place from;
        float weight = 0.0f;
        std::vector<OccluderMaterial> panes;                                   ///< before it
        std::vector<std::pair<int, std::vector<GasColumnKey::Stretch>>> gases; ///< by entity
        Behind behind = Behind::nothing; ///< nothing: what the gas emits
        std::size_t metBody = 0;
        ExchangeMesh::Place met;
    };
    std::vector<Found> found;
    std::vector<float> scales; ///< by near node: what a ray counts there, times its part

    // Of the ray that is followed.
    ExchangeMesh::Place from;
    float weight = 0.0f;
};

void LightExchange::takeGas(const Making& making, std::span<const Gas> gases) {
    std::vector<GasRays> found(rows_.size()); // by patch
    StageCount count("gas", receivers());
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
        std::vector<Gas> near;
        for (const Gas& gas : gases)
            if (gas.body == b || isNear(bodies_[b].extent, gas.extent, making.error))
                near.push_back(gas);
        if (near.empty())
            continue;
        parallelForSmall(bodies_[b].light->nodes().nodes(), [&](std::uint32_t patch) {
            count.add();
            if (making.isSeen(bodies_[b], patch))
                sendToGas(making, near, b, patch, found[firstReceiver_[b] + patch]);
        });
    }
    firstGasPane_ = panes_.size();
    for (const Gas& gas : gases)
        for (std::size_t piece = 0; piece < gas.codes.size(); ++piece)
            if (gas.volumes_m3[piece] > 0.0)
                gasSenders_.push_back({making.casters[gas.body].entity,
                                       making.casters[gas.body].rows[piece], gas.codes[piece]});
    std::ranges::sort(gasSenders_, {}, &GasSender::row);
    const auto repeated = std::ranges::unique(gasSenders_);
    gasSenders_.erase(repeated.begin(), repeated.end());
    gatherGas(found);
}

void LightExchange::sendToGas(const Making& making, std::span<const Gas> gases, std::size_t body,
                              std::uint32_t patch, GasRays& found) const {
    const ExchangeNodes& nodes = bodies_[body].light->nodes();
    const ExchangeMesh& mesh = nodes.mesh();
    const SunShadows::Caster& caster = making.casters[body];
    const auto isAbove = [&](const Gas& gas) {
        return std::ranges::any_of(nodes.cellsOf(patch), [&](std::uint32_t cell) {
            const Vec3 up = making.toWorld[body] * mesh.normal(cell);
            return std::ranges::any_of(mesh.cornersAt_m(cell), [&](const Vec3& corner) {
                const Vec3 to_m = gas.extent.centre_m - caster.pose.toWorld(corner);
                return dot(up, to_m) > -1.001 * gas.extent.radius_m;
            });
        });
    };
    std::vector<Gas> above;
    std::ranges::copy_if(gases, std::back_inserter(above), isAbove);
    if (above.empty())
        return;
    const auto count = static_cast<std::uint32_t>(
        std::bit_floor(std::clamp(raysToGas / nodes.nodes(), fewestToGas, mostToGas)));
    const LightPoints points(~(firstReceiver_[body] + patch));
    const auto near = nodes.near(patch);
    std::vector<double> weights(near.size());
    for (std::uint32_t i = 0; i < count; ++i) {
        const LightPoint point = points.at(i);
        const ExchangeNodes::Start start = nodes.start(patch, point[0], point[1], point[2]);
        for (const ExchangeNodes::Share& share : ExchangeNodes::OfPlace(nodes, start.place))
            weights[nodes.placeNear(patch, share.node)] += static_cast<double>(share.part);
        const Vec3 from_m = caster.pose.toWorld(start.at_m);
        const Vec3 normal = making.toWorld[body] * start.normal;
        // Rays go to the only gas, or anywhere.
        const Extent& sphere = above.front().extent;
        const Vec3 to_m = sphere.centre_m - from_m;
        const double distance_m = length(to_m);
        const bool isAimed = above.size() == 1 && distance_m > leastDistance * sphere.radius_m;
        Ray ray{from_m, {}};
        double weight = 1.0;
        if (isAimed) {
            const double sine = sphere.radius_m / distance_m;
            const double height = sine * sine / (1.0 + std::sqrt(1.0 - sine * sine));
            const double cosine = 1.0 - point[3] * height, across = 2.0 * pi * point[4];
            const Vec3 axis = to_m * (1.0 / distance_m);
            const auto [right, up] = acrossTo(axis);
            ray.direction = axis * cosine + (right * std::cos(across) + up * std::sin(across)) *
                                                std::sqrt(std::max(1.0 - cosine * cosine, 0.0));
            weight = 2.0 * height * std::max(dot(normal, ray.direction), 0.0);
        } else {
            ray.direction = cosineDirection(normal, point[3], point[4]);
        }
        if (!(weight > 0.0))
            continue;
        found.from = start.place;
        found.weight = static_cast<float>(weight);
        followThroughGas(making, above, body, ray, found);
    }
    for (std::size_t i = 0; i < near.size(); ++i)
        found.scales.push_back(
            static_cast<float>(weights[i] > 0.0 ? static_cast<double>(near[i].area_m2) /
                                                      (weights[i] * nodes.areaOf_m2(near[i].node))
                                                : 0.0));
}

void LightExchange::followThroughGas(const Making& making, std::span<const Gas> gases,
                                     std::size_t body, const Ray& ray, GasRays& found) const {
    const auto inMesh = [&](std::size_t b, double upTo_m) {
        return Ray{making.toMesh[b] * (ray.origin_m - making.casters[b].pose.position_m),
                   making.toMesh[b] * ray.direction, 0.0, upTo_m};
    };
    constexpr double infinity = std::numeric_limits<double>::infinity();
    struct Wall {
        double distance_m = 0.0;
        const Gas* gas = nullptr;
        std::size_t piece = 0;
    };
    thread_local std::vector<Wall> walls;
    thread_local std::vector<RayHit> through;
    RayHit hit;
    walls.clear();
    for (const Gas& gas : gases) {
        making.casters[gas.body].mesh->meet(inMesh(gas.body, infinity), gas.walls, 0.0, hit,
                                            through);
        for (const RayHit& wall : through)
            walls.push_back({wall.distance_m, &gas, static_cast<std::size_t>(wall.piece)});
    }
    if (walls.empty())
        return;
    std::ranges::sort(walls, {}, &Wall::distance_m);

    // What is solid, and panes.
    struct Pane {
        double distance_m = 0.0;
        std::size_t body = 0;
        ExchangeMesh::Place place;
    };
    std::vector<Pane> panes;
    double nearest_m = infinity;
    std::size_t metBody = body;
    ExchangeMesh::Place met;
    std::vector<std::size_t> others = making.near[body];
    others.insert(others.begin(), body);
    for (const std::size_t b : others) {
        const SunShadows::Caster& caster = making.casters[b];
        if (caster.mesh->meet(inMesh(b, nearest_m), caster.uses, 0.0, hit, through)) {
            nearest_m = hit.distance_m;
            met = bodies_[b].light->mesh().placeOf(hit);
            metBody = b;
        }
        BodyLight::sortPassed(caster.uses, through);
        for (const RayHit& pane : through)
            panes.push_back({pane.distance_m, b, bodies_[b].light->mesh().placeOf(pane)});
    }
    std::erase_if(panes, [&](const Pane& pane) {
        return pane.distance_m >= nearest_m || pane.place.cell == ExchangeMesh::none;
    });
    std::ranges::sort(panes, {}, &Pane::distance_m);

    // Stretches between walls: a gas that is left without having been entered is around the start.
    struct Zone {
        const Gas* gas = nullptr;
        std::size_t piece = 0;
        bool isInside = false;
    };
    std::vector<Zone> zones;
    const auto zoneOf = [&](const Wall& wall) -> Zone& {
        const auto known = std::ranges::find_if(zones, [&](const Zone& zone) {
            return zone.gas == wall.gas &&
                   zone.gas->codes[zone.piece] == wall.gas->codes[wall.piece];
        });
        return known != zones.end() ? *known
                                    : zones.emplace_back(Zone{wall.gas, wall.piece, false});
    };
    for (const Wall& wall : walls) {
        Zone& zone = zoneOf(wall);
        zone.isInside = !zone.isInside;
    }
    struct Length {
        const Zone* zone = nullptr;
        double from_m = 0.0, to_m = 0.0;
    };
    std::vector<Length> lengths;
    double at_m = 0.0;
    for (const Wall& wall : walls) {
        const double to_m = std::min(wall.distance_m, nearest_m);
        const Zone* inner = nullptr;
        for (const Zone& zone : zones)
            if (zone.isInside && (inner == nullptr || zone.gas->volumes_m3[zone.piece] <
                                                          inner->gas->volumes_m3[inner->piece]))
                inner = &zone;
        if (inner != nullptr && to_m > at_m)
            lengths.push_back({inner, at_m, to_m});
        at_m = std::max(at_m, to_m);
        Zone& zone = zoneOf(wall);
        zone.isInside = !zone.isInside;
    }
    if (lengths.empty())
        return;

    const auto gasesUpTo = [&](double upTo_m) {
        std::vector<std::pair<int, std::vector<GasColumnKey::Stretch>>> columns;
        for (const auto& [zone, from_m, to_m] : lengths) {
            const double length_m = std::min(to_m, upTo_m) - from_m;
            if (!(length_m > 0.0))
                continue;
            const int entity = making.casters[zone->gas->body].entity;
            auto own = std::ranges::find(columns, entity, &decltype(columns)::value_type::first);
            if (own == columns.end())
                own = columns.insert(own, {entity, {}});
            own->second.push_back({zone->gas->codes[zone->piece], length_m});
        }
        return columns;
    };
    std::vector<OccluderMaterial> passed;
    const auto add = [&](double upTo_m, GasRays::Behind behind, std::size_t there,
                         const ExchangeMesh::Place& place) {
        found.found.push_back(
            {found.from, found.weight, passed, gasesUpTo(upTo_m), behind, there, place});
    };
    bool isTold = false; // what the gas emits
    const auto tellEmission = [&](double before_m) {
        if (!isTold && lengths.front().from_m < before_m)
            add(nearest_m, GasRays::Behind::nothing, body, {});
        isTold = isTold || lengths.front().from_m < before_m;
    };
    for (const Pane& pane : panes) {
        tellEmission(pane.distance_m);
        // Of all gas of the ray, so that energy closes.
        if (isTold)
            add(nearest_m, GasRays::Behind::sender, pane.body, pane.place);
        Making::pass(passed, making.paneOf(pane.body, bodies_[pane.body].light->mesh().pieceOf(
                                                          pane.place.cell)));
    }
    tellEmission(infinity);
    if (met.cell != ExchangeMesh::none)
        add(nearest_m, GasRays::Behind::sender, metBody, met);
    else
        add(nearest_m, ray.direction.z > 0.0 ? GasRays::Behind::sky : GasRays::Behind::ground, body,
            {});
}

void LightExchange::gatherGas(std::span<const GasRays> found) {
    // Columns of each entity, by ray.
    std::map<int, std::vector<GasOnRay>> rays;
    for (const GasRays& own : found)
        for (const GasRays::Found& one : own.found)
            for (const auto& [entity, stretches] : one.gases)
                rays[entity].push_back({stretches, static_cast<double>(one.weight)});
    std::map<int, FewGasColumns> few;
    std::map<int, std::vector<std::size_t>> numbers; // of panes, by column
    for (const auto& [entity, own] : rays) {
        const FewGasColumns& columns =
            few.emplace(entity, FewGasColumns(own, mostGasColumns)).first->second;
        for (const GasColumnKey& column : columns.columns()) {
            numbers[entity].push_back(panes_.size());
            panes_.emplace_back(entity, gasColumnNumber(column));
        }
    }
    using Key = std::tuple<std::vector<std::size_t>, std::vector<std::size_t>>;
    struct Sums {
        std::vector<std::vector<LightPart>> pairs;
        std::vector<OutsideLight> leaving;
        std::vector<float> emitting;
    };
    std::map<Key, Sums> all;
    std::map<int, std::size_t> next; // ray of an entity
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
        const ExchangeNodes& nodes = bodies_[b].light->nodes();
        for (std::uint32_t patch = 0; patch < nodes.nodes(); ++patch) {
            const GasRays& own = found[firstReceiver_[b] + patch];
            for (const GasRays::Found& one : own.found) {
                Key key;
                for (const OccluderMaterial& pane : one.panes)
                    std::get<0>(key).push_back(
                        static_cast<std::size_t>(std::ranges::find(panes_, pane) - panes_.begin()));
                for (const auto& [entity, stretches] : one.gases)
                    std::get<1>(key).push_back(
                        numbers[entity][few.at(entity).columnOf(next[entity]++)]);
                Sums& sums = all[key];
                if (sums.pairs.empty()) {
                    sums.pairs.resize(rows_.size());
                    sums.leaving.resize(rows_.size());
                    sums.emitting.resize(rows_.size());
                }
                for (const ExchangeNodes::Share& share : ExchangeNodes::OfPlace(nodes, one.from)) {
                    const std::uint32_t receiver = firstReceiver_[b] + share.node;
                    const float part =
                        one.weight * share.part * own.scales[nodes.placeNear(patch, share.node)];
                    getsLight_[receiver] = true;
                    sees_[static_cast<std::size_t>(rows_[receiver])] = true;
                    switch (one.behind) {
                    case GasRays::Behind::nothing:
                        sums.emitting[receiver] += part;
                        break;
                    case GasRays::Behind::sky:
                        sums.leaving[receiver].sky += static_cast<double>(part);
                        break;
                    case GasRays::Behind::ground:
                        sums.leaving[receiver].ground += static_cast<double>(part);
                        break;
                    case GasRays::Behind::sender:
                        const ExchangeNodes& there = bodies_[one.metBody].light->nodes();
                        for (const ExchangeNodes::Share& sender :
                             ExchangeNodes::OfPlace(there, one.met).ofSenders(there))
                            sums.pairs[receiver].push_back({receiver,
                                                            firstSender_[one.metBody] + sender.node,
                                                            part * sender.part});
                        break;
                    }
                }
            }
        }
    }
    const std::vector<double> areas_m2 = areasOfSenders_m2();
    for (auto& [key, sums] : all) {
        LightThroughGas& gas = throughGas_.emplace_back();
        std::tie(gas.panes, gas.columns) = key;
        std::vector<std::vector<LightPart>> between(senders());
        for (std::size_t b = 0; b < bodies_.size(); ++b)
            for (std::uint32_t r = firstReceiver_[b]; r < firstReceiver_[b + 1]; ++r) {
                const std::uint32_t sender = senderOf_[r];
                const auto part = static_cast<float>(
                    bodies_[b].light->nodes().areaOf_m2(r - firstReceiver_[b]) / areas_m2[sender]);
                for (const LightPart& one : sums.pairs[r])
                    between[sender].push_back({sender, one.sender, part * one.factor});
            }
        gas.balance.pairs = std::make_shared<const LightPairs>(rows_.size(), std::move(sums.pairs));
        gas.balance.between = std::make_shared<const LightPairs>(senders(), std::move(between));
        gas.leaving = std::move(sums.leaving);
        gas.emitting = std::move(sums.emitting);
        const std::vector<double> means =
            meansOverSenders([&](std::size_t r) { return static_cast<double>(gas.emitting[r]); });
        gas.emittingToSenders.assign(means.begin(), means.end());
    }
    for (const LightThroughGas& gas : throughGas_)
        for (std::uint32_t r = 0; r < rows_.size(); ++r) {
            const auto [first, last] = gas.balance.pairs->of(r);
            for (const LightPair* pair = first; pair != last; ++pair)
                isSeen_[pair->sender] = true;
        }
}

void LightExchange::weighBehindGas(std::span<const OutsideLight> weights) {
    for (LightThroughGas& gas : throughGas_) {
        for (std::size_t r = 0; r < rows_.size(); ++r) {
            gas.leaving[r].sky *= weights[r].sky;
            gas.leaving[r].ground *= weights[r].ground;
        }
        gas.sky = meansOverSenders([&](std::size_t r) { return gas.leaving[r].sky; });
        gas.ground = meansOverSenders([&](std::size_t r) { return gas.leaving[r].ground; });
    }
}

} // namespace irsg
