#include "irsg/atmosphere/engine/GasTable.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "irsg/atmosphere/engine/NodeAbsorption.h"
#include "irsg/atmosphere/engine/ResourceFile.h"
#include "irsg/core/Errors.h"

namespace irsg {

namespace {

std::uint16_t encoded(double lnCrossSection) {
    const double steps = (lnCrossSection - GasTable::lnLowest) / GasTable::lnStep;
    return static_cast<std::uint16_t>(std::clamp(std::round(steps), 0.0, 65535.0));
}

} // namespace

std::pair<std::size_t, std::size_t> BinSet::range(double lower_per_cm, double upper_per_cm) const {
    const auto first = std::ranges::upper_bound(bins, lower_per_cm, {}, &SpectralBin::upper_per_cm);
    const auto last = std::ranges::lower_bound(bins, upper_per_cm, {}, &SpectralBin::lower_per_cm);
    const auto begin = static_cast<std::size_t>(first - bins.begin());
    return {begin, std::max(begin, static_cast<std::size_t>(last - bins.begin()))};
}

GasTable::GasTable(Grid grid, std::vector<double> nodeWavenumbers_per_cm, std::vector<Block> blocks,
                   std::array<BinSet, 3> bins, std::string header)
    : grid_(std::move(grid)),
      header_(std::move(header)),
      wavenumbers_per_cm_(std::move(nodeWavenumbers_per_cm)),
      bins_(std::move(bins)) {
    std::ranges::sort(blocks, {},
                      [](const Block& block) { return std::pair(block.gas, block.node); });
    for (const Block& block : blocks) {
        const auto gas = static_cast<std::size_t>(block.gas);
        if (gas >= lineGasCount || block.node >= nodeCount() ||
            block.lnCrossSection.size() != grid_.points(block.gas))
            throw LogicError("a block of cross sections does not fit the grid of its table");
        gases_[gas].nodes.push_back(block.node);
    }
    std::size_t next = 0;
    for (std::size_t gas = 0; gas < lineGasCount; ++gas) {
        GasNodes& own = gases_[gas];
        const std::size_t points = grid_.points(static_cast<Gas>(gas));
        own.values.resize(points * own.nodes.size());
        for (std::size_t i = 0; i < own.nodes.size(); ++i, ++next)
            for (std::size_t point = 0; point < points; ++point)
                own.values[point * own.nodes.size() + i] =
                    encoded(blocks[next].lnCrossSection[point]);
    }
    index();
}

/// Checks what the parts promise each other and finds the position of every node.
void GasTable::index() {
    grid_.check();
    for (std::size_t gas = 0; gas < lineGasCount; ++gas) {
        GasNodes& own = gases_[gas];
        own.position.assign(nodeCount(), -1);
        for (std::size_t i = 0; i < own.nodes.size(); ++i) {
            if (own.nodes[i] >= nodeCount() || own.position[own.nodes[i]] >= 0)
                throw LogicError("a gas table names a node twice or one that it does not have");
            own.position[own.nodes[i]] = static_cast<std::int32_t>(i);
        }
        if (own.values.size() != own.nodes.size() * grid_.points(static_cast<Gas>(gas)))
            throw LogicError("a gas table has not as many values as nodes and grid points");
    }
    for (const BinSet& set : bins_) {
        if (set.nodes.size() != set.weights.size())
            throw LogicError("the bins of a gas table have not as many weights as nodes");
        for (const SpectralBin& bin : set.bins)
            if (bin.count == 0 || std::size_t(bin.first) + bin.count > set.nodes.size() ||
                bin.lower_per_cm >= bin.upper_per_cm)
                throw LogicError("a bin of a gas table is empty");
        for (const std::uint32_t node : set.nodes)
            if (node >= nodeCount())
                throw LogicError("a bin of a gas table names a node that it does not have");
    }
}

std::shared_ptr<const GasTable> GasTable::shipped() {
    static const std::shared_ptr<const GasTable> table = read(atmosphereResource("gases.gastable"));
    return table;
}

const BinSet& GasTable::bins(int resolution_per_cm) const {
    for (std::size_t i = 0; i < std::size(resolutions_per_cm); ++i)
        if (resolutions_per_cm[i] == resolution_per_cm)
            return bins_[i];
    throw LogicError("a resolution of " + std::to_string(resolution_per_cm) +
                     " cm-1 was asked for; there are 1, 5 and 15");
}

double GasTable::lower_per_cm() const {
    return bins_[0].bins.front().lower_per_cm;
}

double GasTable::upper_per_cm() const {
    return bins_[0].bins.back().upper_per_cm;
}

void GasTable::absorption_per_m(const AtmosphericState& air, std::span<const std::uint32_t> nodes,
                                std::span<float> out) const {
    NodeAbsorption(*this, nodes).at(air, out);
}

std::vector<std::int32_t> GasTable::columns(Gas gas, std::span<const std::uint32_t> nodes) const {
    std::vector<std::int32_t> columns;
    columns.reserve(nodes.size());
    for (const std::uint32_t node : nodes)
        columns.push_back(gases_[static_cast<std::size_t>(gas)].position[node]);
    return columns;
}

void GasTable::steps(Gas gas, std::size_t point, std::span<const std::int32_t> columns,
                     std::span<float> out) const {
    const GasNodes& own = gases_[static_cast<std::size_t>(gas)];
    const std::uint16_t* row = own.values.data() + point * own.nodes.size();
    for (std::size_t i = 0; i < columns.size(); ++i)
        out[i] = columns[i] >= 0 ? static_cast<float>(row[columns[i]]) : 0.0f;
}

double GasTable::crossSection_cm2(std::uint32_t node, Gas gas, const AtmosphericState& air) const {
    const auto which = static_cast<std::size_t>(gas);
    if (which >= lineGasCount || gases_[which].position.at(node) < 0)
        return 0.0;
    const GasNodes& own = gases_[which];
    const GridStencil around = grid_.stencil(gas, air);
    double steps = 0.0;
    for (std::size_t k = 0; k < around.count; ++k)
        steps += static_cast<double>(around.weights[k]) *
                 own.values[around.points[k] * own.nodes.size() +
                            static_cast<std::size_t>(own.position[node])];
    return steps > 0.0 ? std::exp(steps * lnStep + lnLowest) : 0.0;
}

} // namespace irsg
