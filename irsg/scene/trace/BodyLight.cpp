#include "irsg/scene/trace/BodyLight.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace irsg {

/// What a side of a patch has sent.
struct BodyLight::Sending {
    /// How many rays meet the body, their directions, and how many meet each of some halves of its
    /// pieces, of which any two are told apart: in a cavity all rays meet something.
    static constexpr std::size_t halves = 4;
    using Moments = std::array<double, 4 + halves>;

    std::uint32_t sent = 0;
    std::vector<LightRay> hits;
    std::vector<double> weights; ///< by near node: its parts of the places where rays begin
    Moments moments{}, ofFirstHalf{};

    /// Of the part of its hemisphere that it sees.
    double error() const {
        double most = 0.0;
        for (std::size_t i = 0; i < moments.size(); ++i)
            most = std::max(most, std::abs(2.0 * ofFirstHalf[i] - moments[i]) / sent);
        return most;
    }
};

BodyLight::Rays::Rays(const LightNodes& nodes, std::uint32_t side)
    : nodes_(nodes), side_(side), points_(side) {}

BodyLight::LightStart BodyLight::Rays::at(std::uint32_t index) const {
    const LightPoint point = points_.at(index);
    LightStart start{nodes_.start(side_, point[0], point[1], point[2]), {}};
    start.ray = {start.from.at_m, cosineDirection(start.from.normal, point[3], point[4])};
    return start;
}

BodyLight::BodyLight(std::shared_ptr<const LightNodes> nodes, const PieceUses& uses, double error)
    : nodes_(std::move(nodes)) {
    std::vector<Sending> sendings(nodes_->receivers());
    refine(sendings, uses, error);
    gather(sendings);
}

void BodyLight::refine(std::vector<Sending>& sendings, const PieceUses& uses, double error) {
    std::vector<std::uint32_t> active;
    double area_m2 = 0.0;
    for (std::uint32_t side = 0; side < sendings.size(); ++side) {
        const PieceUse& use = uses[static_cast<std::size_t>(nodes_->pieceOf(side / 2))];
        const bool isSeen =
            use.isThere && (side % 2 == 0 || use.transparent || !use.cullsBackFaces);
        if (isSeen && nodes_->patchArea_m2(side / 2) > 0.0 && nodes_->seesAnything(side)) {
            active.push_back(side);
            area_m2 += nodes_->patchArea_m2(side / 2);
        }
    }
    const std::vector<std::uint32_t> all = active;
    // A node has the mean of the patches near it, whose errors know nothing of each other.
    const auto partsOfError_m2 = [&](std::uint32_t side) {
        double sum_m2 = 0.0;
        for (const LightNodes::Near& near : nodes_->near(side / 2))
            sum_m2 +=
                std::pow(static_cast<double>(near.area_m2), 2.0) / nodes_->areaOf_m2(near.node);
        return sum_m2 * std::pow(sendings[side].error(), 2.0);
    };
    while (!active.empty()) {
        forEachOf(active.size(), [&](std::uint32_t i) {
            Sending& sending = sendings[active[i]];
            send(sending, active[i], uses, std::max(fewestRays, 2 * sending.sent));
        });
        double squares_m2 = 0.0;
        allSent_ = 0;
        for (const std::uint32_t side : all) {
            squares_m2 += partsOfError_m2(side);
            allSent_ += sendings[side].sent;
        }
        error_ = std::sqrt(squares_m2 / area_m2);
        if (error_ <= error)
            return;
        std::erase_if(active, [&](std::uint32_t side) {
            return sendings[side].sent >= mostRays ||
                   partsOfError_m2(side) <= error * error * nodes_->patchArea_m2(side / 2);
        });
        // Where there is no room for all, those come first that matter most.
        std::ranges::stable_sort(active, std::greater<>(), partsOfError_m2);
        std::size_t next = allSent_;
        std::erase_if(active, [&](std::uint32_t side) {
            const bool fits = next + sendings[side].sent <= mostSent;
            next += fits ? sendings[side].sent : 0;
            return !fits;
        });
        isLimited_ = active.empty();
    }
}

void BodyLight::send(Sending& sending, std::uint32_t side, const PieceUses& uses,
                     std::uint32_t wanted) const {
    const Rays rays(*nodes_, side);
    RayHit hit;
    std::vector<RayHit> through;
    sending.weights.resize(nodes_->near(side / 2).size());
    const auto sendUpTo = [&](std::uint32_t end) {
        for (; sending.sent < end; ++sending.sent) {
            const LightStart start = rays.at(sending.sent);
            for (const LightNodes::Share& own : LightNodes::OfPlace(*nodes_, start.from.place))
                sending.weights[nodes_->placeNear(side / 2, own.node)] +=
                    static_cast<double>(own.part);
            if (!mesh().rays().meet(start.ray, uses, 0.0, hit, through))
                continue;
            sending.hits.push_back(
                {sending.sent, static_cast<float>(hit.distance_m), mesh().placeOf(hit)});
            sending.moments[0] += 1.0;
            sending.moments[1] += start.ray.direction.x;
            sending.moments[2] += start.ray.direction.y;
            sending.moments[3] += start.ray.direction.z;
            for (std::size_t i = 0; i < Sending::halves; ++i)
                sending.moments[4 + i] += (hit.piece >> i) % 2;
        }
    };
    sendUpTo(wanted / 2);
    sending.ofFirstHalf = sending.moments;
    sendUpTo(wanted);
}

void BodyLight::gather(std::vector<Sending>& sendings) {
    // The surface that a receiver's numbers come from: nodes that no ray has begun near are not
    // known there.
    std::vector<double> known_m2(nodes_->receivers(), 0.0);
    for (std::uint32_t side = 0; side < sendings.size(); ++side) {
        const auto near = nodes_->near(side / 2);
        for (std::size_t i = 0; i < near.size(); ++i)
            if (sendings[side].sent == 0 || sendings[side].weights[i] > 0.0)
                known_m2[2 * near[i].node + side % 2] += static_cast<double>(near[i].area_m2);
    }
    first_.push_back(0);
    firstScale_.push_back(0);
    std::size_t hits = 0;
    for (const Sending& sending : sendings)
        hits += sending.hits.size();
    rays_.reserve(hits);
    for (std::uint32_t side = 0; side < sendings.size(); ++side) {
        const Sending sending = std::move(sendings[side]);
        sent_.push_back(sending.sent);
        rays_.insert(rays_.end(), sending.hits.begin(), sending.hits.end());
        first_.push_back(rays_.size());
        const auto near = nodes_->near(side / 2);
        for (std::size_t i = 0; i < near.size() && sending.sent > 0; ++i) {
            const double whole_m2 = sending.weights[i] * known_m2[2 * near[i].node + side % 2];
            scales_.push_back(whole_m2 > 0.0 ? near[i].area_m2 / static_cast<float>(whole_m2)
                                             : 0.0f);
        }
        firstScale_.push_back(scales_.size());
    }
    std::vector<std::vector<LightPart>> parts(sendings.size());
    forEachOf(sendings.size(), [&](std::uint32_t side) {
        const Rays rays(*nodes_, side);
        for (const LightRay& ray : raysOf(side)) {
            const LightNodes::OfPlace senders(*nodes_, ray.place);
            for (const LightNodes::Share& own :
                 LightNodes::OfPlace(*nodes_, rays.at(ray.index).from.place)) {
                const float scale =
                    own.part * scalesOf(side)[nodes_->placeNear(side / 2, own.node)];
                for (const LightNodes::Share& sender : senders)
                    parts[side].push_back({2 * own.node + side % 2,
                                           2 * sender.node + ray.place.triangle % 2,
                                           scale * sender.part});
            }
        }
        mergeParts(parts[side]);
    });
    pairs_ = LightPairs(nodes_->receivers(), std::move(parts));
}

} // namespace irsg
