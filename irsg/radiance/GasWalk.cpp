#include "irsg/radiance/GasWalk.h"

#include <algorithm>
#include <utility>

namespace irsg {

void GasWalk::begin(std::span<const int> rowsAbout) {
    inside_.assign(rowsAbout.begin(), rowsAbout.end());
    at_m_ = 0.0f;
    hasNew_ = false;
    for (const std::size_t number : met_) {
        OfEntity& gas = entities_[number];
        gas.line.clear();
        std::ranges::fill(gas.told, 0.0);
        gas.isMet = gas.isNew = false;
        gas.fronts.areKnown = gas.reflectionFronts.areKnown = false;
    }
    met_.clear();
    branches_.areKnown = reflectionBranches_.areKnown = false;
}

int GasWalk::innermost() const {
    const auto volumeOf = [&](int row) { return rows_.gas(row)->shape.volume_m3; };
    return *std::ranges::min_element(inside_, {}, volumeOf);
}

GasWalk::OfEntity& GasWalk::ofEntity(int row) {
    const GasZone& zone = *rows_.gas(row);
    auto found = std::ranges::find(entities_, zone.firstRow, &OfEntity::firstRow);
    if (found == entities_.end()) {
        const int entity = rows_.keyOf(row).first;
        const GasColumnsOfEntity& columns = *zone.columns;
        const std::vector<double> none(columns.basis.valuesOfLine());
        const auto unknown = [](const GasColumnBasis::Fronts& fronts) {
            return Fronts{&fronts, std::vector<double>(fronts.columns.size()), false};
        };
        entities_.push_back({entity, zone.firstRow, &columns, static_cast<int>(sets_.size()),
                             GasColumnBasis::Line(columns.basis), none, none, none,
                             unknown(columns.basis.fronts()),
                             unknown(columns.basis.reflectionFronts())});
        for (const int number : columns.numbers)
            sets_.push_back({{entity, number}});
        found = entities_.end() - 1;
    }
    if (!found->isMet) {
        found->isMet = true;
        met_.push_back(static_cast<std::size_t>(found - entities_.begin()));
    }
    return *found;
}

void GasWalk::goTo(float distance_m) {
    const float from_m = std::exchange(at_m_, std::max(distance_m, at_m_));
    if (inside_.empty() || !(distance_m > from_m))
        return;
    const int row = innermost();
    OfEntity& gas = ofEntity(row);
    if (!gas.isNew) {
        gas.isNew = true;
        gas.metFirst = row;
        gas.from_m = from_m;
    }
    gas.line.add(rows_.gas(row)->gas,
                 static_cast<double>(distance_m) - static_cast<double>(from_m));
    hasNew_ = true;
}

void GasWalk::cross(int row) {
    const auto found = std::ranges::find(inside_, row);
    if (found == inside_.end())
        inside_.push_back(row);
    else
        inside_.erase(found);
}

const std::vector<GasWalk::Emission>& GasWalk::takeEmission(double share) {
    emission_.clear();
    hasNew_ = false;
    for (const std::size_t number : met_) {
        OfEntity& gas = entities_[number];
        if (!std::exchange(gas.isNew, false))
            continue;
        gas.line.fillValues(gas.values);
        for (std::size_t i = 0; i < gas.values.size(); ++i)
            gas.more[i] = gas.values[i] - gas.told[i];
        std::swap(gas.told, gas.values);
        gas.fronts.areKnown = gas.reflectionFronts.areKnown = false;
        fillBranches(&gas, &OfEntity::fronts, others_);
        for (const Branch& other : others_)
            emission_.push_back({gas.firstRow, gas.metFirst, gas.from_m, other, share, gas.columns,
                                 gas.firstSet, gas.more});
    }
    branches_.areKnown = reflectionBranches_.areKnown = false;
    return emission_;
}

const std::vector<GasWalk::Branch>& GasWalk::branches() {
    return known(branches_, &OfEntity::fronts);
}

const std::vector<GasWalk::Branch>& GasWalk::reflectionBranches() {
    return known(reflectionBranches_, &OfEntity::reflectionFronts);
}

const std::vector<GasWalk::Branch>& GasWalk::known(Branches& branches, Fronts OfEntity::*of) {
    if (!std::exchange(branches.areKnown, true))
        fillBranches(nullptr, of, branches.all);
    return branches.all;
}

const GasWalk::Fronts& GasWalk::frontsOf(OfEntity& gas, Fronts OfEntity::*of) {
    Fronts& fronts = gas.*of;
    if (!std::exchange(fronts.areKnown, true))
        fronts.of->weightsOf(gas.told, fronts.weights);
    return fronts;
}

void GasWalk::fillBranches(const OfEntity* without, Fronts OfEntity::*of,
                           std::vector<Branch>& branches) {
    branches.assign(1, {});
    for (const std::size_t number : met_) {
        OfEntity& gas = entities_[number];
        if (&gas == without)
            continue;
        const Fronts& fronts = frontsOf(gas, of);
        longer_.clear();
        for (const Branch& branch : branches) {
            double rest = 1.0;
            for (std::size_t m = 0; m < fronts.weights.size(); ++m) {
                const double weight = fronts.weights[m];
                rest -= weight;
                if (weight != 0.0)
                    longer_.push_back(
                        {joined(branch.set, gas.firstSet + static_cast<int>(fronts.of->columns[m])),
                         branch.weight * weight});
            }
            longer_.push_back({branch.set, branch.weight * rest});
        }
        std::swap(branches, longer_);
    }
}

int GasWalk::joined(int set, int other) {
    if (set == 0)
        return other;
    const auto [found, isNew] = joined_.try_emplace({set, other}, static_cast<int>(sets_.size()));
    if (isNew) {
        std::vector<OccluderMaterial> both = columns(set);
        both.insert(both.end(), columns(other).begin(), columns(other).end());
        sets_.push_back(std::move(both));
    }
    return found->second;
}

} // namespace irsg
