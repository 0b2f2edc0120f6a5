#pragma once

#include "irsg/geometry/Entity.h"
#include "irsg/signature/EntityState.h"

namespace irsg {

struct ObjectGeometry;

/// The state of an entity with what follows from its place: altitude, ambient temperature and the
/// aspect angle under which it is seen.
EntityState stateInPlace(const Entity& entity, const ObjectGeometry& geometry, double ambient_K);

/// Temperature of the surfaces of an entity with a temperature index that has an entry, in a state
/// of stateInPlace(), K: the one place that tells where temperatures of surfaces come from, which
/// is eq. 7 of the entry. The entity's scales are not in it. May be <= 0 for a database that is
/// wrong: the scene check names the entry.
double surfaceTemperature_K(const Entity& entity, int index, const EntityState& inPlace);

} // namespace irsg
