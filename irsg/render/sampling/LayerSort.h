#pragma once

#include <span>

#include "irsg/render/sampling/Samples.h"

namespace irsg {

/// Copies listed fragments so that those of every sample stand next to each other: what follows
/// reads them in order, where numbers of fragments would have it look all over the list.
/// `wordsPerFragment` of the samples is set.
void gatherFragments(std::span<const float> list, GeometrySamples& samples);

/// Sorts the fragments of each sample from front to back. At most `maximumLayers` of a sample
/// count: the farthest are left out, and the sample is counted. Depth is reversed, so near is
/// large; fragments of equal depth are taken in the order of their values, so that the result does
/// not depend on the order of drawing. Runs on all cores; the result does not depend on their
/// number.
void sortLayers(GeometrySamples& samples, int maximumLayers);

} // namespace irsg
