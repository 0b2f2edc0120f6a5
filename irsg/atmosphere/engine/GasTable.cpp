#include "irsg/atmosphere/engine/GasTable.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "irsg/atmosphere/engine/ResourceFile.h"
#include "irsg/radiometry/Errors.h"

namespace irsg {

namespace {

constexpr double lnLowest = -75.98530778; // ln 1e-33
constexpr double lnStep = 1.0 / 1450.0;

std::uint16_t encoded(double lnCrossSection) {
    const double steps = (lnCrossSection - lnLowest) / lnStep;
    return static_cast<std::uint16_t>(std::clamp(std::round(steps), 0.0, 65535.0));
}

/// Lagrange's weights of `count` neighbouring nodes of an ascending or descending axis, clamped to
/// it.
template <std::size_t count>
std::size_t lagrange(const std::vector<double>& axis, double x,
                     std::array<double, count>& weights) {
    const bool descending = axis.front() > axis.back();
    const double low = std::min(axis.front(), axis.back());
    const double high = std::max(axis.front(), axis.back());
    x = std::clamp(x, low, high);
    const auto above = descending ? std::ranges::lower_bound(axis, x, std::greater<>())
                                  : std::ranges::lower_bound(axis, x);
    const auto upper = static_cast<std::ptrdiff_t>(above - axis.begin());
    std::ptrdiff_t first = upper - static_cast<std::ptrdiff_t>(count) / 2;
    if constexpr (count == 3) { // the middle node is the nearest one
        first = upper - 1;
        if (upper > 0 && upper < static_cast<std::ptrdiff_t>(axis.size()) &&
            std::abs(axis[static_cast<std::size_t>(upper - 1)] - x) <
                std::abs(axis[static_cast<std::size_t>(upper)] - x))
            first = upper - 2;
    }
    first = std::clamp<std::ptrdiff_t>(first, 0, static_cast<std::ptrdiff_t>(axis.size() - count));
    const auto start = static_cast<std::size_t>(first);
    for (std::size_t i = 0; i < count; ++i) {
        weights[i] = 1.0;
        for (std::size_t j = 0; j < count; ++j)
            if (j != i)
                weights[i] *= (x - axis[start + j]) / (axis[start + i] - axis[start + j]);
    }
    return start;
}

} // namespace

std::pair<std::size_t, std::size_t> BinSet::range(double lower_cm, double upper_cm) const {
    const auto first = std::ranges::upper_bound(bins, lower_cm, {}, &SpectralBin::upper_cm);
    const auto last = std::ranges::lower_bound(bins, upper_cm, {}, &SpectralBin::lower_cm);
    const auto begin = static_cast<std::size_t>(first - bins.begin());
    return {begin, std::max(begin, static_cast<std::size_t>(last - bins.begin()))};
}

GasTable::GasTable(Grid grid, std::vector<double> nodeWavenumbers_cm, std::vector<Block> blocks,
                   std::array<BinSet, 3> bins, std::string header)
    : grid_(std::move(grid)),
      header_(std::move(header)),
      wavenumbers_cm_(std::move(nodeWavenumbers_cm)),
      bins_(std::move(bins)) {
    std::ranges::sort(blocks, {},
                      [](const Block& block) { return std::pair(block.gas, block.node); });
    for (const Block& block : blocks) {
        const auto gas = static_cast<std::size_t>(block.gas);
        if (gas >= lineGasCount || block.node >= nodeCount() ||
            block.lnCrossSection.size() != gridPoints(block.gas))
            throw LogicError("a block of cross sections does not fit the grid of its table");
        gases_[gas].nodes.push_back(block.node);
    }
    std::size_t next = 0;
    for (std::size_t gas = 0; gas < lineGasCount; ++gas) {
        GasNodes& own = gases_[gas];
        const std::size_t points = gridPoints(static_cast<Gas>(gas));
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
    if (grid_.pressures_hPa.size() < 4 || grid_.temperatures_K.size() < 3 ||
        grid_.moistPressures > grid_.pressures_hPa.size() ||
        (grid_.moistPressures > 0 && grid_.moistPressures < 4))
        throw LogicError("the grid of a gas table is too small to interpolate in");
    if (!std::ranges::is_sorted(grid_.pressures_hPa, std::greater<>()) ||
        !std::ranges::is_sorted(grid_.temperatures_K))
        throw LogicError("the grid of a gas table is not in order");
    for (std::size_t gas = 0; gas < lineGasCount; ++gas) {
        GasNodes& own = gases_[gas];
        own.position.assign(nodeCount(), -1);
        for (std::size_t i = 0; i < own.nodes.size(); ++i) {
            if (own.nodes[i] >= nodeCount() || own.position[own.nodes[i]] >= 0)
                throw LogicError("a gas table names a node twice or one that it does not have");
            own.position[own.nodes[i]] = static_cast<std::int32_t>(i);
        }
        if (own.values.size() != own.nodes.size() * gridPoints(static_cast<Gas>(gas)))
            throw LogicError("a gas table has not as many values as nodes and grid points");
    }
    for (const BinSet& set : bins_) {
        if (set.nodes.size() != set.weights.size())
            throw LogicError("the bins of a gas table have not as many weights as nodes");
        for (const SpectralBin& bin : set.bins)
            if (bin.count == 0 || std::size_t(bin.first) + bin.count > set.nodes.size() ||
                bin.lower_cm >= bin.upper_cm)
                throw LogicError("a bin of a gas table is empty");
        for (const std::uint32_t node : set.nodes)
            if (node >= nodeCount())
                throw LogicError("a bin of a gas table names a node that it does not have");
    }
}

std::size_t GasTable::gridPoints(Gas gas) const {
    const std::size_t rows =
        grid_.pressures_hPa.size() + (gas == Gas::H2O ? grid_.moistPressures : 0);
    return rows * grid_.temperatures_K.size();
}

std::shared_ptr<const GasTable> GasTable::shipped() {
    static const std::shared_ptr<const GasTable> table = read(atmosphereResource("gases.gastable"));
    return table;
}

const BinSet& GasTable::bins(int resolution_cm) const {
    for (std::size_t i = 0; i < std::size(resolutions_cm); ++i)
        if (resolutions_cm[i] == resolution_cm)
            return bins_[i];
    throw LogicError("a resolution of " + std::to_string(resolution_cm) +
                     " cm-1 was asked for; there are 1, 5 and 15");
}

double GasTable::lower_cm() const {
    return bins_[0].bins.front().lower_cm;
}

double GasTable::upper_cm() const {
    return bins_[0].bins.back().upper_cm;
}

/// Weights of the grid points that surround a state of the air.
struct GasTable::Stencil {
    static constexpr std::size_t most = 24;
    std::array<std::uint32_t, most> points{};
    std::array<float, most> weights{};
    std::size_t count = 0;

    void add(std::size_t point, double weight) {
        points[count] = static_cast<std::uint32_t>(point);
        weights[count++] = static_cast<float>(weight);
    }
};

GasTable::Stencil GasTable::stencil(Gas gas, const AirState& air) const {
    // The logarithm of the pressure is what the cross sections are smooth in.
    std::array<double, 4> alongPressure{};
    std::array<double, 3> alongTemperature{};
    const std::size_t temperatures = grid_.temperatures_K.size();
    std::vector<double> lnPressures(grid_.pressures_hPa.size());
    std::ranges::transform(grid_.pressures_hPa, lnPressures.begin(),
                           [](double p) { return std::log(p); });
    const double lnPressure = std::log(air.pressure_hPa);
    const std::size_t row = lagrange(lnPressures, lnPressure, alongPressure);
    const std::size_t column = lagrange(grid_.temperatures_K, air.temperature_K, alongTemperature);

    // Water broadens its own lines: between the dry and the moist set in proportion to its
    // fraction. Above the pressures that have a moist set there is too little of it to matter.
    double moist = 0.0;
    if (gas == Gas::H2O && row + 4 <= grid_.moistPressures)
        moist = air.fraction(Gas::H2O) / grid_.moistFraction;
    Stencil stencil;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 3; ++j) {
            const double weight = alongPressure[i] * alongTemperature[j];
            const std::size_t point = (row + i) * temperatures + column + j;
            stencil.add(point, weight * (1.0 - moist));
            if (moist > 0.0)
                stencil.add(point + grid_.pressures_hPa.size() * temperatures, weight * moist);
        }
    return stencil;
}

void GasTable::absorption_per_m(const AirState& air, std::span<const std::uint32_t> nodes,
                                std::span<float> out) const {
    std::ranges::fill(out, 0.0f);
    constexpr std::size_t block = 256;
    std::array<std::uint32_t, block> places;
    std::array<std::int32_t, block> positions;
    std::array<float, block> lnCross;

    for (std::size_t gas = 0; gas < lineGasCount; ++gas) {
        const GasNodes& own = gases_[gas];
        const double density_per_m3 = air.density_per_m3(static_cast<Gas>(gas));
        if (own.nodes.empty() || density_per_m3 <= 0.0)
            continue;
        const Stencil around = stencil(static_cast<Gas>(gas), air);
        const auto offset = static_cast<float>(std::log(density_per_m3 * 1e-4) + lnLowest);
        std::size_t next = 0;
        while (next < nodes.size()) {
            std::size_t count = 0;
            for (; next < nodes.size() && count < block; ++next)
                if (const std::int32_t position = own.position[nodes[next]]; position >= 0) {
                    places[count] = static_cast<std::uint32_t>(next);
                    positions[count++] = position;
                }
            std::fill_n(lnCross.begin(), count, 0.0f);
            for (std::size_t k = 0; k < around.count; ++k) {
                const std::uint16_t* row = own.values.data() + around.points[k] * own.nodes.size();
                const float weight = around.weights[k];
                for (std::size_t i = 0; i < count; ++i)
                    lnCross[i] += weight * static_cast<float>(row[positions[i]]);
            }
            for (std::size_t i = 0; i < count; ++i)
                if (lnCross[i] > 0.0f)
                    out[places[i]] += std::exp(lnCross[i] * static_cast<float>(lnStep) + offset);
        }
    }
}

double GasTable::crossSection_cm2(std::uint32_t node, Gas gas, const AirState& air) const {
    const auto which = static_cast<std::size_t>(gas);
    if (which >= lineGasCount || gases_[which].position.at(node) < 0)
        return 0.0;
    const GasNodes& own = gases_[which];
    const Stencil around = stencil(gas, air);
    double steps = 0.0;
    for (std::size_t k = 0; k < around.count; ++k)
        steps += static_cast<double>(around.weights[k]) *
                 own.values[around.points[k] * own.nodes.size() +
                            static_cast<std::size_t>(own.position[node])];
    return steps > 0.0 ? std::exp(steps * lnStep + lnLowest) : 0.0;
}

} // namespace irsg
