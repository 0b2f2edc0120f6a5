#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "irsg/atmosphere/engine/GasTable.h"
#include "tests/support/SharedMaterial.h"
#include "tools/atmosphere-tables/lines/CompleteLines.h"
#include "tools/atmosphere-tables/lines/LineAbsorption.h"

namespace irsg::lbl {
namespace {

/// Of a gas at a wavenumber, from the lines that reach there.
double lineByLine_cm2(const LineList& list, const PartitionSums& partition, double at_per_cm,
                      const AtmosphericState& air, double own) {
    const LineShape shape = defaultLineShape(list.gas);
    const auto first = std::ranges::lower_bound(list.lines, at_per_cm - shape.cut_per_cm - 1.0, {},
                                                &Line::wavenumber_per_cm);
    const auto last = std::ranges::upper_bound(list.lines, at_per_cm + shape.cut_per_cm + 1.0, {},
                                               &Line::wavenumber_per_cm);
    constexpr std::size_t aside = 8;
    constexpr double step_per_cm = 0.001;
    const WavenumberGrid grid{at_per_cm - aside * step_per_cm, step_per_cm, 2 * aside + 1};
    return crossSection_cm2({list.gas, {first, last}, {}}, partition, grid, air.temperature_K,
                            air.pressure_hPa, own, shape, negligible_cm2(list.gas))[aside];
}

/// A table that was made of other lines than those at hand shows here, whatever its nodes are.
TEST(ShippedNodes, AbsorbAsTheLinesAtHandDo) {
    const auto data = smat::test::sharedMaterial("data/atmosphere");
    if (data.empty()) {
        GTEST_SKIP() << "the shared material is not beside the checkout";
    }
    const std::shared_ptr<const GasTable> table = GasTable::shipped();
    const PartitionSums partition = PartitionSums::read(data / "lines" / "partition");
    AtmosphericState air{}; // a point of the table's grid
    air.pressure_hPa = 720.0;
    air.temperature_K = 285.0;
    for (const LineList& list : completeLineLists(data)) {
        const double own = list.gas == Gas::O2 ? 0.209 : list.gas == Gas::CO2 ? 4e-4 : 0.0;
        for (std::uint32_t node = 0; node < table->nodeCount(); node += 41) {
            const double at_per_cm = table->wavenumber_per_cm(node);
            const double kept = table->crossSection_cm2(node, list.gas, air);
            if (at_per_cm > 6420.0 || kept < 1e-22) {
                continue;
            }
            const double expected = lineByLine_cm2(list, partition, at_per_cm, air, own);
            EXPECT_NEAR(kept / expected, 1.0, 0.03)
                << gasNames[static_cast<std::size_t>(list.gas)] << " at " << at_per_cm << ": "
                << kept << " for " << expected;
        }
    }
}

} // namespace
} // namespace irsg::lbl
