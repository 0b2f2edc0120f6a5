// What bodies see of themselves, wherever they stand.
#include <algorithm>
#include <array>

#include "irsg/radiance/exchange/LightExchangeMaking.h"

namespace irsg {

void LightExchange::copyPairs(const LightPairs& pairs, std::size_t body,
                              std::vector<std::vector<LightPart>>& to) const {
    const std::uint32_t before = firstReceiver_[body], sendersBefore = firstSender_[body];
    for (std::uint32_t r = 0; r < pairs.receivers(); ++r) {
        const auto [first, last] = pairs.of(r);
        for (const LightPair* pair = first; pair != last; ++pair)
            to[before + r].push_back({before + r, sendersBefore + pair->sender, pair->factor});
    }
}

LightBalance LightExchange::withOwnOf(const Making& making, const LightBalance& common,
                                      const std::vector<const LightBalance*>& ofBodies) const {
    if (bodies_.size() == 1 && making.isAlone(0))
        return *ofBodies.front();
    bool isAnyAlone = false, areSame = true;
    for (std::size_t b = 0; b < bodies_.size(); ++b)
        isAnyAlone = isAnyAlone || making.isAlone(b);
    if (!isAnyAlone)
        return common;
    std::vector<LightPairs::Block> pairs, between;
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
        const ExchangeNodes& nodes = bodies_[b].light->nodes();
        const bool isOwn = making.isAlone(b);
        const LightBalance* const from = isOwn ? ofBodies[b] : &common;
        const std::size_t first = isOwn ? 0 : firstReceiver_[b];
        const std::size_t firstOfSenders = isOwn ? 0 : firstSender_[b];
        const std::uint32_t add = isOwn ? firstSender_[b] : 0;
        pairs.push_back({from ? from->pairs.get() : nullptr, first, nodes.nodes(), add});
        between.push_back(
            {from ? from->between.get() : nullptr, firstOfSenders, nodes.senders(), add});
        areSame = areSame && (from == nullptr || from->pairs == from->between);
    }
    LightBalance all;
    all.pairs = std::make_shared<const LightPairs>(pairs);
    all.between = areSame && senders() == receivers() ? all.pairs
                                                      : std::make_shared<const LightPairs>(between);
    return all;
}

void LightExchange::takeOwn(Making& making, std::size_t body, std::uint32_t patch,
                            const PatchRays& starts) const {
    const BodyLight& light = *bodies_[body].light;
    const ExchangeNodes& nodes = light.nodes();
    const std::uint32_t first = firstReceiver_[body], number = first + patch;
    const std::span<const BodyLight::LightRay> rays = light.raysOf(patch);
    const std::span<const float> scales = light.scalesOf(patch);
    const Vec3 up = making.toMesh[body] * Vec3{0.0, 0.0, 1.0};
    /// Of what rays of a cell bring its corners of the sun beside means.
    struct Sun {
        std::size_t set;
        std::uint32_t row;
        std::array<float, 3> ofCorners;
    };
    std::vector<Sun> suns;
    std::uint32_t next = 0;
    for (const PatchRays::OfCell& own : starts.cells) {
        std::array<double, 3> met{}, metUp{};
        suns.clear();
        for (; next < own.end; ++next) {
            const PatchRays::Ray& start = starts.rays[next];
            const BodyLight::LightRay& ray = rays[start.number];
            const bool isUp = up.x * static_cast<double>(start.along[0]) +
                                  up.y * static_cast<double>(start.along[1]) +
                                  up.z * static_cast<double>(start.along[2]) >
                              0.0;
            if (ray.passage > 0) {
                takeOwnPassed(making, body, patch, own.cell, start, isUp);
                continue;
            }
            const std::array<float, 3> parts{1.0f - start.u - start.v, start.u, start.v};
            for (std::size_t c = 0; c < 3; ++c) {
                met[c] += static_cast<double>(parts[c]);
                metUp[c] += isUp ? static_cast<double>(parts[c]) : 0.0;
            }
            for (std::size_t set = 0; set < making.sunBeside.size(); ++set) {
                if (making.sunBeside[set].empty())
                    continue;
                const Making::SunBeside& there =
                    making.sunBeside[set][firstCell_[body] + ray.place.cell];
                const float beside = there.at(ray.place.u, ray.place.v);
                if (beside == 0.0f)
                    continue;
                auto sun = std::ranges::find_if(
                    suns, [&](const Sun& one) { return one.set == set && one.row == there.row; });
                if (sun == suns.end())
                    sun = suns.insert(suns.end(), {set, there.row, {}});
                for (std::size_t c = 0; c < 3; ++c)
                    sun->ofCorners[c] += parts[c] * beside;
            }
        }
        const std::array<std::uint32_t, 3>& corners = nodes.mesh().corners(own.cell);
        for (std::size_t c = 0; c < 3; ++c)
            for (const ExchangeNodes::Share& share : nodes.sharesOf(corners[c])) {
                const std::size_t near = nodes.placeNear(patch, share.node);
                const float scale = share.part * scales[near];
                Making::Told& told = making.told[number][near];
                told.sky += static_cast<double>(scale) * metUp[c];
                told.ground += static_cast<double>(scale) * (met[c] - metUp[c]);
                for (const Sun& sun : suns)
                    making.sunPartsOf(number, passages_, {}, sun.set)
                        .push_back({first + share.node, sun.row, scale * sun.ofCorners[c]});
            }
    }
    if (!making.sunParts.empty())
        mergeParts(making.sunParts[number]);
}

void LightExchange::takeOwnPassed(Making& making, std::size_t body, std::uint32_t patch,
                                  std::uint32_t cell, const PatchRays::Ray& start,
                                  bool isUp) const {
    const BodyLight& light = *bodies_[body].light;
    const ExchangeNodes& nodes = light.nodes();
    const std::uint32_t first = firstReceiver_[body];
    const BodyLight::LightRay& ray = light.raysOf(patch)[start.number];
    const std::span<const float> scales = light.scalesOf(patch);
    std::vector<OccluderMaterial> passed = light.passages().materials(ray.passage);
    for (OccluderMaterial& material : passed)
        material.first = making.casters[body].entity;
    const ExchangeNodes::OfPlace from(nodes, {cell, start.u, start.v});
    if (ray.meetsAnything()) {
        tellOfSun(making, first + patch, passed, body, ray.place, [&](auto add) {
            for (const ExchangeNodes::Share& own : from)
                add(first + own.node, own.part * scales[nodes.placeNear(patch, own.node)]);
        });
        return;
    }
    for (const ExchangeNodes::Share& own : from) {
        const std::size_t near = nodes.placeNear(patch, own.node);
        leave(making, first + patch, passed, nodes.near(patch).size(), near, isUp,
              static_cast<double>(own.part * scales[near]));
    }
}

} // namespace irsg
