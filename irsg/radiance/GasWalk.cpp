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
        std::ranges::fill(gas.fronts, 0.0);
        gas.isMet = gas.isNew = false;
    }
    met_.clear();
    branches_.assign(1, {});
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
        const std::vector<double> none(columns.numbers.size());
        entities_.push_back({entity, zone.firstRow, &columns, static_cast<int>(sets_.size()),
                             GasColumnBasis::Line(columns.basis), none, none,
                             std::vector<double>(columns.basis.fronts().size())});
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

const std::vector<GasWalk::Emission>& GasWalk::takeEmission() {
    emission_.clear();
    hasNew_ = false;
    for (const std::size_t number : met_) {
        OfEntity& gas = entities_[number];
        if (!std::exchange(gas.isNew, false))
            continue;
        gas.columns->basis.weightsOf(gas.line, gas.weights);
        gas.columns->basis.frontWeightsOf(gas.weights, gas.fronts);
        fillBranches(&gas, others_);
        for (std::size_t k = 0; k < gas.weights.size(); ++k) {
            const double more = gas.weights[k] - gas.told[k];
            if (more == 0.0)
                continue;
            for (const Branch& other : others_)
                emission_.push_back(
                    {gas.firstRow,
                     gas.metFirst,
                     gas.from_m,
                     {joined(other.set, gas.firstSet + static_cast<int>(k)), other.weight * more}});
        }
        std::swap(gas.told, gas.weights);
    }
    fillBranches(nullptr, branches_);
    return emission_;
}

void GasWalk::fillBranches(const OfEntity* without, std::vector<Branch>& branches) {
    branches.assign(1, {});
    for (const std::size_t number : met_) {
        const OfEntity& gas = entities_[number];
        if (&gas == without)
            continue;
        longer_.clear();
        for (const Branch& branch : branches) {
            double rest = 1.0;
            for (std::size_t m = 0; m < gas.fronts.size(); ++m) {
                rest -= gas.fronts[m];
                const auto column = static_cast<int>(gas.columns->basis.fronts()[m]);
                if (gas.fronts[m] != 0.0)
                    longer_.push_back(
                        {joined(branch.set, gas.firstSet + column), branch.weight * gas.fronts[m]});
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
