#include "irsg/radiance/GasWalk.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace irsg {

void GasWalk::begin(std::span<const int> rowsAbout) {
    inside_.assign(rowsAbout.begin(), rowsAbout.end());
    at_m_ = 0.0f;
    hasNew_ = false;
    gases_.clear();
    branches_.assign(1, {});
}

int GasWalk::innermost() const {
    const auto volumeOf = [&](int row) { return rows_.gas(row)->shape.volume_m3; };
    return *std::ranges::min_element(inside_, {}, volumeOf);
}

GasWalk::OfEntity& GasWalk::ofEntity(int entity) {
    const auto found = std::ranges::find(gases_, entity, &OfEntity::entity);
    if (found != gases_.end())
        return *found;
    gases_.push_back({entity, {}, 0, {}});
    return gases_.back();
}

void GasWalk::goTo(float distance_m) {
    const float from_m = std::exchange(at_m_, std::max(distance_m, at_m_));
    if (inside_.empty() || !(distance_m > from_m))
        return;
    const int row = innermost();
    OfEntity& gas = ofEntity(rows_.keyOf(row).first);
    const double length_m = static_cast<double>(distance_m) - static_cast<double>(from_m);
    hasNew_ = true;
    if (gas.stretches.size() > gas.told && gas.stretches.back().row == row)
        gas.stretches.back().length_m += length_m;
    else
        gas.stretches.push_back({row, length_m, from_m});
}

void GasWalk::cross(int row) {
    const auto found = std::ranges::find(inside_, row);
    if (found == inside_.end())
        inside_.push_back(row);
    else
        inside_.erase(found);
}

std::vector<GasWalk::OfEntity::Vertex> GasWalk::simplex(const OfEntity& gas) {
    const std::size_t count = gas.stretches.size();
    std::vector<double> fractions(count), above_m(count);
    OfEntity::Vertex vertex;
    for (std::size_t i = 0; i < count; ++i) {
        const std::vector<double>& knots_m = rows_.gas(gas.stretches[i].row)->knots_m;
        const double length_m = std::min(gas.stretches[i].length_m, knots_m.back());
        const auto next = std::clamp(std::ranges::upper_bound(knots_m, length_m),
                                     knots_m.begin() + 1, knots_m.end() - 1);
        above_m[i] = *next;
        vertex.lengths_m.push_back(*(next - 1));
        fractions[i] = (length_m - *(next - 1)) / (*next - *(next - 1));
    }
    // From the lowest corner of the box along one edge after the other, those of the largest
    // fractions first; equal fractions in their order.
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, std::greater(), [&](std::size_t i) { return fractions[i]; });
    std::vector<OfEntity::Vertex> vertices;
    double left = 1.0;
    for (std::size_t k = 0; k <= count; ++k) {
        const double next = k < count ? fractions[order[k]] : 0.0;
        vertex.weight = left - next;
        if (vertex.weight > 0.0)
            vertices.push_back(vertex);
        left = next;
        if (k < count)
            vertex.lengths_m[order[k]] = above_m[order[k]];
    }
    return vertices;
}

void GasWalk::makeColumn(const OfEntity& gas, const OfEntity::Vertex& vertex, std::size_t before) {
    // Without stretches of no length, and with neighbours of one gas as one: equal columns have
    // equal numbers.
    std::vector<GasColumnKey::Stretch>& stretches = column_.stretches;
    stretches.clear();
    column_.before = 0;
    for (std::size_t i = 0; i < gas.stretches.size(); ++i) {
        if (i == before)
            column_.before = stretches.size();
        if (vertex.lengths_m[i] == 0.0)
            continue;
        const IrCodes& codes = rows_.keyOf(gas.stretches[i].row).second;
        const std::size_t first = i < before ? 0 : column_.before;
        if (stretches.size() > first && stretches.back().codes == codes)
            stretches.back().length_m += vertex.lengths_m[i];
        else
            stretches.push_back({codes, vertex.lengths_m[i]});
    }
}

int GasWalk::numberOfColumn() {
    const auto found = numbers_.find(column_);
    return found != numbers_.end()
               ? found->second
               : numbers_.emplace(column_, gasColumnNumber(column_)).first->second;
}

const std::vector<GasWalk::Emission>& GasWalk::takeEmission() {
    emission_.clear();
    hasNew_ = false;
    for (OfEntity& gas : gases_) {
        if (gas.told == gas.stretches.size())
            continue;
        // Behind the others, whose columns the branches have, and before none of its own.
        gas.vertices.clear();
        fillBranches();
        gas.vertices = simplex(gas);
        for (std::size_t v = 0; v < gas.vertices.size(); ++v) {
            OfEntity::Vertex& vertex = gas.vertices[v];
            makeColumn(gas, vertex, gas.told);
            vertex.number = numberOfColumn();
            addEmission(gas, v);
            if (column_.before == 0)
                continue;
            makeColumn(gas, vertex, 0);
            vertex.number = numberOfColumn();
        }
        gas.told = gas.stretches.size();
    }
    fillBranches();
    return emission_;
}

void GasWalk::addEmission(const OfEntity& gas, std::size_t vertex) {
    const OfEntity::Vertex& own = gas.vertices[vertex];
    for (const Branch& branch : branches_) {
        const std::size_t first = emission_.size();
        for (std::size_t i = gas.told; i < gas.stretches.size(); ++i) {
            const auto& [row, length_m, from_m] = gas.stretches[i];
            const auto isIt = [row = row](const Emission& one) { return one.row == row; };
            if (own.lengths_m[i] == 0.0 ||
                std::any_of(emission_.begin() + static_cast<std::ptrdiff_t>(first), emission_.end(),
                            isIt))
                continue;
            Emission& one = emission_.emplace_back(Emission{row, from_m, branch});
            one.branch.columns.emplace_back(gas.entity, own.number);
            one.branch.weight *= own.weight;
        }
    }
}

void GasWalk::fillBranches() {
    branches_.assign(1, {});
    for (const OfEntity& gas : gases_) {
        if (gas.vertices.empty())
            continue;
        std::vector<Branch> longer;
        for (const Branch& branch : branches_)
            for (const OfEntity::Vertex& vertex : gas.vertices) {
                Branch& one = longer.emplace_back(branch);
                one.columns.emplace_back(gas.entity, vertex.number);
                one.weight *= vertex.weight;
            }
        branches_ = std::move(longer);
    }
}

} // namespace irsg
