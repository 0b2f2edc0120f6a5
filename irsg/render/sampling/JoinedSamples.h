#pragma once

#include <cstddef>
#include <vector>

#include "irsg/render/sampling/Samples.h"
#include "irsg/render/sampling/SurfaceScene.h"

namespace irsg {

/// Rows of a tile are summed in so many parts, whatever the number of cores: samples at their
/// borders stay alone, as SublatticeDifferences counts them half.
inline constexpr std::size_t partsOfTile = 8;

/// How smooth a surface must be for four of its samples to be one, by drawn row.
struct JoinLimits {
    /// What factors of the samples may differ by, those of a normal by less for surfaces with
    /// lobes; 0: such samples stay alone.
    std::vector<double> mostDifference;
    std::size_t firstNormal = 0; ///< factor; as many as there are factors where there is none
    std::vector<double> mostBend;
    std::vector<bool> isGas; ///< by drawn row
};

/// Lets one of two by two samples of a block, and so of a pixel, stand for all four where these
/// show a smooth opaque surface of one row or none, and nothing before it but walls of gases at
/// distances alike: what is computed for a sample, such as where on the surface it lies and what
/// its lobes meet, is then computed once for the four. Its factors are their mean, which is what
/// sums of them make; the four stand for theirs in turn, so that what is found there is not found
/// to one side of them. Layers must be sorted, and have distances.
void joinSmoothSamples(const SheetScene& sheet, const JoinLimits& limits, GeometrySamples& samples);

/// Gives each sample what the one has that stands for it.
void giveToGroups(const SampleSheet& sheet, const GeometrySamples& samples,
                  RadianceSamples& radiances);

} // namespace irsg
