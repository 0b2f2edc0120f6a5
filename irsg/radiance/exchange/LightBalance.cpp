#include "irsg/radiance/exchange/LightBalance.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "irsg/core/ParallelFor.h"
#include "irsg/radiance/exchange/ExchangeNodes.h"

namespace irsg {

namespace {

/// Until sums are right: of what is left each step takes half and more.
constexpr int mostSteps = 40;
constexpr double wellBalanced = 1e-5;
/// The most that a receiver's hits are scaled by, either way: more would follow from hits that
/// contradict each other.
constexpr double mostScale = 16.0;

/// Rays per area.
double densityOf(const ReceiverRays& receiver) {
    return receiver.area_m2 > 0.0 ? receiver.rays / receiver.area_m2 : 0.0;
}

/// A F of all pairs from the hits of both ends.
LightPairs exchanged(const LightPairs& pairs, const std::vector<ReceiverRays>& receivers) {
    std::vector<std::vector<LightPart>> parts(pairs.receivers());
    parallelForSmall(pairs.receivers(), [&](std::uint32_t r) {
        const double own = densityOf(receivers[r]);
        const auto [first, last] = pairs.of(r);
        for (const LightPair* pair = first; pair != last; ++pair) {
            const double other = densityOf(receivers[pair->sender]);
            const auto part = static_cast<float>(own / (own + other) * receivers[r].area_m2 *
                                                 static_cast<double>(pair->factor));
            parts[r].push_back({r, pair->sender, part});
            parts[r].push_back({pair->sender, r, part});
        }
    });
    return LightPairs(pairs.receivers(), std::move(parts));
}

/// What a receiver sees of others, as an area: what its own rays say, how much of it that counts
/// beside what the rays of both ends say, and the most that it may be.
struct WantedSum {
    double own_m2 = 0.0, trust = 0.0, most_m2 = 0.0;

    /// Of a sum that the others' scales have brought about.
    double of(double sum_m2) const { return std::min(sum_m2 + trust * (own_m2 - sum_m2), most_m2); }
};

/// `seen`: by its own rays; `variance_m4`: of what the rays of both ends say.
WantedSum wantedSum(const ReceiverRays& own, double seen, double oneWay, double variance_m4) {
    WantedSum wanted;
    if (!(own.area_m2 > 0.0))
        return wanted;
    wanted.most_m2 = own.area_m2 * std::max(1.0 - oneWay, 0.0);
    if (!(own.rays > 0.0))
        return wanted;
    const double open = std::max(1.0 - seen - oneWay, 0.0);
    // Where many rays are met and many are not, they are spread better than by chance. None of so
    // many rays may be one of the next.
    const double spread = std::pow(1.0 + own.rays * seen * open, -1.0 / 3.0);
    const double variance = (seen + 1.0 / own.rays) * open / own.rays * spread;
    const double area2_m4 = own.area_m2 * own.area_m2;
    wanted.own_m2 = seen * own.area_m2;
    wanted.trust = variance_m4 > 0.0 ? variance_m4 / (variance_m4 + variance * area2_m4) : 1.0;
    return wanted;
}

LightPairs joined(const LightPairs& some, const LightPairs& others) {
    std::vector<std::vector<LightPart>> parts(some.receivers());
    for (std::uint32_t r = 0; r < some.receivers(); ++r)
        for (const LightPairs* pairs : {&some, &others}) {
            const auto [first, last] = pairs->of(r);
            for (const LightPair* pair = first; pair != last; ++pair)
                parts[r].push_back({r, pair->sender, pair->factor});
        }
    return LightPairs(some.receivers(), std::move(parts));
}

/// What `balanced` finds, without what is seen one way.
LightPairs balancedExchange(const LightPairs& pairs, const LightPairs& oneWay,
                            const std::vector<ReceiverRays>& receivers) {
    LightPairs exchange = exchanged(pairs, receivers);
    std::vector<WantedSum> wanted(receivers.size());
    std::vector<double> scale(receivers.size(), 1.0), next(receivers.size()), off(receivers.size());
    parallelForSmall(receivers.size(), [&](std::uint32_t r) {
        double variance_m4 = 0.0;
        const auto [first, last] = exchange.of(r);
        for (const LightPair* pair = first; pair != last; ++pair)
            variance_m4 += static_cast<double>(pair->factor) /
                           (densityOf(receivers[r]) + densityOf(receivers[pair->sender]));
        wanted[r] = wantedSum(receivers[r], pairs.sumOf(r), oneWay.sumOf(r), variance_m4);
    });
    const auto sum_m2 = [&](std::uint32_t r) {
        double sum = 0.0;
        const auto [first, last] = exchange.of(r);
        for (const LightPair* pair = first; pair != last; ++pair)
            sum += static_cast<double>(pair->factor) * scale[pair->sender];
        return sum;
    };
    for (int step = 0; step < mostSteps; ++step) {
        parallelForSmall(receivers.size(), [&](std::uint32_t r) {
            const double sum = sum_m2(r), now = scale[r] * sum;
            const double ratio = now > 0.0 ? wanted[r].of(sum) / now : 1.0;
            off[r] = std::abs(ratio - 1.0);
            next[r] = std::clamp(scale[r] * std::sqrt(ratio), 1.0 / mostScale, mostScale);
        });
        scale.swap(next);
        if (std::ranges::max(off) < wellBalanced)
            break;
    }
    // What is left of it, each receiver takes on itself.
    parallelForSmall(receivers.size(), [&](std::uint32_t r) {
        const double sum = sum_m2(r);
        const double all_m2 = sum * receivers[r].area_m2;
        next[r] = all_m2 > 0.0 ? wanted[r].of(sum) / all_m2 : 0.0;
    });
    exchange.scale([&](std::uint32_t receiver, const LightPair& pair) {
        return static_cast<float>(next[receiver] * scale[pair.sender] *
                                  static_cast<double>(pair.factor));
    });
    return exchange;
}

/// Of senders: means over the areas of those who receive for them.
LightPairs meansOf(const LightPairs& pairs, const std::vector<ReceiverRays>& receivers,
                   std::span<const std::uint32_t> senderOf,
                   const std::vector<ReceiverRays>& senders) {
    std::vector<std::vector<LightPart>> parts(receivers.size());
    parallelForSmall(receivers.size(), [&](std::uint32_t r) {
        const std::uint32_t own = senderOf[r];
        if (!(senders[own].area_m2 > 0.0))
            return;
        const double part = receivers[r].area_m2 / senders[own].area_m2;
        const auto [first, last] = pairs.of(r);
        for (const LightPair* pair = first; pair != last; ++pair)
            parts[r].push_back(
                {own, pair->sender, static_cast<float>(part * static_cast<double>(pair->factor))});
    });
    return LightPairs(senders.size(), std::move(parts));
}

/// What a receiver gets of each after its sender was balanced, before its own sum is looked at: as
/// its own rays have it beside those of the sender's others, or, where they are few, as all of
/// these have it.
std::vector<LightPart> scaledOf(std::uint32_t receiver, double rays, const LightPairs& pairs,
                                std::uint32_t sender, const LightPairs& raw,
                                const LightPairs& exchange) {
    constexpr double few = 2.0;
    std::vector<LightPart> scaled;
    auto [own, ownEnd] = pairs.of(receiver);
    auto [before, beforeEnd] = raw.of(sender);
    const auto [first, last] = exchange.of(sender);
    const auto factorIn = [](const LightPair*& at, const LightPair* end, std::uint32_t of) {
        while (at != end && at->sender < of)
            ++at;
        return at != end && at->sender == of ? static_cast<double>(at->factor) : 0.0;
    };
    for (const LightPair* pair = first; pair != last; ++pair) {
        const double met = rays * factorIn(own, ownEnd, pair->sender);
        const double mean = rays * factorIn(before, beforeEnd, pair->sender);
        scaled.push_back(
            {receiver, pair->sender,
             static_cast<float>(static_cast<double>(pair->factor) * (met + few) / (mean + few))});
    }
    return scaled;
}

} // namespace

LightPairs balanced(const LightPairs& pairs, const LightPairs& oneWay,
                    const std::vector<ReceiverRays>& receivers) {
    if (pairs.size() == 0)
        return oneWay;
    LightPairs exchange = balancedExchange(pairs, oneWay, receivers);
    return oneWay.size() == 0 ? exchange : joined(exchange, oneWay);
}

LightBalance balancedOfSenders(const LightPairs& pairs, const LightPairs& oneWay,
                               const std::vector<ReceiverRays>& receivers,
                               std::span<const std::uint32_t> senderOf, std::size_t senders) {
    if (senders == receivers.size()) {
        const auto all = std::make_shared<const LightPairs>(balanced(pairs, oneWay, receivers));
        return {all, all};
    }
    std::vector<ReceiverRays> ofSenders(senders);
    for (std::size_t r = 0; r < receivers.size(); ++r) {
        ofSenders[senderOf[r]].area_m2 += receivers[r].area_m2;
        ofSenders[senderOf[r]].rays += receivers[r].rays;
    }
    const LightPairs raw = meansOf(pairs, receivers, senderOf, ofSenders);
    const LightPairs rawOneWay = meansOf(oneWay, receivers, senderOf, ofSenders);
    const LightPairs exchange = raw.size() == 0 ? raw : balancedExchange(raw, rawOneWay, ofSenders);
    std::vector<std::vector<LightPart>> parts(receivers.size());
    parallelForSmall(receivers.size(), [&](std::uint32_t r) {
        parts[r] = scaledOf(r, receivers[r].rays, pairs, senderOf[r], raw, exchange);
        double sum_m2 = 0.0, variance_m4 = 0.0;
        for (const LightPart& part : parts[r]) {
            const double own_m2 = receivers[r].area_m2 * static_cast<double>(part.factor);
            sum_m2 += own_m2;
            variance_m4 += own_m2 / (densityOf(receivers[r]) + densityOf(ofSenders[part.sender]));
        }
        const WantedSum wanted =
            wantedSum(receivers[r], pairs.sumOf(r), oneWay.sumOf(r), variance_m4);
        const double scale = sum_m2 > 0.0 ? wanted.of(sum_m2) / sum_m2 : 0.0;
        for (LightPart& part : parts[r])
            part.factor = static_cast<float>(scale * static_cast<double>(part.factor));
        const auto [first, last] = oneWay.of(r);
        for (const LightPair* pair = first; pair != last; ++pair)
            parts[r].push_back({r, pair->sender, pair->factor});
    });
    LightBalance balance;
    balance.pairs = std::make_shared<const LightPairs>(receivers.size(), std::move(parts));
    balance.between = std::make_shared<const LightPairs>(
        rawOneWay.size() == 0 ? exchange : joined(exchange, rawOneWay));
    return balance;
}

} // namespace irsg
