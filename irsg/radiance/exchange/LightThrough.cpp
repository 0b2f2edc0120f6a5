#include "irsg/radiance/exchange/LightThrough.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>

#include "irsg/core/ParallelFor.h"

namespace irsg {

namespace {

/// What is met behind a material is scaled by this at most.
constexpr double mostScaleBehind = 4.0;

std::shared_ptr<const LightPairs> scaled(const LightPairs& pairs, const std::vector<float>& by) {
    auto all = std::make_shared<LightPairs>(pairs);
    all->scale(
        [&](std::uint32_t receiver, const LightPair& pair) { return by[receiver] * pair.factor; });
    return all;
}

} // namespace

PaneClosure::PaneClosure(const OccluderStacks& passages,
                         const std::vector<OccluderMaterial>& materials,
                         std::span<const int> paneOf)
    : paneOf_(paneOf), passages_(passages.size()), order_(passages.size()) {
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    const auto sizeOf = [&](std::size_t passage) {
        return passages.materials(static_cast<int>(passage)).size();
    };
    std::ranges::stable_sort(order_, {}, sizeOf);
    for (std::size_t passage = 0; passage < passages_; ++passage) {
        const auto& own = passages.materials(static_cast<int>(passage));
        isOfGround_.push_back(std::ranges::find(own, groundMaterial) != own.end());
        for (std::vector<int>& of = next_.emplace_back();
             const OccluderMaterial& material : materials) {
            std::vector<OccluderMaterial> set = passages.materials(static_cast<int>(passage));
            set.insert(std::ranges::upper_bound(set, material), material);
            of.push_back(passages.find(set));
        }
    }
}

void PaneClosure::addReaching(std::size_t passage, const LightPairs& pairs, std::size_t receiver,
                              double scale, std::vector<double>& reaching) const {
    const auto [first, last] = pairs.of(receiver);
    for (const LightPair* pair = first; pair != last; ++pair)
        if (const int pane = paneOf_[pair->sender]; pane >= 0)
            if (const int next = next_[passage][static_cast<std::size_t>(pane)]; next >= 0)
                reaching[static_cast<std::size_t>(next)] +=
                    scale * static_cast<double>(pair->factor);
}

void PaneClosure::closeReceivers(const LightPairs& base, std::span<const double> isUp,
                                 std::vector<LightThrough>& through) const {
    std::vector<std::vector<float>> scales(through.size(),
                                           std::vector<float>(base.receivers(), 1.0f));
    parallelForSmall(base.receivers(), [&](std::uint32_t r) {
        if (base.isEmpty(r))
            return;
        std::vector<double> reaching(passages_);
        addReaching(0, base, r, 1.0, reaching);
        for (const std::size_t passage : order_) {
            if (passage == 0 || isOfGround_[passage])
                continue;
            LightThrough& own = through[passage - 1];
            const LightPairs& pairs = *own.balance.pairs;
            OutsideLight& leaving = own.leaving[r];
            const double met = pairs.sumOf(r), left = leaving.sky + leaving.ground;
            double scale = 1.0;
            if (met > 0.0 && (left <= 0.0 || met > reaching[passage]))
                scale = std::min(reaching[passage] / met, mostScaleBehind);
            const double rest = std::max(reaching[passage] - scale * met, 0.0);
            const double up = left > 0.0 ? leaving.sky / left : isUp[r];
            leaving = {up * rest, (1.0 - up) * rest, 0.0};
            scales[passage - 1][r] = static_cast<float>(scale);
            addReaching(passage, pairs, r, scale, reaching);
        }
    });
    for (std::size_t i = 0; i < through.size(); ++i) {
        LightBalance& balance = through[i].balance;
        const bool isSame = balance.between == balance.pairs;
        balance.pairs = scaled(*balance.pairs, scales[i]);
        if (isSame)
            balance.between = balance.pairs;
    }
}

void PaneClosure::closeSenders(const LightPairs& base, std::vector<LightThrough>& through) const {
    std::vector<std::vector<float>> scales(through.size(),
                                           std::vector<float>(base.receivers(), 1.0f));
    parallelForSmall(base.receivers(), [&](std::uint32_t s) {
        std::vector<double> reaching(passages_);
        addReaching(0, base, s, 1.0, reaching);
        for (const std::size_t passage : order_) {
            if (passage == 0 || isOfGround_[passage])
                continue;
            const LightThrough& own = through[passage - 1];
            const LightPairs& pairs = *own.balance.between;
            const double met = pairs.sumOf(s);
            const double rest = std::max(reaching[passage] - own.sky[s] - own.ground[s], 0.0);
            const double scale = met > 0.0 ? std::min(rest / met, mostScaleBehind) : 1.0;
            scales[passage - 1][s] = static_cast<float>(scale);
            addReaching(passage, pairs, s, scale, reaching);
        }
    });
    for (std::size_t i = 0; i < through.size(); ++i)
        through[i].balance.between = scaled(*through[i].balance.between, scales[i]);
}

} // namespace irsg
