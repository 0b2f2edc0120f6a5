#pragma once

#include "irsg/render/sampling/SampleSheet.h"
#include "irsg/render/sampling/Samples.h"

namespace irsg {

/// Sets what samples of tiles that are cut count beside others of their block for what gas emits
/// (GeometrySamples::gasShares), so that what changes linearly over a block is summed exactly.
///
/// The samples of a row stand off the middles of their cells, all to one side, as do those of a
/// column (SampleTile::placeOf). The sum over a block is therefore one over a block that is moved,
/// and that over all blocks is off by what shines at the border of the tile times the distance:
/// nothing at the border of an object, but much where a finer tile draws a detail of a plume from
/// there on. Shares have the mean 1 over a row and over a column of a block, so that pixels keep
/// their area. Edges are no such thing, and what surfaces send is not shared out: two samples of a
/// row can count as 0 and 2 of them.
///
/// Groups of samples (joinSmoothSamples) must be known.
void shareOutGas(const SampleSheet& sheet, GeometrySamples& samples);

} // namespace irsg
