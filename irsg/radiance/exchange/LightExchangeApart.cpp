// What surfaces of bodies see that neither light, shade nor hide each other: each as it is alone.
#include <algorithm>
#include <numeric>

#include "irsg/radiance/exchange/LightExchange.h"

namespace irsg {

namespace {

template <typename Value>
void append(std::vector<Value>& all, const std::vector<Value>& more, std::size_t count) {
    all.insert(all.end(), more.begin(), more.begin() + static_cast<std::ptrdiff_t>(count));
}

} // namespace

LightExchange::LightExchange(std::vector<std::shared_ptr<const LightExchange>> ofBodies,
                             const std::vector<SunShadows::Caster>& casters, bool hasLobes,
                             const std::vector<std::size_t>& components)
    : hasLobes_(hasLobes), areApart_(true), alone_(std::move(ofBodies)) {
    for (const auto& own : alone_)
        bodies_.push_back(own->bodies_.front());
    numberComponents(components);
    number(casters);
    sees_.assign(ofRow_.size(), false);
    for (const auto& own : alone_) {
        for (std::size_t row = 0; row < own->sees_.size(); ++row)
            sees_[row] = sees_[row] || own->sees_[row];
        append(getsLight_, own->getsLight_, own->receivers());
        append(isSeen_, own->isSeen_, own->senders());
        append(reflects_, own->reflects_, own->senders());
        append(losses_, own->losses_, own->receivers());
        append(openOfVertex_, own->openOfVertex_, own->openOfVertex_.size());
        append(sunOnCells_, own->sunOnCells_, own->sunOnCells_.size());
        append(sky_, own->sky_, own->senders());
        append(ground_, own->ground_, own->senders());
        append(sun_, own->sun_, own->senders());
    }
    std::vector<std::vector<std::uint32_t>> sunOnRows(alone_.size()); // by body and own number
    for (std::size_t b = 0; b < alone_.size(); ++b) {
        sunOnRows[b].resize(alone_[b]->rows());
        std::iota(sunOnRows[b].begin(), sunOnRows[b].end(), 0u);
        for (const LightThrough& one : alone_[b]->through_)
            addThrough(b, one, sunOnRows[b]);
    }
    std::vector<BalanceOfBody> balances;
    balances.reserve(alone_.size());
    for (const auto& own : alone_)
        balances.push_back({&own->balance_, true});
    balance_ = joined(balances);
    std::vector<LightPairs::Block> sun;
    for (std::size_t b = 0; b < alone_.size(); ++b)
        sun.push_back({&alone_[b]->sunBesideMean_, 0, alone_[b]->receivers(), 0, &sunOnRows[b]});
    sunBesideMean_ = LightPairs(sun);
    if (hasLobes_)
        addReflected();
}

LightBalance LightExchange::joined(const std::vector<BalanceOfBody>& ofBodies) const {
    std::vector<LightPairs::Block> pairs, between;
    bool areSame = senders() == receivers();
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
        const ExchangeNodes& nodes = bodies_[b].light->nodes();
        const auto [balance, isOwn] = ofBodies[b];
        const std::uint32_t add = isOwn ? firstSender_[b] : 0;
        pairs.push_back({balance ? balance->pairs.get() : nullptr, isOwn ? 0 : firstReceiver_[b],
                         nodes.nodes(), add});
        between.push_back({balance ? balance->between.get() : nullptr, isOwn ? 0 : firstSender_[b],
                           nodes.senders(), add});
        areSame = areSame && (balance == nullptr || balance->pairs == balance->between);
    }
    LightBalance all;
    all.pairs = std::make_shared<const LightPairs>(pairs);
    all.between = areSame ? all.pairs : std::make_shared<const LightPairs>(between);
    return all;
}

void LightExchange::addThrough(std::size_t body, const LightThrough& own,
                               std::vector<std::uint32_t>& sunOnRows) {
    std::vector<OccluderMaterial> set;
    for (const std::size_t pane : own.panes)
        set.push_back(alone_[body]->panes_[pane]);
    LightThrough& one = throughOf(set);
    for (std::size_t row = 0; row < alone_[body]->rows(); ++row)
        sunOnRows.push_back(static_cast<std::uint32_t>(through_.size() * rows() + row));
    std::vector<BalanceOfBody> balances(bodies_.size());
    balances[body].balance = &own.balance;
    one.balance = joined(balances);
    const auto put = [](auto& all, std::size_t count, const auto& values, std::size_t first) {
        all.resize(count);
        std::ranges::copy(values, all.begin() + static_cast<std::ptrdiff_t>(first));
    };
    put(one.leaving, receivers(), own.leaving, firstReceiver_[body]);
    put(one.sky, senders(), own.sky, firstSender_[body]);
    put(one.ground, senders(), own.ground, firstSender_[body]);
    put(one.sun, senders(), own.sun, firstSender_[body]);
    if (!own.sunOnCells.empty())
        put(one.sunOnCells, cells_, own.sunOnCells, firstCell_[body]);
}

} // namespace irsg
