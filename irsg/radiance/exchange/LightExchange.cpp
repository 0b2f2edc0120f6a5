#include "irsg/radiance/exchange/LightExchange.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include "irsg/core/ParallelFor.h"
#include "irsg/core/StageReport.h"
#include "irsg/radiance/exchange/LightExchangeMaking.h"
#include "irsg/radiometry/Units.h"

namespace irsg {

namespace {

/// Rays of a patch that sees nothing of its own body, but of others, at the usual error.
constexpr double raysToOthers = 128.0, usualError = 0.005;

} // namespace

LightExchange::LightExchange(std::vector<Body> bodies,
                             const std::vector<SunShadows::Caster>& casters,
                             const LightSources& sources, double error, bool hasLobes,
                             const std::vector<std::size_t>& components,
                             const std::vector<Gas>& gases)
    : bodies_(std::move(bodies)), hasLobes_(hasLobes) {
    numberComponents(components);
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
    for (const Making::Sphere& sphere : making.spheres)
        making.meetsTerrain.push_back(making.terrain &&
                                      top_m > sphere.centre_m.z - sphere.radius_m);
    for (const Body& body : bodies_)
        making.isNearGround.push_back(
            sources.groundReflectivity && !making.terrain &&
            isNearGround(body.extent, error, *sources.groundReflectivity));
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
        making.turned.push_back(making.isAlone(b) ? bodies_[b].light->turned() : nullptr);
        if (!making.isAlone(b))
            bodies_[b].light->forgetRays();
    }
    making.error = error;
    number(casters);
    areApart_ = making.areAllAlone() && gases.empty();
    if (std::ranges::find(making.isNearGround, true) != making.isNearGround.end()) {
        panes_.push_back(groundMaterial);
        groundReflectivity_ = sources.groundReflectivity;
    }
    if (std::ranges::any_of(paneOf_, [](int pane) { return pane >= 0; }))
        making.sunThrough.resize(cells_);
    takeSun(making);
    takePairs(making);
    if (!gases.empty())
        takeGas(making, gases);
    takeLight(making);
    takeOpenness();
    if (hasLobes_) {
        sunOnCells_ = std::move(making.sunOnCells);
        addReflected();
    }
}

void LightExchange::numberComponents(const std::vector<std::size_t>& components) {
    for (const std::size_t count : components) {
        firstComponentOf_.push_back(count > 0 ? static_cast<int>(components_) : -1);
        components_ += count;
    }
}

void LightExchange::addReflected() {
    const std::size_t count = firstGasChanges() + (throughGas_.empty() ? 0 : senders());
    for (std::uint32_t i = 0; i < count; ++i) {
        const auto number = static_cast<std::uint32_t>(receivers() + i);
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
    return other.crossSection_m2 * brighter >
           Making::negligiblePart * error * pi * apart_m * apart_m;
}

bool LightExchange::isNearGround(const Extent& body, double error, const Spectrum& reflectivity) {
    // Calm water, which reflects less than this, changes a ship by less than 0.05 %.
    constexpr double darkGround = 8.0;
    const double height_m = std::max(body.centre_m.z, 0.0);
    const double brightest = std::ranges::max(reflectivity.values());
    return brightest > darkGround * error &&
           brightest * body.radius_m * body.radius_m >
               Making::negligiblePart * error * height_m * height_m;
}

bool LightExchange::mayShade(const Extent& body, const Extent& other, const Vec3& towardsSun) {
    const Vec3 to_m = other.centre_m - body.centre_m;
    const double along_m = dot(to_m, towardsSun), both_m = body.radius_m + other.radius_m;
    return dot(to_m, to_m) <= both_m * both_m ||
           (along_m > 0.0 && dot(to_m, to_m) - along_m * along_m <= both_m * both_m);
}

void LightExchange::number(const std::vector<SunShadows::Caster>& casters) {
    std::uint32_t allNodes = 0;
    std::size_t vertices = 0;
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
        const ExchangeNodes& nodes = bodies_[b].light->nodes();
        firstCell_.push_back(cells_);
        cells_ += static_cast<std::uint32_t>(nodes.mesh().cells());
        firstReceiver_.push_back(allNodes);
        firstVertex_.push_back(vertices);
        vertices += nodes.mesh().vertices().size();
        firstSender_.push_back(static_cast<std::uint32_t>(rowOfSender_.size()));
        rowOfSender_.resize(rowOfSender_.size() + nodes.senders());
        for (const int row : casters[b].rows)
            ofRow_.resize(std::max(ofRow_.size(), static_cast<std::size_t>(std::max(row, -1) + 1)));
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
    }
    firstReceiver_.push_back(allNodes);
}

void LightExchange::takeOpenness() {
    std::vector<float> open(receivers());
    parallelForSmall(open.size(),
                     [&](std::uint32_t r) { open[r] = static_cast<float>(1.0 - seen(r)); });
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
        const ExchangeNodes& nodes = bodies_[b].light->nodes();
        const std::size_t first = firstVertex_[b], count = nodes.mesh().vertices().size();
        openOfVertex_.resize(first + count);
        parallelForSmall(count, [&](std::uint32_t vertex) {
            for (const ExchangeNodes::Share& share : nodes.sharesOf(vertex))
                openOfVertex_[first + vertex] += share.part * open[firstReceiver_[b] + share.node];
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
    StageCount count("pairs", receivers());
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
        const ExchangeNodes& nodes = bodies_[b].light->nodes();
        parallelForSmall(nodes.nodes(), [&](std::uint32_t patch) {
            count.add();
            making.told[firstReceiver_[b] + patch].resize(nodes.near(patch).size());
            if (!making.isSeen(bodies_[b], patch))
                return;
            if (making.isAlone(b))
                takeOwn(making, b, patch, making.turned[b]->rays[patch]);
            else
                takeWithOthers(making, b, patch);
        });
        if (!making.isAlone(b) && making.isApart(b))
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
    std::vector<const LightBalance*> own(bodies_.size());
    for (std::size_t b = 0; b < bodies_.size(); ++b)
        own[b] = &bodies_[b].light->balance();
    balance_ = withOwnOf(making,
                         making.areAllAlone()
                             ? LightBalance()
                             : balancedOfSenders(LightPairs(rows_.size(), std::move(making.parts)),
                                                 LightPairs(rows_.size(), std::move(making.oneWay)),
                                                 known, senderOf_, rowOfSender_.size()),
                         own);
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
    reflects_.resize(senders());
    for (std::size_t s = 0; s < senders(); ++s)
        reflects_[s] = isSeen_[s] && (!between().isEmpty(s) ||
                                      std::ranges::any_of(through_, [&](const LightThrough& one) {
                                          return !one.balance.between->isEmpty(s);
                                      }));
}

std::vector<double> LightExchange::areasOfSenders_m2() const {
    std::vector<double> areas_m2(senders());
    for (std::size_t b = 0; b < bodies_.size(); ++b)
        for (std::uint32_t r = firstReceiver_[b]; r < firstReceiver_[b + 1]; ++r)
            areas_m2[senderOf_[r]] += bodies_[b].light->nodes().areaOf_m2(r - firstReceiver_[b]);
    return areas_m2;
}

std::vector<double>
LightExchange::meansOverSenders(const std::function<double(std::size_t)>& of) const {
    const std::vector<double> areas_m2 = areasOfSenders_m2();
    std::vector<double> sums(senders());
    for (std::size_t b = 0; b < bodies_.size(); ++b)
        for (std::uint32_t r = firstReceiver_[b]; r < firstReceiver_[b + 1]; ++r)
            sums[senderOf_[r]] +=
                bodies_[b].light->nodes().areaOf_m2(r - firstReceiver_[b]) * of(r);
    for (std::size_t s = 0; s < senders(); ++s)
        sums[s] = areas_m2[s] > 0.0 ? sums[s] / areas_m2[s] : 0.0;
    return sums;
}

void LightExchange::takeLight(Making& making) {
    const LightSources& sources = making.sources;
    std::vector<Making::Told> sums(rows_.size());
    StageCount count("sky and ground", receivers());
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
        const ExchangeNodes& nodes = bodies_[b].light->nodes();
        parallelForSmall(nodes.nodes(), [&](std::uint32_t patch) {
            count.add();
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
    weighBehindGas(weights);
    if (!through_.empty()) {
        weighLeaving(weights);
        PaneClosure(passages_, panes_, paneOf_).closeSenders(between(), through_);
    }
    // As what comes from others in their place.
    sharpenSent(sky_, reflects_);
    sharpenSent(ground_, reflects_);
    for (LightThrough& one : through_) {
        sharpenSent(one.sky, reflects_);
        sharpenSent(one.ground, reflects_);
    }
    for (LightThroughGas& one : throughGas_) {
        sharpenSent(one.sky, reflects_);
        sharpenSent(one.ground, reflects_);
    }
}

void LightExchange::lightSide(Making& making, std::size_t body, std::uint32_t patch) const {
    const ExchangeNodes& nodes = bodies_[body].light->nodes();
    const LightSources& sources = making.sources;
    const Rotation& toWorld = making.toWorld[body];
    std::vector<Making::Told>& told = making.told[firstReceiver_[body] + patch];
    const auto isOfMatter = [&](const ExchangeNodes::Near& near) {
        const std::uint32_t receiver = firstReceiver_[body] + near.node;
        return isSeen(senderOf_[receiver]) || getsLight_[receiver] ||
               losses_[receiver].sky != 0.0 || losses_[receiver].ground != 0.0;
    };
    if (std::ranges::none_of(nodes.near(patch), isOfMatter))
        return;
    for (const std::uint32_t cell : nodes.cellsOf(patch)) {
        const double up = (toWorld * making.normal(bodies_, body, cell)).z;
        const double corner_m2 = making.area_m2(bodies_, body, cell) / 3.0;
        const double open_m2 = corner_m2 * 0.5 * (1.0 + up);
        const double weighted_m2 = corner_m2 * sources.skyOf(up);
        for (const std::uint32_t corner : nodes.mesh().corners(cell))
            for (const ExchangeNodes::Share& share : nodes.sharesOf(corner)) {
                Making::Told& own = told[nodes.placeNear(patch, share.node)];
                own.open_m2 += static_cast<double>(share.part) * open_m2;
                own.weighted_m2 += static_cast<double>(share.part) * weighted_m2;
            }
    }
}

} // namespace irsg
