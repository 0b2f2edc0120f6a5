#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "irsg/atmosphere/engine/CallOnceFast.h"
#include "irsg/atmosphere/engine/GasTable.h"

namespace irsg {

/// Absorption by all line gases of a GasTable at a few of its nodes. Rows of the table are drawn
/// together for these nodes when a state of the air first needs them, and kept, so that every state
/// costs one sweep through contiguous rows. Const members may be called from several threads.
class NodeAbsorption {
  public:
    /// `gases` must live as long.
    NodeAbsorption(const GasTable& gases, std::span<const std::uint32_t> nodes);

    /// m-1, as many as nodes. Pressures and temperatures beyond the grid are clamped to it.
    void at(const AtmosphericState& air, std::span<float> out) const;

  private:
    struct Row {
        CallOnceFast once;
        std::vector<float> steps; ///< see GasTable::steps
    };
    const float* row(Gas gas, std::size_t point) const;

    const GasTable& gases_;
    std::size_t size_;
    struct Rows {
        std::vector<std::int32_t> columns; ///< of the nodes in the table, see GasTable::columns
        std::vector<Row> rows;             ///< [grid point]; none where the gas does not absorb
    };
    mutable std::array<Rows, lineGasCount> own_;
};

} // namespace irsg
