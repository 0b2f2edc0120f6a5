#include "irsg/radiance/exchange/LightExchange.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include "irsg/core/ParallelFor.h"
#include "irsg/radiometry/Units.h"

namespace irsg {

namespace {

/// Rays of a patch that sees nothing of its own body, but of others, at the usual error.
constexpr double raysToOthers = 128.0, usualError = 0.005;
/// Cells of which each is divided in four to see how much of it the sun lights.
constexpr std::size_t fewCells = 60'000;
/// Of the error that is asked for: bodies that fill less of a hemisphere, as bright as they are
/// beside the other, are left out. At the usual error that is 0.001 of what a place that faces them
/// receives, and less than a tenth of what is stated for inter-reflection.
constexpr double negligiblePart = 0.2;

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

} // namespace

/// What is at hand while an exchange is made.
struct LightExchange::Making {
    /// What a patch tells a node near it: what is lost of sky and ground and, as areas in
    /// m2, how much of it sees the sky, with published weights or without.
    struct Told {
        double sky = 0.0, ground = 0.0;
        double rays = 0.0; ///< that began there, of patches that see nothing of their own body
        double open_m2 = 0.0, weighted_m2 = 0.0;
    };
    const std::vector<SunShadows::Caster>& casters;
    const LightSources& sources;
    std::vector<Rotation> toWorld{}, toMesh{};       ///< by caster
    std::vector<Sphere> spheres{};                   ///< by body
    std::vector<std::vector<std::size_t>> near{};    ///< bodies that a body may see
    std::vector<std::vector<std::size_t>> shading{}; ///< casters that may shade a body
    std::vector<bool> meetsTerrain{};                ///< by body
    const SunShadows::Caster* terrain = nullptr;
    std::size_t terrainNumber = 0;
    std::uint32_t raysToOthers = 0;
    std::vector<PieceUses> withBacks{};                    ///< by caster, see PieceUses
    std::vector<std::vector<LightPart>> parts{}, oneWay{}; ///< by patch
    std::vector<std::vector<Told>> told{};                 ///< by patch and near node
    std::vector<float> sunOnCells{};                ///< as factors; none: it lights all alike
    std::vector<std::vector<LightPart>> sunParts{}; ///< by patch, of receivers and rows

    /// Height of the highest place of the terrain, m.
    double terrainTop_m() const {
        double top_m = -1e300;
        for (std::size_t piece = 0; piece < terrain->mesh->pieces(); ++piece)
            for (unsigned f = 0; f < terrain->mesh->facetsOf(piece); ++f)
                for (const Vec3& corner : terrain->mesh->facet(piece, f).corners_m)
                    top_m = std::max(top_m, terrain->pose.toWorld(corner).z);
        return top_m;
    }
    bool isAlone(std::size_t body) const { return near[body].empty() && !meetsTerrain[body]; }
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

LightExchange::LightExchange(std::vector<Body> bodies,
                             const std::vector<SunShadows::Caster>& casters,
                             const LightSources& sources, double error, bool hasLobes)
    : bodies_(std::move(bodies)), hasLobes_(hasLobes) {
    Making making{casters, sources};
    // What rays of a sequence are off by falls as their number to the power of 2/3.
    making.raysToOthers =
        static_cast<std::uint32_t>(std::clamp(raysToOthers * std::pow(usualError / error, 1.5),
                                              64.0, static_cast<double>(BodyLight::mostRays)));
    for (const SunShadows::Caster& caster : casters) {
        making.toWorld.push_back(caster.pose.attitude.rotation());
        making.toMesh.push_back(making.toWorld.back().transposed());
        making.withBacks.push_back(caster.uses.withBacks());
        if (caster.entity < 0) {
            making.terrain = &caster;
            making.terrainNumber = making.toWorld.size() - 1;
        }
    }
    for (const Body& body : bodies_)
        making.spheres.push_back({body.extent.centre_m, body.extent.radius_m});
    for (std::size_t a = 0; a < bodies_.size(); ++a) {
        std::vector<std::size_t>& near = making.near.emplace_back();
        std::vector<std::size_t>& shading = making.shading.emplace_back();
        for (std::size_t b = 0; b < bodies_.size(); ++b) {
            const Extent &own = bodies_[a].extent, &other = bodies_[b].extent;
            // Both or none: pairs have two ends.
            if (a != b && (isNear(own, other, error) || isNear(other, own, error)))
                near.push_back(b);
            if (a == b || mayShade(own, other, sources.towardsSun))
                shading.push_back(b);
        }
        if (making.terrain)
            shading.push_back(making.terrainNumber);
    }
    const double top_m = making.terrain ? making.terrainTop_m() : 0.0;
    for (const Sphere& sphere : making.spheres)
        making.meetsTerrain.push_back(making.terrain &&
                                      top_m > sphere.centre_m.z - sphere.radius_m);
    number(casters);
    takeSun(making);
    takePairs(making);
    takeLight(making);
    if (hasLobes_) {
        sunOnCells_ = std::move(making.sunOnCells);
        addReflected();
    }
}

void LightExchange::addReflected() {
    firstReflected_ = static_cast<std::uint32_t>(corners_.size());
    const std::size_t count = senders() + rows();
    for (std::uint32_t i = 0; i < count; ++i) {
        const auto number = static_cast<std::uint32_t>(receivers() + i);
        const auto vertex = static_cast<std::uint32_t>(firstShare_.size() - 1);
        corners_.push_back({vertex, vertex, vertex});
        shares_.push_back({number, 1.0f});
        firstShare_.push_back(static_cast<std::uint32_t>(shares_.size()));
        local_.push_back(i);
        reflected_.push_back(number);
    }
    losses_.resize(receivers() + count);
}

bool LightExchange::isNear(const Extent& body, const Extent& other, double error) {
    const double apart_m = length(other.centre_m - body.centre_m) - body.radius_m;
    if (apart_m <= other.radius_m)
        return true;
    double brighter = 1.0;
    for (std::size_t i = 0; i < other.emits.size(); ++i)
        if (other.emits[i] > brighter * body.emits[i])
            brighter = body.emits[i] > 0.0 ? other.emits[i] / body.emits[i]
                                           : std::numeric_limits<double>::infinity();
    return other.crossSection_m2 * brighter > negligiblePart * error * pi * apart_m * apart_m;
}

bool LightExchange::mayShade(const Extent& body, const Extent& other, const Vec3& towardsSun) {
    const Vec3 to_m = other.centre_m - body.centre_m;
    const double along_m = dot(to_m, towardsSun), both_m = body.radius_m + other.radius_m;
    return dot(to_m, to_m) <= both_m * both_m ||
           (along_m > 0.0 && dot(to_m, to_m) - along_m * along_m <= both_m * both_m);
}

void LightExchange::number(const std::vector<SunShadows::Caster>& casters) {
    std::uint32_t allNodes = 0, vertices = 0;
    firstShare_.push_back(0);
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
        const ExchangeNodes& nodes = bodies_[b].light->nodes();
        const ExchangeMesh& mesh = nodes.mesh();
        firstCell_.push_back(static_cast<std::uint32_t>(corners_.size()));
        firstReceiver_.push_back(allNodes);
        firstSender_.push_back(static_cast<std::uint32_t>(rowOfSender_.size()));
        rowOfSender_.resize(rowOfSender_.size() + nodes.senders());
        for (const int row : casters[b].rows)
            ofRow_.resize(std::max(ofRow_.size(), static_cast<std::size_t>(std::max(row, -1) + 1)));
        for (std::uint32_t t = 0; t < mesh.cells(); ++t) {
            const auto& own = mesh.corners(t);
            corners_.push_back({own[0] + vertices, own[1] + vertices, own[2] + vertices});
        }
        for (std::uint32_t v = 0; v < mesh.vertices().size(); ++v) {
            for (const ExchangeNodes::Share& share : nodes.sharesOf(v))
                shares_.push_back({share.node + allNodes, share.part});
            firstShare_.push_back(static_cast<std::uint32_t>(shares_.size()));
        }
        for (std::uint32_t r = 0; r < nodes.nodes(); ++r) {
            const int row = casters[b].rows[static_cast<std::size_t>(nodes.pieceOf(r))];
            rows_.push_back(row);
            senderOf_.push_back(firstSender_[b] + nodes.senderOf(r));
            rowOfSender_[senderOf_.back()] = row;
            if (static_cast<std::size_t>(row) >= ofRow_.size())
                ofRow_.resize(static_cast<std::size_t>(row) + 1);
            std::vector<std::uint32_t>& ofRow = ofRow_[static_cast<std::size_t>(row)];
            local_.push_back(static_cast<std::uint32_t>(ofRow.size()));
            ofRow.push_back(static_cast<std::uint32_t>(rows_.size() - 1));
        }
        allNodes += static_cast<std::uint32_t>(nodes.nodes());
        vertices += static_cast<std::uint32_t>(mesh.vertices().size());
    }
    firstReceiver_.push_back(allNodes);
}

std::array<float, 3> LightExchange::openAt(std::uint32_t cell) const {
    std::array<float, 3> open{};
    for (std::size_t c = 0; c < 3; ++c)
        forEachReceiver(cell, c == 1 ? 1.0f : 0.0f, c == 2 ? 1.0f : 0.0f,
                        [&](std::uint32_t receiver, float part) {
                            open[c] += part * static_cast<float>(1.0 - seen(receiver));
                        });
    return open;
}

void LightExchange::sharpen(std::vector<float>& values, std::size_t width) const {
    const std::vector<float> before = values;
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
        const LightPairs& smoothing = bodies_[b].light->nodes().smoothing();
        const std::size_t first = firstReceiver_[b];
        parallelForSmall(smoothing.receivers(), [&](std::uint32_t r) {
            if (smoothing.isEmpty(r))
                return;
            std::vector<float> mean(width);
            smoothing.gather(r, std::span(before).subspan(first * width), width, mean.data());
            float* const own = &values[(first + r) * width];
            for (std::size_t c = 0; c < width; ++c)
                own[c] = 2.0f * own[c] - mean[c];
        });
    }
}

void LightExchange::takePairs(Making& making) {
    losses_.resize(rows_.size());
    making.parts.resize(rows_.size());
    making.oneWay.resize(rows_.size());
    making.told.resize(rows_.size());
    making.sunParts.resize(making.sunOnCells.empty() ? 0 : rows_.size());
    std::vector<ReceiverRays> known;
    for (const Body& body : bodies_)
        for (std::uint32_t r = 0; r < body.light->nodes().nodes(); ++r)
            known.push_back({body.light->nodes().areaOf_m2(r), body.light->raysFrom(r)});
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
        const ExchangeNodes& nodes = bodies_[b].light->nodes();
        parallelForSmall(nodes.nodes(), [&](std::uint32_t patch) {
            making.told[firstReceiver_[b] + patch].resize(nodes.near(patch).size());
            if (!making.isSeen(bodies_[b], patch))
                return;
            if (making.isAlone(b))
                takeOwn(making, b, patch);
            else
                takeWithOthers(making, b, patch);
        });
        if (bodies_.size() > 1 && making.isApart(b))
            copyPairs(making, b);
        for (std::uint32_t patch = 0; patch < nodes.nodes(); ++patch) {
            const auto near = nodes.near(patch);
            for (std::size_t i = 0; i < near.size(); ++i) {
                const Making::Told& told = making.told[firstReceiver_[b] + patch][i];
                Loss& loss = losses_[firstReceiver_[b] + near[i].node];
                loss.sky += told.sky;
                loss.ground += told.ground;
                known[firstReceiver_[b] + near[i].node].rays += told.rays;
            }
        }
    }
    if (bodies_.size() == 1 && making.isAlone(0))
        balance_ = bodies_.front().light->balance();
    else
        balance_ = balancedOfSenders(LightPairs(rows_.size(), std::move(making.parts)),
                                     LightPairs(rows_.size(), std::move(making.oneWay)), known,
                                     senderOf_, rowOfSender_.size());
    sunBesideMean_ = LightPairs(rows_.size(), std::move(making.sunParts));
    sees_.assign(ofRow_.size(), false);
    isSeen_.assign(rowOfSender_.size(), hasLobes_);
    for (std::size_t r = 0; r < rows_.size(); ++r) {
        const auto [first, last] = pairs().of(r);
        if (first != last || losses_[r].sky != 0.0)
            sees_[static_cast<std::size_t>(rows_[r])] = true;
        for (const LightPair* pair = first; pair != last; ++pair)
            isSeen_[pair->sender] = true;
    }
}

void LightExchange::takeOwn(Making& making, std::size_t body, std::uint32_t patch) const {
    const BodyLight& light = *bodies_[body].light;
    const ExchangeNodes& nodes = light.nodes();
    const std::uint32_t first = firstReceiver_[body];
    const BodyLight::Rays rays(nodes, patch);
    const std::span<const float> scales = light.scalesOf(patch);
    for (const BodyLight::LightRay& ray : light.raysOf(patch)) {
        const BodyLight::LightStart start = rays.at(ray.index);
        const bool isUp = (making.toWorld[body] * start.ray.direction).z > 0.0;
        const ExchangeNodes::OfPlace from(nodes, start.from.place);
        for (const ExchangeNodes::Share& own : from) {
            const std::size_t near = nodes.placeNear(patch, own.node);
            Making::Told& told = making.told[first + patch][near];
            (isUp ? told.sky : told.ground) += static_cast<double>(own.part * scales[near]);
        }
        tellOfSun(making, first + patch, body, ray.place, [&](auto add) {
            for (const ExchangeNodes::Share& own : from)
                add(first + own.node, own.part * scales[nodes.placeNear(patch, own.node)]);
        });
    }
    if (!making.sunParts.empty())
        mergeParts(making.sunParts[first + patch]);
}

template <typename ForEachOwn>
void LightExchange::tellOfSun(Making& making, std::uint32_t number, std::size_t metBody,
                              const ExchangeMesh::Place& met, ForEachOwn forEachOwn) const {
    if (making.sunParts.empty())
        return;
    const ExchangeNodes& nodes = bodies_[metBody].light->nodes();
    float beside = making.sunOnCells[firstCell_[metBody] + met.cell];
    std::uint32_t sender = 0;
    for (const ExchangeNodes::Share& share : ExchangeNodes::OfPlace(nodes, met).ofSenders(nodes)) {
        sender = firstSender_[metBody] + share.node;
        beside -= share.part * static_cast<float>(sun_[sender]);
    }
    const auto row = static_cast<std::uint32_t>(rowOfSender_[sender]);
    if (beside != 0.0f)
        forEachOwn([&](std::uint32_t receiver, float part) {
            making.sunParts[number].push_back({receiver, row, part * beside});
        });
}

/// What falls on cells, and its means over senders.
void LightExchange::takeSun(Making& making) {
    const LightSources& sources = making.sources;
    sun_.assign(senders(), sources.isSunOn ? std::max(sources.sunAlways, 0.0) : 0.0);
    if (!sources.isSunOn || sources.sunAlways >= 0.0)
        return;
    making.sunOnCells.resize(corners_.size());
    std::vector<double> area_m2(senders());
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
        const ExchangeNodes& nodes = bodies_[b].light->nodes();
        const ExchangeMesh& mesh = nodes.mesh();
        // What sees nothing of its own body, nothing of that sees; others may.
        const auto isSeenByAny = [&](std::uint32_t cell) {
            return mesh.seesAnything(cell) || !making.isAlone(b);
        };
        parallelForSmall(mesh.cells(), [&](std::uint32_t cell) {
            if (isSeenByAny(cell))
                making.sunOnCells[firstCell_[b] + cell] =
                    static_cast<float>(sunOn(making, b, cell));
        });
        for (std::uint32_t cell = 0; cell < mesh.cells(); ++cell) {
            if (!isSeenByAny(cell))
                continue;
            const float sun = making.sunOnCells[firstCell_[b] + cell];
            for (const std::uint32_t corner : mesh.corners(cell))
                for (const ExchangeNodes::Share& share : nodes.sharesOf(corner)) {
                    const std::uint32_t sender = senderOf_[firstReceiver_[b] + share.node];
                    const double own_m2 =
                        static_cast<double>(share.part) * mesh.area_m2(cell) / 3.0;
                    area_m2[sender] += own_m2;
                    sun_[sender] += own_m2 * static_cast<double>(sun);
                }
        }
    }
    for (std::size_t s = 0; s < senders(); ++s)
        sun_[s] = area_m2[s] > 0.0 ? sun_[s] / area_m2[s] : 0.0;
}

double LightExchange::sunOn(const Making& making, std::size_t body, std::uint32_t cell) const {
    const ExchangeMesh& mesh = bodies_[body].light->nodes().mesh();
    const Vec3& towardsSun = making.sources.towardsSun;
    const double cosine = dot(making.toWorld[body] * mesh.normal(cell), towardsSun);
    if (!(cosine > 0.0) || !making.sources.isSunShadowed)
        return std::max(cosine, 0.0);
    const std::array<Vec3, 3> c = mesh.cornersAt_m(cell);
    const Vec3 middle = (c[0] + c[1] + c[2]) * (1.0 / 3.0);
    thread_local std::vector<int> through;
    const auto isLit = [&](const Vec3& place) {
        const Vec3 from_m =
            making.casters[body].pose.toWorld(place + mesh.normal(cell) * mesh.lift_m());
        for (const std::size_t i : making.shading[body]) {
            const SunShadows::Caster& other = making.casters[i];
            through.clear();
            if (!other.mesh->letsPass({making.toMesh[i] * (from_m - other.pose.position_m),
                                       making.toMesh[i] * towardsSun},
                                      other.uses, nullptr, through))
                return false;
        }
        return true;
    };
    double lit = isLit(middle) ? 1.0 : 0.0;
    if (corners_.size() <= fewCells) {
        // The middles of the four triangles between corners and middles of edges.
        for (std::size_t i = 0; i < 3; ++i)
            lit += isLit(middle * 0.5 + c[i] * 0.5) ? 1.0 : 0.0;
        lit *= 0.25;
    }
    return cosine * lit;
}

void LightExchange::copyPairs(Making& making, std::size_t body) const {
    const LightPairs& pairs = *bodies_[body].light->balance().pairs;
    const std::uint32_t before = firstReceiver_[body], sendersBefore = firstSender_[body];
    for (std::uint32_t r = 0; r < pairs.receivers(); ++r) {
        const auto [first, last] = pairs.of(r);
        for (const LightPair* pair = first; pair != last; ++pair)
            making.oneWay[before + r].push_back(
                {before + r, sendersBefore + pair->sender, pair->factor});
    }
}

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
                const Sphere& sphere = making.spheres[other];
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
    const SunShadows::Caster& caster = making.casters[body];
    const std::uint32_t number = firstReceiver_[body] + patch;
    const auto near = nodes.near(patch);
    const std::uint32_t count = light.sent(patch) > 0 ? light.sent(patch) : making.raysToOthers;
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
    const bool isTransparent =
        caster.uses[static_cast<std::size_t>(nodes.pieceOf(patch))].transparent;
    RayHit hit;
    std::vector<RayHit> through;
    auto met = light.raysOf(patch).begin();
    const auto lastMet = light.raysOf(patch).end();
    const bool isApart = making.isApart(body);
    const bool isMetByOthers = making.meetsTerrain[body] || hasOthersAbove(making, body, patch);
    for (std::uint32_t i = 0; i < count; ++i) {
        if (!isMetByOthers && met == lastMet)
            break;
        if (!isMetByOthers)
            i = met->index; // other rays meet nothing
        const BodyLight::LightStart start = rays.at(i);
        const Vec3 from_m = caster.pose.toWorld(start.ray.origin_m);
        const Vec3 along = making.toWorld[body] * start.ray.direction;
        double nearest_m = std::numeric_limits<double>::infinity();
        double nearestBack_m = std::numeric_limits<double>::infinity();
        ExchangeMesh::Place place;
        std::size_t metBody = body;
        bool isOneWay = false;
        if (met != lastMet && met->index == i) {
            place = met->place;
            isOneWay = met->isOneWay;
            nearest_m = static_cast<double>(met->distance_m);
            ++met;
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
        for (const std::size_t other : making.near[body])
            if (making.spheres[other].isMetBy(from_m, along) && isBefore(other)) {
                nearest_m = hit.distance_m;
                place = bodies_[other].light->mesh().placeOf(hit);
                metBody = other;
            }
        const auto tell = [&](auto add) {
            for (const ExchangeNodes::Share& share :
                 ExchangeNodes::OfPlace(nodes, start.from.place)) {
                const std::size_t n = nodes.placeNear(patch, share.node);
                add(share.node, making.told[number][n], share.part * scales[n]);
            }
        };
        if (making.meetsTerrain[body] && along.z > 0.0 && isBefore(making.terrainNumber)) {
            // Terrain is ground, wherever it stands.
            tell([](std::uint32_t, Making::Told& told, float part) {
                told.sky += static_cast<double>(part);
                told.ground -= static_cast<double>(part);
            });
            continue;
        }
        if (place.cell == ExchangeMesh::none)
            continue;
        if (metBody != body)
            isOneWay = isTransparent || leavesThroughBack(making, body, start.ray, nearest_m);
        isOneWay = isOneWay || nearestBack_m < nearest_m;
        std::vector<LightPart>& parts = (isOneWay ? making.oneWay : making.parts)[number];
        tellOfSun(making, number, metBody, place, [&](auto add) {
            tell([&](std::uint32_t node, Making::Told&, float part) {
                add(firstReceiver_[body] + node, part);
            });
        });
        if (metBody == body && isApart) { // its pairs are known
            tell([&](std::uint32_t, Making::Told& told, float part) {
                (along.z > 0.0 ? told.sky : told.ground) += static_cast<double>(part);
            });
            continue;
        }
        const ExchangeNodes& nodesThere = bodies_[metBody].light->nodes();
        const auto senders = ExchangeNodes::OfPlace(nodesThere, place).ofSenders(nodesThere);
        tell([&](std::uint32_t node, Making::Told& told, float part) {
            (along.z > 0.0 ? told.sky : told.ground) += static_cast<double>(part);
            for (const ExchangeNodes::Share& sender : senders)
                parts.push_back({firstReceiver_[body] + node, firstSender_[metBody] + sender.node,
                                 part * sender.part});
        });
    }
    mergeParts(making.parts[number]);
    mergeParts(making.oneWay[number]);
    if (!making.sunParts.empty())
        mergeParts(making.sunParts[number]);
}

void LightExchange::takeLight(Making& making) {
    const LightSources& sources = making.sources;
    std::vector<Making::Told> sums(rows_.size());
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
        const ExchangeNodes& nodes = bodies_[b].light->nodes();
        parallelForSmall(nodes.nodes(), [&](std::uint32_t patch) {
            if (making.isSeen(bodies_[b], patch))
                lightSide(making, b, patch);
        });
        for (std::uint32_t patch = 0; patch < nodes.nodes(); ++patch) {
            const auto near = nodes.near(patch);
            for (std::size_t i = 0; i < near.size(); ++i) {
                const Making::Told& told = making.told[firstReceiver_[b] + patch][i];
                Making::Told& sum = sums[firstReceiver_[b] + near[i].node];
                sum.open_m2 += told.open_m2;
                sum.weighted_m2 += told.weighted_m2;
            }
        }
    }
    sky_.assign(senders(), 0.0);
    ground_.assign(senders(), 0.0);
    std::vector<double> area_m2(senders());
    for (std::size_t b = 0; b < bodies_.size(); ++b)
        for (std::uint32_t r = firstReceiver_[b]; r < firstReceiver_[b + 1]; ++r) {
            const double own_m2 = bodies_[b].light->nodes().areaOf_m2(r - firstReceiver_[b]);
            if (!(own_m2 > 0.0))
                continue;
            const double open = sums[r].open_m2 / own_m2;
            const double weighted = sums[r].weighted_m2 / own_m2;
            // Published weights are those of what is seen, in the same ratio for what is not.
            Loss& loss = losses_[r];
            // Its own rays tell where others stand, those of all how much of it they fill.
            const double lost = loss.sky + loss.ground, more = seen(r) - lost;
            const double up = lost > 1e-9 ? std::clamp(loss.sky / lost, 0.0, 1.0) : open;
            loss.sky += up * more;
            loss.ground += (1.0 - up) * more;
            loss.sky *= open > 0.0 ? weighted / open : 0.0;
            loss.ground *= open < 1.0 ? (1.0 - weighted) / (1.0 - open) : 0.0;
            const std::uint32_t sender = senderOf_[r];
            area_m2[sender] += own_m2;
            sky_[sender] += own_m2 * (weighted - loss.sky);
            ground_[sender] += own_m2 * (1.0 - weighted - loss.ground);
        }
    std::vector<float> lost(2 * losses_.size());
    for (std::size_t r = 0; r < losses_.size(); ++r) {
        lost[2 * r] = static_cast<float>(losses_[r].sky);
        lost[2 * r + 1] = static_cast<float>(losses_[r].ground);
    }
    sharpen(lost, 2);
    for (std::size_t r = 0; r < losses_.size(); ++r)
        if (!pairs().isEmpty(r)) // else it gets nothing in their place
            losses_[r] = {static_cast<double>(lost[2 * r]), static_cast<double>(lost[2 * r + 1])};
    for (std::size_t s = 0; s < senders(); ++s) {
        const bool isLit = sources.isSkyOn && isSeen(s) && area_m2[s] > 0.0;
        sky_[s] = isLit ? sky_[s] / area_m2[s] : 0.0;
        ground_[s] = isLit ? ground_[s] / area_m2[s] : 0.0;
    }
}

void LightExchange::lightSide(Making& making, std::size_t body, std::uint32_t patch) const {
    const ExchangeNodes& nodes = bodies_[body].light->nodes();
    const LightSources& sources = making.sources;
    const Rotation& toWorld = making.toWorld[body];
    std::vector<Making::Told>& told = making.told[firstReceiver_[body] + patch];
    const auto isOfMatter = [&](const ExchangeNodes::Near& near) {
        const std::uint32_t receiver = firstReceiver_[body] + near.node;
        return isSeen(senderOf_[receiver]) || !pairs().isEmpty(receiver) ||
               losses_[receiver].sky != 0.0 || losses_[receiver].ground != 0.0;
    };
    if (std::ranges::none_of(nodes.near(patch), isOfMatter))
        return;
    for (const std::uint32_t cell : nodes.cellsOf(patch)) {
        const double up = (toWorld * nodes.mesh().normal(cell)).z;
        const double open_m2 = nodes.mesh().area_m2(cell) / 3.0 * 0.5 * (1.0 + up);
        const double weighted_m2 = nodes.mesh().area_m2(cell) / 3.0 * sources.skyOf(up);
        for (const std::uint32_t corner : nodes.mesh().corners(cell))
            for (const ExchangeNodes::Share& share : nodes.sharesOf(corner)) {
                Making::Told& own = told[nodes.placeNear(patch, share.node)];
                own.open_m2 += static_cast<double>(share.part) * open_m2;
                own.weighted_m2 += static_cast<double>(share.part) * weighted_m2;
            }
    }
}

} // namespace irsg
