#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "irsg/gas/GasVector.h"
#include "irsg/gas/PlumeField.h"

namespace irsg {

/// Surfaces of equal temperature of a field: closed, each in those of lower temperatures, none
/// through another. The temperature is sampled at a grid of its own, whose planes lie closer where
/// it changes more, and is linear in the tetrahedra of which five make a cell (their edges are
/// those of the next cells). Beyond the field it falls within a thin layer below all.
class FieldWalls {
  public:
    struct Surface {
        std::vector<GasVector> vertices_m;
        /// Counter-clockwise from outside, where it is colder.
        std::vector<std::array<std::uint32_t, 3>> triangles;
    };

    /// Of gas of at least that temperature, with about so many nodes. LogicError below 8.
    FieldWalls(const PlumeField& field, double coldest_K, std::size_t nodes);

    /// Around as much volume as the field has from that temperature on; at 0 K around all gas.
    Surface surfaceFrom(double from_K) const;
    /// The temperature of that surface, at which it is between the nodes of the grid.
    double levelFor(double from_K) const;
    /// Below `nothing_K()` outside the gas.
    double temperature_K(const GasVector& place_m) const;
    /// A temperature below all gas and above what is outside.
    double nothing_K() const { return nothing_K_; }
    const PlumeField::Axes& axes_m() const { return axes_m_; }

  private:
    std::size_t numberOf(std::size_t x, std::size_t y, std::size_t z) const {
        return (x * axes_m_[1].size() + y) * axes_m_[2].size() + z;
    }
    GasVector placeOf(std::size_t node) const;
    void compareVolumes(const PlumeField& field, double coldest_K, double hottest_K);

    PlumeField::Axes axes_m_;
    std::vector<double> nodes_K_;
    double nothing_K_ = 0.0;
    /// Temperatures, falling, and the volumes from them on: of the field and of the grid, rising.
    std::vector<double> levels_K_, fieldFrom_m3_, ownFrom_m3_;
};

} // namespace irsg
