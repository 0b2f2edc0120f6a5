#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "irsg/gas/GasByTemperature.h"
#include "irsg/gas/GasLayer.h"
#include "irsg/gas/GasVector.h"

namespace irsg {

/// Gas in three dimensions: its state at the nodes of a grid of planes across three axes.
class PlumeField {
  public:
    using Axes = std::array<std::vector<double>, 3>; ///< m

    /// A node, as short as a million of them want it.
    struct Node {
        float temperature_K = 0.0F, pressure_atm = 1.0F;
        std::array<float, hotGasCount> moleFraction{};
        float oxygenFraction = 0.0F, soot_ppmv = 0.0F;
        bool isGas = true; ///< false outside the plume: there its gas is as thin as can be

        static Node of(const GasLayer& gas);
        GasLayer gas() const; ///< of no length
    };

    /// Axes ascend, 2 planes at least of each; nodes by the first axis, then the second, then the
    /// third. LogicError for another number of nodes.
    static PlumeField ofNodes(Axes axes_m, std::vector<Node> nodes);

    const Axes& axes_m() const { return axes_m_; }
    const std::vector<Node>& nodes() const { return nodes_; }
    std::size_t numberOf(std::size_t x, std::size_t y, std::size_t z) const {
        return (x * axes_m_[1].size() + y) * axes_m_[2].size() + z;
    }
    /// Linear between nodes along each axis, held beyond the ends; outside the plume nothing
    /// absorbs.
    GasLayer at(const GasVector& place_m) const;
    /// Whether at least half of the nodes about a place, weighted as in at(), are gas.
    bool isGasAt(const GasVector& place_m) const;

    /// The root of a temperature above the coldest node, as a part of that of the hottest: 0 to 1.
    double rootOf(double temperature_K) const;
    /// A small box of a field.
    struct Box {
        GasVector middle_m{};
        GasLayer gas; ///< in its middle
        double volume_m3 = 0.0;
    };
    /// Calls visit(box) for each part of its cells in which something absorbs: up to four to a cell
    /// each way, the more the temperature changes there.
    template <typename Visit>
    void forEachBox(const Visit& visit) const;
    /// Its boxes, those of nearly one temperature as one.
    std::vector<PlumePart> parts() const;

  private:
    /// A place between planes: the numbers of those before it, and the parts of the way to the
    /// next.
    struct Cell {
        std::array<std::size_t, 3> before{};
        GasVector part{};
    };
    Cell cellOf(const GasVector& place_m) const;
    GasVector placeOf(const Cell& cell) const;
    GasLayer in(const Cell& cell) const;
    /// 0 where nothing absorbs.
    std::size_t boxesPerAxis(const std::array<std::size_t, 3>& cell) const;
    /// Calls take(node, weight) for the nodes about a place.
    template <typename Take>
    void around(const Cell& cell, const Take& take) const;

    Axes axes_m_;
    std::vector<Node> nodes_;
    double coldest_K_ = 0.0, hottest_K_ = 0.0;
};

template <typename Visit>
void PlumeField::forEachBox(const Visit& visit) const {
    for (std::size_t x = 0; x + 1 < axes_m_[0].size(); ++x)
        for (std::size_t y = 0; y + 1 < axes_m_[1].size(); ++y)
            for (std::size_t z = 0; z + 1 < axes_m_[2].size(); ++z) {
                const std::size_t perAxis = boxesPerAxis({x, y, z});
                const auto parts = static_cast<double>(perAxis);
                const double volume_m3 =
                    (axes_m_[0][x + 1] - axes_m_[0][x]) * (axes_m_[1][y + 1] - axes_m_[1][y]) *
                    (axes_m_[2][z + 1] - axes_m_[2][z]) / (parts * parts * parts);
                const auto middle = [&](std::size_t i) {
                    return (static_cast<double>(i) + 0.5) / parts;
                };
                for (std::size_t i = 0; i < perAxis * perAxis * perAxis; ++i) {
                    const Cell cell{{x, y, z},
                                    {middle(i / (perAxis * perAxis)), middle(i / perAxis % perAxis),
                                     middle(i % perAxis)}};
                    const GasLayer gas = in(cell);
                    if (thinAbsorption(gas) > 0.0)
                        visit(Box{placeOf(cell), gas, volume_m3});
                }
            }
}

/// So many planes between the ends of a range that as much of a density lies between each two of
/// them; `density`: of equal cells of the range, 0 or above; all 0 is even. A part `even` of them,
/// 0 to 1, is spread evenly.
std::vector<double> planesByDensity(double from_m, double to_m, const std::vector<double>& density,
                                    double even, std::size_t count);

} // namespace irsg
