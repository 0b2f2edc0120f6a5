#include "irsg/atmosphere/engine/NodeAbsorption.h"

#include <algorithm>
#include <cmath>

#include "irsg/core/VectorClones.h"
#include "irsg/radiometry/VectorExp.h"

namespace irsg {

namespace {

constexpr std::size_t nodesAtOnce = 512; ///< their sums stay in the nearest cache

/// Adds four weighted rows.
IRSG_VECTOR_CLONES void addRows(const float* const* rows, const float* weights, std::size_t first,
                                std::size_t count, float* sums) {
    const float *a = rows[0] + first, *b = rows[1] + first, *c = rows[2] + first,
                *d = rows[3] + first;
    const float wa = weights[0], wb = weights[1], wc = weights[2], wd = weights[3];
    for (std::size_t i = 0; i < count; ++i)
        sums[i] = (((sums[i] + wa * a[i]) + wb * b[i]) + wc * c[i]) + wd * d[i];
}

/// Adds the absorption of cross sections given in steps; `offset` is the logarithm of what 0 steps
/// absorb.
IRSG_VECTOR_CLONES void addAbsorption(const float* steps, float offset, std::size_t count,
                                      float* out) {
    constexpr auto step = static_cast<float>(GasTable::lnStep);
    for (std::size_t i = 0; i < count; ++i) {
        const float absorption = vectorExp(steps[i] * step + offset);
        out[i] += steps[i] > 0.0f ? absorption : 0.0f;
    }
}

} // namespace

NodeAbsorption::NodeAbsorption(const GasTable& gases, std::span<const std::uint32_t> nodes)
    : gases_(gases), size_(nodes.size()) {
    for (std::size_t gas = 0; gas < lineGasCount; ++gas) {
        Rows& own = own_[gas];
        own.columns = gases_.columns(static_cast<Gas>(gas), nodes);
        if (std::ranges::any_of(own.columns, [](std::int32_t column) { return column >= 0; }))
            own.rows = std::vector<Row>(gases_.grid().points(static_cast<Gas>(gas)));
    }
}

const float* NodeAbsorption::row(Gas gas, std::size_t point) const {
    Rows& own = own_[static_cast<std::size_t>(gas)];
    Row& row = own.rows[point];
    row.once.call([&] {
        row.steps.resize(size_);
        gases_.steps(gas, point, own.columns, row.steps);
    });
    return row.steps.data();
}

void NodeAbsorption::at(const AtmosphericState& air, std::span<float> out) const {
    std::ranges::fill(out, 0.0f);
    std::array<float, nodesAtOnce> sums;
    std::array<const float*, GridStencil::most> rows;
    for (std::size_t g = 0; g < lineGasCount; ++g) {
        const auto gas = static_cast<Gas>(g);
        const double density_per_m3 = air.density_per_m3(gas);
        if (own_[g].rows.empty() || density_per_m3 <= 0.0)
            continue;
        const GridStencil around = gases_.grid().stencil(gas, air);
        for (std::size_t k = 0; k < around.count; ++k)
            rows[k] = row(gas, around.points[k]);
        const auto offset =
            static_cast<float>(std::log(density_per_m3 * 1e-4) + GasTable::lnLowest);
        static_assert(GridStencil::most % 4 == 0); // twelve points, or twice as many
        for (std::size_t first = 0; first < size_; first += nodesAtOnce) {
            const std::size_t count = std::min(nodesAtOnce, size_ - first);
            std::fill_n(sums.begin(), count, 0.0f);
            for (std::size_t k = 0; k < around.count; k += 4)
                addRows(rows.data() + k, around.weights.data() + k, first, count, sums.data());
            addAbsorption(sums.data(), offset, count, out.data() + first);
        }
    }
}

} // namespace irsg
