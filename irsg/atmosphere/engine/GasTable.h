#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "irsg/atmosphere/engine/CrossSectionGrid.h"

namespace irsg {

/// A spectral interval whose mean is a weighted sum over a few monochromatic nodes:
/// mean f = sum of weight * f(node).
struct SpectralBin {
    double lower_per_cm = 0.0;
    double upper_per_cm = 0.0;
    std::uint32_t first = 0; ///< into BinSet::nodes and weights
    std::uint32_t count = 0;

    double centre_per_cm() const { return 0.5 * (lower_per_cm + upper_per_cm); }
};

/// Bins of one resolution, ascending and touching each other.
struct BinSet {
    double resolution_per_cm = 5.0;
    std::vector<SpectralBin> bins;
    std::vector<std::uint32_t> nodes;
    std::vector<float> weights; ///< positive, sum 1 in a bin

    /// First bin that reaches above `lower_per_cm` and one past the last that begins below
    /// `upper_per_cm`.
    std::pair<std::size_t, std::size_t> range(double lower_per_cm, double upper_per_cm) const;
};

/// Absorption of the line gases at selected single wavenumbers ("nodes", optimal spectral sampling:
/// Moncet et al. 2008, J. Atmos. Sci. 65, 3917), computed line by line and tabulated over pressure
/// and temperature. At a node everything is monochromatic, so paths through inhomogeneous air,
/// overlapping gases, emission and multiple scattering need no approximation; the only error is
/// that of the sum over nodes, which was trained against line by line, and of interpolation in the
/// table.
class GasTable {
  public:
    static constexpr int resolutions_per_cm[] = {1, 5, 15};

    using Grid = CrossSectionGrid;
    /// One node and one gas: ln of the cross section (cm2) on the grid, temperature running
    /// fastest, the dry set first and for water the moist set after it. Kept in steps of 1/1450
    /// between ln 1e-33 and ln 4e-14 cm2; less counts as nothing.
    struct Block {
        std::uint32_t node = 0;
        Gas gas = Gas::H2O;
        std::vector<float> lnCrossSection;
    };

    /// From memory, for the program that writes tables and for tests. Throws LogicError for blocks
    /// of the wrong size, bins that name unknown nodes.
    GasTable(Grid grid, std::vector<double> nodeWavenumbers_per_cm, std::vector<Block> blocks,
             std::array<BinSet, 3> bins, std::string header);
    /// Reads and writes `.gastable`. Throws InputError for a damaged or foreign file.
    static std::shared_ptr<const GasTable> read(const std::filesystem::path& file);
    void write(const std::filesystem::path& file) const;
    /// The table that is shipped (resources/atmosphere/gases.gastable), read once a process.
    static std::shared_ptr<const GasTable> shipped();

    const std::string& header() const { return header_; } ///< recipe, sources, expected errors
    const Grid& grid() const { return grid_; }
    std::size_t nodeCount() const { return wavenumbers_per_cm_.size(); }
    double wavenumber_per_cm(std::uint32_t node) const { return wavenumbers_per_cm_[node]; }
    /// Bins of 1, 5 or 15 cm-1 (LogicError for others). Where the data are coarser, so are the
    /// bins.
    const BinSet& bins(int resolution_per_cm) const;
    /// 200 to 50000 cm-1 and what of it this table covers.
    double lower_per_cm() const;
    double upper_per_cm() const;

    /// Absorption by all line gases, m-1, at `nodes` for air; `out` as many as nodes. Pressures and
    /// temperatures beyond the grid are clamped to it.
    void absorption_per_m(const AtmosphericState& air, std::span<const std::uint32_t> nodes,
                          std::span<float> out) const;
    /// Cross section of one gas at one node, cm2 per molecule; 0 where the table holds none.
    double crossSection_cm2(std::uint32_t node, Gas gas, const AtmosphericState& air) const;

    /// Steps of `lnStep` above `lnLowest` in which logarithms of cross sections in cm2 are kept; 0
    /// steps count as nothing.
    static constexpr double lnLowest = -75.98530778; // ln 1e-33
    static constexpr double lnStep = 1.0 / 1450.0;
    /// The columns that nodes have in the table of a gas; negative where it does not absorb.
    std::vector<std::int32_t> columns(Gas gas, std::span<const std::uint32_t> nodes) const;
    /// The steps of a gas at a grid point in some columns, 0 for negative ones.
    void steps(Gas gas, std::size_t point, std::span<const std::int32_t> columns,
               std::span<float> out) const;

  private:
    GasTable() = default;
    /// All nodes at which one gas absorbs. Values run over these nodes fastest, so that a level of
    /// air is computed in long sweeps.
    struct GasNodes {
        std::vector<std::uint32_t> nodes;   ///< ascending
        std::vector<std::int32_t> position; ///< of every node of the table in `nodes`, or -1
        std::vector<std::uint16_t> values;  ///< [grid point][node of the gas], see lnStep
    };
    void index();

    Grid grid_;
    std::string header_;
    std::vector<double> wavenumbers_per_cm_;
    std::array<GasNodes, lineGasCount> gases_;
    std::array<BinSet, 3> bins_;
};

} // namespace irsg
