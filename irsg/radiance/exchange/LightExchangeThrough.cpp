#include <algorithm>
#include <map>
#include <utility>

#include "irsg/core/ParallelFor.h"
#include "irsg/radiance/exchange/LightExchangeMaking.h"

namespace irsg {

namespace {

void mergeInto(std::vector<LightPart>& all, const std::vector<LightPart>& more) {
    all.insert(all.end(), more.begin(), more.end());
}

} // namespace

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
    // Of bodies that are alone, by passage.
    std::map<std::size_t, std::vector<const LightBalance*>> ofBodies;
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
        if (!making.isAlone(b) && !making.isApart(b))
            continue;
        const BodyLight& light = *bodies_[b].light;
        const auto count = std::min(light.passages().size(), BodyLight::mostPassages + 1);
        for (std::size_t p = 1; p < count; ++p) {
            std::vector<OccluderMaterial> set = light.passages().materials(static_cast<int>(p));
            for (OccluderMaterial& material : set)
                material.first = making.casters[b].entity;
            Found& own = foundOf(set);
            if (making.isAlone(b)) {
                auto& ofSet = ofBodies[static_cast<std::size_t>(passages_.find(set))];
                ofSet.resize(bodies_.size());
                ofSet[b] = &light.balance(static_cast<int>(p));
            } else {
                copyPairs(*light.balance(static_cast<int>(p)).pairs, b, own.oneWay);
            }
        }
    }
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
        const ExchangeNodes& nodes = bodies_[b].light->nodes();
        for (std::uint32_t patch = 0; patch < nodes.nodes(); ++patch)
            for (auto& [set, behind] : making.found[firstReceiver_[b] + patch].bySet) {
                const std::uint32_t number = firstReceiver_[b] + patch;
                Found& own = foundOf(set);
                const auto passage = static_cast<std::size_t>(passages_.find(set));
                mergeInto(own.parts[number], behind.parts);
                mergeInto(own.oneWay[number], behind.oneWay);
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
    for (std::size_t i = 0; i < through_.size(); ++i) {
        LightThrough& one = through_[i];
        one.leaving.resize(rows_.size());
        one.sun.resize(senders());
        const auto alone = ofBodies.find(i + 1);
        if (alone == ofBodies.end() || !making.areAllAlone()) {
            Found none{Lists(rows_.size()), Lists(rows_.size())};
            Found& own = i < found.size() && !found[i].parts.empty() ? found[i] : none;
            one.balance = balancedOfSenders(LightPairs(rows_.size(), std::move(own.parts)),
                                            LightPairs(rows_.size(), std::move(own.oneWay)), known,
                                            senderOf_, senders());
        }
        if (alone != ofBodies.end())
            one.balance = withOwnOf(making, one.balance, alone->second);
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

void LightExchange::leave(Making& making, std::uint32_t number,
                          const std::vector<OccluderMaterial>& passed, std::size_t nearCount,
                          std::size_t near, bool isUp, double part) {
    std::vector<OutsideLight>& leaving = making.found[number].bySet[passed].leaving;
    leaving.resize(nearCount);
    (isUp ? leaving[near].sky : leaving[near].ground) += part;
}

void LightExchange::takeSunThrough(const Making& making) {
    for (std::size_t cell = 0; cell < making.sunThrough.size(); ++cell)
        for (const auto& [set, sun] : making.sunThrough[cell]) {
            std::vector<float>& onCells = throughOf(set).sunOnCells;
            onCells.resize(cells_);
            onCells[cell] = sun;
        }
    if (through_.empty())
        return;
    for (LightThrough& one : through_)
        one.sun.resize(senders());
    for (std::size_t b = 0; b < bodies_.size(); ++b)
        for (std::uint32_t cell = 0; cell < bodies_[b].light->mesh().cells(); ++cell) {
            if (making.sunThrough[firstCell_[b] + cell].empty())
                continue;
            const double corner_m2 = making.area_m2(bodies_, b, cell) / 3.0;
            forEachReceiver(firstCell_[b] + cell,
                            [&](std::uint32_t receiver, std::size_t, float part) {
                                for (LightThrough& one : through_)
                                    one.sun[senderOf_[receiver]] +=
                                        static_cast<double>(part) * corner_m2 *
                                        static_cast<double>(one.sunOnCells[firstCell_[b] + cell]);
                            });
        }
    const std::vector<double> areas_m2 = areasOfSenders_m2();
    for (LightThrough& one : through_)
        for (std::size_t s = 0; s < senders(); ++s)
            one.sun[s] = areas_m2[s] > 0.0 ? one.sun[s] / areas_m2[s] : 0.0;
}

} // namespace irsg
