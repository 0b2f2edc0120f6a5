#pragma once

#include <cstddef>
#include <vector>

#include "irsg/radiance/SceneSampling.h"

namespace irsg {

/// Decides whether the air of an entity (by its number) is that of its reference point, or is taken
/// at several ranges over its extent (RenderSettings::atmosphereSliceFrom), and fills in
/// `geometry.slices_m`, `geometry.atmosphereError` and `geometry.likelyAtmosphereError`, for which
/// the air next to the object is as dense as altitude makes it, where the bound allows for eight
/// times the mean. `bands`: of the scene with one slice each; gives each the steps by which its
/// outputs take the nodes, so that strong air in one band does not cut the object as finely for all
/// others.
///
/// With T(d) the in-band transmittance for grey light and for that of a body of 300 K, and L(d) the
/// path radiance, the change over the extent is the larger of |ln T(near) / T(far)| and of
/// |L(far) - L(near)| in terms of what arrives. Where it is a small part of the optical depth of
/// the whole path, as most extents are, that is seen without asking the air again. Between the
/// nodes of slices radiance is linear in range: with a change c over a slice at most c^2 / 8 is
/// wrong. Air that answers for the path to the reference point alone is not sliced.
void planSlicesOf(AtmosphericQueryCache& air, std::vector<SampledBand>& bands, std::size_t number,
                  const RenderSettings& settings, ObjectGeometry& geometry);

} // namespace irsg
