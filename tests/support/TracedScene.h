#pragma once

#include <vector>

#include "irsg/scene/Scene.h"
#include "tests/support/PathTracer.h"

namespace irsg::test {

/// The facets of a scene's entities in the world as the path tracer takes them, in a band; `body`
/// is the number of the entity. Temperatures are those of the entries alone (base_K). Materials of
/// transmissivity 1 are not there; LogicError for any other that is not grey, opaque and even.
std::vector<TracedTriangle> tracedOf(const Scene& scene, const Band& band);

/// Facets of a model file lie in one plane but for the rounding of single precision.
double skinOfModel_m(const Model& model);

} // namespace irsg::test
