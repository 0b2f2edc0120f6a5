#include "irsg/radiance/exchange/LightExchange.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include "irsg/core/ParallelFor.h"
#include "irsg/radiometry/Units.h"
#include "irsg/render/rays/LightDirections.h"

namespace irsg {

namespace {

/// Rays of a patch that sees nothing of its own body, but of others, at the usual error.
constexpr double raysToOthers = 128.0, usualError = 0.005;
/// Rays that are followed behind the ground, of a body, and of a patch.
constexpr std::size_t raysToGround = 500'000, fewestToGround = 128, mostToGround = 1024;
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

void mergeInto(std::vector<LightPart>& all, const std::vector<LightPart>& more) {
    all.insert(all.end(), more.begin(), more.end());
}

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
    std::vector<float> sunOnCells{};                ///< as factors; none: it lights all alike
    std::vector<std::vector<LightPart>> sunParts{}; ///< by patch, of receivers and rows
    std::vector<FoundThrough> found{};              ///< by patch; none without panes
    /// By cell: what the sun gives it through sets of materials, as factors.
    std::vector<std::vector<std::pair<std::vector<OccluderMaterial>, float>>> sunThrough{};

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
    for (const Body& body : bodies_)
        making.isNearGround.push_back(
            sources.groundReflectivity && !making.terrain &&
            isNearGround(body.extent, error, *sources.groundReflectivity));
    making.error = error;
    number(casters);
    if (std::ranges::find(making.isNearGround, true) != making.isNearGround.end()) {
        panes_.push_back(groundMaterial);
        groundReflectivity_ = sources.groundReflectivity;
    }
    if (std::ranges::any_of(paneOf_, [](int pane) { return pane >= 0; }))
        making.sunThrough.resize(corners_.size());
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
    const std::size_t count = senders() + (1 + through_.size()) * rows();
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

bool LightExchange::isNearGround(const Extent& body, double error, const Spectrum& reflectivity) {
    const double height_m = std::max(body.centre_m.z, 0.0);
    return std::ranges::max(reflectivity.values()) * body.radius_m * body.radius_m >
           negligiblePart * error * height_m * height_m;
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
            const auto piece = static_cast<std::size_t>(nodes.pieceOf(r));
            paneOf_.resize(rowOfSender_.size(), -1);
            if (casters[b].uses[piece].pane == 0)
                continue;
            const OccluderMaterial material{casters[b].entity, casters[b].materials[piece]};
            const auto pane = std::ranges::find(panes_, material);
            paneOf_[senderOf_.back()] = static_cast<int>(pane - panes_.begin());
            if (pane == panes_.end())
                panes_.push_back(material);
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
    making.found.resize(panes_.empty() ? 0 : rows_.size());
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
        if ((bodies_.size() > 1 || !making.isAlone(b)) && making.isApart(b))
            copyPairs(*bodies_[b].light->balance().pairs, b, making.oneWay);
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
    if (!panes_.empty())
        takeThrough(making, known);
    sunBesideMean_ = LightPairs(rows_.size(), std::move(making.sunParts));
    sees_.assign(ofRow_.size(), false);
    getsLight_.assign(rows_.size(), false);
    isSeen_.assign(rowOfSender_.size(), hasLobes_);
    for (std::size_t r = 0; r < rows_.size(); ++r) {
        const auto [first, last] = pairs().of(r);
        getsLight_[r] = first != last;
        for (const LightThrough& one : through_)
            getsLight_[r] = getsLight_[r] || !one.balance.pairs->isEmpty(r) ||
                            one.leaving[r].sky != 0.0 || one.leaving[r].sun != 0.0;
        if (getsLight_[r] || losses_[r].sky != 0.0)
            sees_[static_cast<std::size_t>(rows_[r])] = true;
        for (const LightPair* pair = first; pair != last; ++pair)
            isSeen_[pair->sender] = true;
        for (const LightThrough& one : through_) {
            const auto [begin, end] = one.balance.pairs->of(r);
            for (const LightPair* pair = begin; pair != end; ++pair)
                isSeen_[pair->sender] = true;
        }
    }
}

LightThrough& LightExchange::throughOf(const std::vector<OccluderMaterial>& set) {
    const auto number = static_cast<std::size_t>(passages_.numberOf(set));
    if (number > through_.size()) {
        LightThrough& made = through_.emplace_back();
        for (const OccluderMaterial& material : set)
            made.panes.push_back(
                static_cast<std::size_t>(std::ranges::find(panes_, material) - panes_.begin()));
    }
    return through_[number - 1];
}

void LightExchange::takeThrough(Making& making, const std::vector<ReceiverRays>& known) {
    using Lists = std::vector<std::vector<LightPart>>;
    struct Found {
        Lists parts, oneWay;
    };
    std::vector<Found> found; // by passage, without the first
    const auto foundOf = [&](std::vector<OccluderMaterial> set) -> Found& {
        throughOf(set);
        found.resize(through_.size());
        Found& own = found[static_cast<std::size_t>(passages_.find(set)) - 1];
        own.parts.resize(rows_.size());
        own.oneWay.resize(rows_.size());
        return own;
    };
    const bool isOne = bodies_.size() == 1 && making.isAlone(0);
    std::vector<std::pair<std::size_t, LightBalance>> ofBody; // of the only one, by passage
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
        if (!isOne && !making.isApart(b))
            continue;
        const BodyLight& light = *bodies_[b].light;
        const auto count = std::min(light.passages().size(), BodyLight::mostPassages + 1);
        for (std::size_t p = 1; p < count; ++p) {
            std::vector<OccluderMaterial> set = light.passages().materials(static_cast<int>(p));
            for (OccluderMaterial& material : set)
                material.first = making.casters[b].entity;
            Found& own = foundOf(set);
            if (isOne)
                ofBody.emplace_back(static_cast<std::size_t>(passages_.find(set)),
                                    light.balance(static_cast<int>(p)));
            else
                copyPairs(*light.balance(static_cast<int>(p)).pairs, b, own.oneWay);
        }
    }
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
        const ExchangeNodes& nodes = bodies_[b].light->nodes();
        for (std::uint32_t patch = 0; patch < nodes.nodes(); ++patch)
            for (auto& [set, behind] : making.found[firstReceiver_[b] + patch].bySet) {
                const std::uint32_t number = firstReceiver_[b] + patch;
                Found& own = foundOf(set);
                const auto passage = static_cast<std::size_t>(passages_.find(set));
                if (!isOne) {
                    mergeInto(own.parts[number], behind.parts);
                    mergeInto(own.oneWay[number], behind.oneWay);
                }
                for (LightPart& part : behind.sun)
                    part.sender += static_cast<std::uint32_t>(passage * rows());
                if (!behind.sun.empty())
                    mergeInto(making.sunParts[number], behind.sun);
                if (behind.leaving.empty())
                    continue;
                LightThrough& one = through_[passage - 1];
                one.leaving.resize(rows_.size());
                const auto near = nodes.near(patch);
                for (std::size_t i = 0; i < near.size(); ++i) {
                    OutsideLight& sum = one.leaving[firstReceiver_[b] + near[i].node];
                    sum.sky += behind.leaving[i].sky;
                    sum.ground += behind.leaving[i].ground;
                    sum.sun += behind.leaving[i].sun;
                }
            }
    }
    making.found.clear();
    for (const auto& [passage, balance] : ofBody)
        through_[passage - 1].balance = balance;
    for (std::size_t i = 0; i < through_.size(); ++i) {
        LightThrough& one = through_[i];
        one.leaving.resize(rows_.size());
        one.sun.resize(senders());
        if (one.balance.pairs)
            continue;
        Found none{Lists(rows_.size()), Lists(rows_.size())};
        Found& own = i < found.size() && !found[i].parts.empty() && !isOne ? found[i] : none;
        one.balance = balancedOfSenders(LightPairs(rows_.size(), std::move(own.parts)),
                                        LightPairs(rows_.size(), std::move(own.oneWay)), known,
                                        senderOf_, senders());
    }
    addMissing(known);
    std::vector<double> isUp(rows_.size());
    parallelForSmall(rows_.size(), [&](std::uint32_t r) {
        const double lost = losses_[r].sky + losses_[r].ground;
        isUp[r] = lost > 0.0 ? std::clamp(losses_[r].sky / lost, 0.0, 1.0) : 0.5;
    });
    PaneClosure(passages_, panes_, paneOf_).closeReceivers(pairs(), isUp, through_);
}

/// Sets behind each transparent surface that is seen, even where no ray of its own went on there.
void LightExchange::addMissing(const std::vector<ReceiverRays>& known) {
    const auto look = [&](const LightPairs& pairs, const std::vector<OccluderMaterial>& set) {
        std::vector<bool> meets(panes_.size());
        for (std::uint32_t r = 0; r < pairs.receivers(); ++r) {
            const auto [first, last] = pairs.of(r);
            for (const LightPair* pair = first; pair != last; ++pair)
                if (paneOf_[pair->sender] >= 0)
                    meets[static_cast<std::size_t>(paneOf_[pair->sender])] = true;
        }
        for (std::size_t pane = 0; pane < panes_.size(); ++pane) {
            std::vector<OccluderMaterial> next = set;
            Making::pass(next, panes_[pane]);
            if (!meets[pane] || passages_.find(next) >= 0)
                continue;
            LightThrough& made = throughOf(next);
            const LightPairs nobody(rows_.size(), {});
            made.balance = balancedOfSenders(nobody, nobody, known, senderOf_, senders());
            made.leaving.resize(rows_.size());
            made.sun.resize(senders());
        }
    };
    look(pairs(), {});
    for (std::size_t i = 0; i < through_.size(); ++i) {
        const std::shared_ptr<const LightPairs> of = through_[i].balance.pairs;
        const std::vector<OccluderMaterial> set = passages_.materials(static_cast<int>(i + 1));
        look(*of, set);
    }
}

void LightExchange::weighLeaving(std::span<const OutsideLight> weights) {
    for (LightThrough& one : through_) {
        const bool isOfGround = std::ranges::any_of(
            one.panes, [&](std::size_t pane) { return panes_[pane] == groundMaterial; });
        std::vector<float> values(3 * rows_.size());
        for (std::size_t r = 0; r < rows_.size(); ++r) {
            OutsideLight& leaving = one.leaving[r];
            if (!isOfGround) {
                leaving.sky *= weights[r].sky;
                leaving.ground *= weights[r].ground;
            }
            values[3 * r] = static_cast<float>(leaving.sky);
            values[3 * r + 1] = static_cast<float>(leaving.ground);
            values[3 * r + 2] = static_cast<float>(leaving.sun);
        }
        const std::vector<double> ofGround =
            meansOverSenders([&](std::size_t r) { return one.leaving[r].sun; });
        for (std::size_t s = 0; s < senders(); ++s)
            one.sun[s] += ofGround[s];
        one.sky = meansOverSenders([&](std::size_t r) { return one.leaving[r].sky; });
        one.ground = meansOverSenders([&](std::size_t r) { return one.leaving[r].ground; });
        sharpen(values, 3);
        for (std::size_t r = 0; r < rows_.size(); ++r)
            one.leaving[r] = {static_cast<double>(values[3 * r]),
                              static_cast<double>(values[3 * r + 1]),
                              static_cast<double>(values[3 * r + 2])};
    }
}

std::vector<double>
LightExchange::meansOverSenders(const std::function<double(std::size_t)>& of) const {
    std::vector<double> sums(senders()), areas_m2(senders());
    for (std::size_t b = 0; b < bodies_.size(); ++b)
        for (std::uint32_t r = firstReceiver_[b]; r < firstReceiver_[b + 1]; ++r) {
            const double own_m2 = bodies_[b].light->nodes().areaOf_m2(r - firstReceiver_[b]);
            areas_m2[senderOf_[r]] += own_m2;
            sums[senderOf_[r]] += own_m2 * of(r);
        }
    for (std::size_t s = 0; s < senders(); ++s)
        sums[s] = areas_m2[s] > 0.0 ? sums[s] / areas_m2[s] : 0.0;
    return sums;
}

void LightExchange::takeOwn(Making& making, std::size_t body, std::uint32_t patch) const {
    const BodyLight& light = *bodies_[body].light;
    const ExchangeNodes& nodes = light.nodes();
    const std::uint32_t first = firstReceiver_[body];
    const BodyLight::Rays rays(nodes, patch);
    const std::span<const float> scales = light.scalesOf(patch);
    std::vector<OccluderMaterial> passed;
    for (const BodyLight::LightRay& ray : light.raysOf(patch)) {
        const BodyLight::LightStart start = rays.at(ray.index);
        const bool isUp = (making.toWorld[body] * start.ray.direction).z > 0.0;
        const ExchangeNodes::OfPlace from(nodes, start.from.place);
        if (ray.passage > 0) {
            passed = light.passages().materials(ray.passage);
            for (OccluderMaterial& material : passed)
                material.first = making.casters[body].entity;
        } else {
            passed.clear();
        }
        if (!ray.meetsAnything()) {
            for (const ExchangeNodes::Share& own : from) {
                const std::size_t near = nodes.placeNear(patch, own.node);
                leave(making, first + patch, passed, nodes.near(patch).size(), near, isUp,
                      static_cast<double>(own.part * scales[near]));
            }
            continue;
        }
        if (ray.passage > 0) {
            tellOfSun(making, first + patch, passed, body, ray.place, [&](auto add) {
                for (const ExchangeNodes::Share& own : from)
                    add(first + own.node, own.part * scales[nodes.placeNear(patch, own.node)]);
            });
            continue;
        }
        for (const ExchangeNodes::Share& own : from) {
            const std::size_t near = nodes.placeNear(patch, own.node);
            Making::Told& told = making.told[first + patch][near];
            (isUp ? told.sky : told.ground) += static_cast<double>(own.part * scales[near]);
        }
        tellOfSun(making, first + patch, passed, body, ray.place, [&](auto add) {
            for (const ExchangeNodes::Share& own : from)
                add(first + own.node, own.part * scales[nodes.placeNear(patch, own.node)]);
        });
    }
    if (!making.sunParts.empty())
        mergeParts(making.sunParts[first + patch]);
}

void LightExchange::leave(Making& making, std::uint32_t number,
                          const std::vector<OccluderMaterial>& passed, std::size_t nearCount,
                          std::size_t near, bool isUp, double part) {
    std::vector<OutsideLight>& leaving = making.found[number].bySet[passed].leaving;
    leaving.resize(nearCount);
    (isUp ? leaving[near].sky : leaving[near].ground) += part;
}

template <typename ForEachOwn>
void LightExchange::tellOfSun(Making& making, std::uint32_t number,
                              const std::vector<OccluderMaterial>& passed, std::size_t metBody,
                              const ExchangeMesh::Place& met, ForEachOwn forEachOwn) const {
    if (making.sunParts.empty())
        return;
    const ExchangeNodes& nodes = bodies_[metBody].light->nodes();
    const std::uint32_t cell = firstCell_[metBody] + met.cell;
    float beside = making.sunOnCells[cell];
    std::uint32_t sender = 0;
    const auto senders = ExchangeNodes::OfPlace(nodes, met).ofSenders(nodes);
    for (const ExchangeNodes::Share& share : senders) {
        sender = firstSender_[metBody] + share.node;
        beside -= share.part * static_cast<float>(sun_[sender]);
    }
    const auto row = static_cast<std::uint32_t>(rowOfSender_[sender]);
    std::vector<LightPart>& parts =
        passed.empty() ? making.sunParts[number] : making.found[number].bySet[passed].sun;
    if (beside != 0.0f)
        forEachOwn([&](std::uint32_t receiver, float part) {
            parts.push_back({receiver, row, part * beside});
        });
    for (std::size_t i = 0; i < through_.size(); ++i) {
        if (through_[i].sunOnCells.empty())
            continue;
        float more = through_[i].sunOnCells[cell];
        for (const ExchangeNodes::Share& share : senders)
            more -= share.part *
                    static_cast<float>(through_[i].sun[firstSender_[metBody] + share.node]);
        if (more == 0.0f)
            continue;
        std::vector<OccluderMaterial> all = passed;
        for (const OccluderMaterial& material : passages_.materials(static_cast<int>(i + 1)))
            Making::pass(all, material);
        std::vector<LightPart>& behind = making.found[number].bySet[all].sun;
        forEachOwn([&](std::uint32_t receiver, float part) {
            behind.push_back({receiver, row, part * more});
        });
    }
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
    takeSunThrough(making);
}

void LightExchange::takeSunThrough(const Making& making) {
    for (std::size_t cell = 0; cell < making.sunThrough.size(); ++cell)
        for (const auto& [set, sun] : making.sunThrough[cell]) {
            std::vector<float>& onCells = throughOf(set).sunOnCells;
            onCells.resize(corners_.size());
            onCells[cell] = sun;
        }
    std::vector<double> areas_m2(senders());
    for (std::size_t b = 0; b < bodies_.size() && !through_.empty(); ++b) {
        const ExchangeMesh& mesh = bodies_[b].light->mesh();
        for (std::uint32_t cell = 0; cell < mesh.cells(); ++cell)
            forEachReceiver(
                firstCell_[b] + cell, [&](std::uint32_t receiver, std::size_t, float part) {
                    const double own_m2 = static_cast<double>(part) * mesh.area_m2(cell) / 3.0;
                    areas_m2[senderOf_[receiver]] += own_m2;
                    for (LightThrough& one : through_) {
                        one.sun.resize(senders());
                        one.sun[senderOf_[receiver]] +=
                            own_m2 * static_cast<double>(one.sunOnCells[firstCell_[b] + cell]);
                    }
                });
    }
    for (LightThrough& one : through_)
        for (std::size_t s = 0; s < senders(); ++s)
            one.sun[s] = areas_m2[s] > 0.0 ? one.sun[s] / areas_m2[s] : 0.0;
}

double LightExchange::sunOn(Making& making, std::size_t body, std::uint32_t cell) const {
    const ExchangeMesh& mesh = bodies_[body].light->nodes().mesh();
    const Vec3& towardsSun = making.sources.towardsSun;
    const double cosine = dot(making.toWorld[body] * mesh.normal(cell), towardsSun);
    if (!(cosine > 0.0) || !making.sources.isSunShadowed)
        return std::max(cosine, 0.0);
    const std::array<Vec3, 3> c = mesh.cornersAt_m(cell);
    const Vec3 middle = (c[0] + c[1] + c[2]) * (1.0 / 3.0);
    const bool isOne = corners_.size() > fewCells;
    const double each = isOne ? 1.0 : 0.25;
    thread_local std::vector<int> through;
    double lit = 0.0;
    const auto look = [&](const Vec3& place) {
        const Vec3 from_m =
            making.casters[body].pose.toWorld(place + mesh.normal(cell) * mesh.lift_m());
        std::vector<OccluderMaterial> passed;
        for (const std::size_t i : making.shading[body]) {
            const SunShadows::Caster& other = making.casters[i];
            through.clear();
            if (!other.mesh->letsPass({making.toMesh[i] * (from_m - other.pose.position_m),
                                       making.toMesh[i] * towardsSun},
                                      other.uses, nullptr, through))
                return;
            for (const int piece : through)
                if (making.isPane(i, static_cast<std::size_t>(piece)))
                    Making::pass(passed, making.paneOf(i, static_cast<std::size_t>(piece)));
        }
        if (passed.empty()) {
            lit += each;
            return;
        }
        auto& known = making.sunThrough[firstCell_[body] + cell];
        auto own = std::ranges::find(known, passed,
                                     &std::pair<std::vector<OccluderMaterial>, float>::first);
        if (own == known.end())
            own = known.insert(known.end(), {passed, 0.0f});
        own->second += static_cast<float>(each * cosine);
    };
    look(middle);
    // The middles of the four triangles between corners and middles of edges.
    for (std::size_t i = 0; i < 3 && !isOne; ++i)
        look(middle * 0.5 + c[i] * 0.5);
    return cosine * lit;
}

void LightExchange::copyPairs(const LightPairs& pairs, std::size_t body,
                              std::vector<std::vector<LightPart>>& to) const {
    const std::uint32_t before = firstReceiver_[body], sendersBefore = firstSender_[body];
    for (std::uint32_t r = 0; r < pairs.receivers(); ++r) {
        const auto [first, last] = pairs.of(r);
        for (const LightPair* pair = first; pair != last; ++pair)
            to[before + r].push_back({before + r, sendersBefore + pair->sender, pair->factor});
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
                   negligiblePart * making.error * dot(to_m, to_m);
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
    std::vector<OutsideLight> weights(rows_.size()); // of parts of the hemisphere
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
            weights[r] = {open > 0.0 ? weighted / open : 0.0,
                          open < 1.0 ? (1.0 - weighted) / (1.0 - open) : 0.0, 1.0};
            loss.sky *= weights[r].sky;
            loss.ground *= weights[r].ground;
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
            losses_[r] = {static_cast<double>(lost[2 * r]), static_cast<double>(lost[2 * r + 1]),
                          0.0};
    for (std::size_t s = 0; s < senders(); ++s) {
        const bool isLit = sources.isSkyOn && isSeen(s) && area_m2[s] > 0.0;
        sky_[s] = isLit ? sky_[s] / area_m2[s] : 0.0;
        ground_[s] = isLit ? ground_[s] / area_m2[s] : 0.0;
    }
    if (through_.empty())
        return;
    weighLeaving(weights);
    PaneClosure(passages_, panes_, paneOf_).closeSenders(between(), through_);
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
