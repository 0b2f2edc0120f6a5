#include "irsg/gas/PlumeField.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "irsg/core/Errors.h"
#include "irsg/core/Interpolation.h"
#include "irsg/gas/GasMean.h"

namespace irsg {

PlumeField::Node PlumeField::Node::of(const GasLayer& gas) {
    Node node;
    node.temperature_K = static_cast<float>(gas.temperature_K);
    node.pressure_atm = static_cast<float>(gas.pressure_atm);
    for (std::size_t g = 0; g < hotGasCount; ++g)
        node.moleFraction[g] = static_cast<float>(gas.moleFraction[g]);
    node.oxygenFraction = static_cast<float>(gas.oxygenFraction);
    node.soot_ppmv = static_cast<float>(gas.soot_ppmv);
    return node;
}

GasLayer PlumeField::Node::gas() const {
    GasLayer gas;
    gas.temperature_K = static_cast<double>(temperature_K);
    gas.pressure_atm = static_cast<double>(pressure_atm);
    if (!isGas)
        return gas;
    for (std::size_t g = 0; g < hotGasCount; ++g)
        gas.moleFraction[g] = static_cast<double>(moleFraction[g]);
    gas.oxygenFraction = static_cast<double>(oxygenFraction);
    gas.soot_ppmv = static_cast<double>(soot_ppmv);
    return gas;
}

PlumeField PlumeField::ofNodes(Axes axes_m, std::vector<Node> nodes) {
    if (nodes.size() != axes_m[0].size() * axes_m[1].size() * axes_m[2].size())
        throw LogicError("a field has not one node for each x, y and z");
    PlumeField field;
    field.axes_m_ = std::move(axes_m);
    field.nodes_ = std::move(nodes);
    const auto [coldest, hottest] =
        std::ranges::minmax_element(field.nodes_, {}, &Node::temperature_K);
    field.coldest_K_ = static_cast<double>(coldest->temperature_K);
    field.hottest_K_ = static_cast<double>(hottest->temperature_K);
    return field;
}

PlumeField::Cell PlumeField::cellOf(const GasVector& place_m) const {
    Cell cell;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const Bracket found = bracket(axes_m_[axis], place_m[axis]);
        cell.before[axis] = found.below;
        cell.part[axis] = found.fraction;
    }
    return cell;
}

GasVector PlumeField::placeOf(const Cell& cell) const {
    GasVector place_m{};
    for (std::size_t axis = 0; axis < 3; ++axis)
        place_m[axis] = std::lerp(axes_m_[axis][cell.before[axis]],
                                  axes_m_[axis][cell.before[axis] + 1], cell.part[axis]);
    return place_m;
}

template <typename Take>
void PlumeField::around(const Cell& cell, const Take& take) const {
    for (std::size_t corner = 0; corner < 8; ++corner) {
        double weight = 1.0;
        std::array<std::size_t, 3> at = cell.before;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const bool isNext = (corner >> axis & 1) != 0;
            weight *= isNext ? cell.part[axis] : 1.0 - cell.part[axis];
            at[axis] += isNext ? 1 : 0;
        }
        if (weight > 0.0)
            take(nodes_[numberOf(at[0], at[1], at[2])], weight);
    }
}

GasLayer PlumeField::in(const Cell& cell) const {
    GasMean mean;
    around(cell, [&](const Node& node, double weight) { mean.add(node.gas(), weight); });
    return mean.mean();
}

GasLayer PlumeField::at(const GasVector& place_m) const {
    return in(cellOf(place_m));
}

bool PlumeField::isGasAt(const GasVector& place_m) const {
    double part = 0.0;
    around(cellOf(place_m),
           [&](const Node& node, double weight) { part += node.isGas ? weight : 0.0; });
    return part >= 0.5;
}

std::size_t PlumeField::boxesPerAxis(const std::array<std::size_t, 3>& cell) const {
    constexpr double finest = 0.02; // of all temperatures, as roots above the coldest
    constexpr std::size_t most = 4;
    double coldest_K = hottest_K_, hottest_K = coldest_K_;
    bool doesAbsorb = false;
    around({cell, {0.5, 0.5, 0.5}}, [&](const Node& node, double /*weight*/) {
        coldest_K = std::min(coldest_K, static_cast<double>(node.temperature_K));
        hottest_K = std::max(hottest_K, static_cast<double>(node.temperature_K));
        doesAbsorb = doesAbsorb || thinAbsorption(node.gas()) > 0.0;
    });
    if (!doesAbsorb)
        return 0;
    return std::min(most,
                    1 + static_cast<std::size_t>((rootOf(hottest_K) - rootOf(coldest_K)) / finest));
}

double PlumeField::rootOf(double temperature_K) const {
    if (!(hottest_K_ > coldest_K_))
        return 0.0;
    return std::sqrt(
        std::clamp((temperature_K - coldest_K_) / (hottest_K_ - coldest_K_), 0.0, 1.0));
}

std::vector<PlumePart> PlumeField::parts() const {
    constexpr std::size_t steps = 4000;
    std::vector<GasMean> means(steps + 1);
    std::vector<double> absorbs(steps + 1, 0.0);
    forEachBox([&](const Box& box) {
        const auto step = static_cast<std::size_t>(rootOf(box.gas.temperature_K) * steps);
        const double own = thinAbsorption(box.gas) * box.volume_m3;
        means[step].add(box.gas, own);
        absorbs[step] += own;
    });
    std::vector<PlumePart> parts;
    for (std::size_t step = 0; step <= steps; ++step)
        if (absorbs[step] > 0.0)
            parts.push_back({means[step].mean(), absorbs[step]});
    return parts;
}

std::vector<double> planesByDensity(double from_m, double to_m, const std::vector<double>& density,
                                    double even, std::size_t count) {
    const double all = std::accumulate(density.begin(), density.end(), 0.0);
    const auto cells = static_cast<double>(density.size());
    std::vector<double> before{0.0}; // the part of all before each end of a cell
    for (const double own : density)
        before.push_back(before.back() + (1.0 - even) * (all > 0.0 ? own / all : 1.0 / cells) +
                         even / cells);
    std::vector<double> ends_m;
    for (std::size_t i = 0; i < before.size(); ++i)
        ends_m.push_back(std::lerp(from_m, to_m, static_cast<double>(i) / cells));
    std::vector<double> planes_m;
    for (std::size_t i = 0; i < count; ++i)
        planes_m.push_back(
            interpolate(before, ends_m,
                        before.back() * static_cast<double>(i) / static_cast<double>(count - 1)));
    planes_m.back() = to_m;
    return planes_m;
}

} // namespace irsg
