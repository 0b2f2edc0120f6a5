#pragma once

#include <limits>
#include <vector>

#include "irsg/render/sampling/SampleTile.h"

namespace irsg {

/// Straight edges of an object as they are seen: how far they go to the right and down, pixels.
struct ImageEdge {
    double right_px = 0.0, down_px = 0.0;
    int count = 1;
};

/// Variance, over all phases of the lattice, of the area that a tile's samples find beside
/// straight edges, pixels^2 squared: what an edge of length L gives in the directions in which
/// neighbouring samples stand along it,
///
///     sum over edges e and frequencies k of 2 ((e x k) sinc(k e) / (2 pi k^2))^2,
///
/// k in the dual lattice (Poisson's sum of a polygon's Fourier integral). Edges count as
/// independent, and of each row of the dual lattice only the frequency nearest across an edge.
/// Where the sum exceeds `enough_px4`, some value above that.
double varianceOfEdges_px4(const SampleTile& tile, const std::vector<ImageEdge>& edges,
                           double enough_px4 = std::numeric_limits<double>::infinity());

/// The same edges, those that go the same way to within a tenth of the tile's cells as one;
/// equal in whatever order they are given.
std::vector<ImageEdge> withEqualsCounted(const std::vector<ImageEdge>& edges,
                                         const SampleTile& tile);

/// A tile of `size` squared samples with lattices near its own, itself first: none has fewer
/// samples. No lattice suits all edges, as each has directions in which long edges meet its rows,
/// so that one is chosen for the edges there are.
std::vector<SampleTile> latticesNear(const SampleTile& tile, int size);

} // namespace irsg
