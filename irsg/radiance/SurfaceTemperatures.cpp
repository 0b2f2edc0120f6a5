#include "irsg/radiance/SurfaceTemperatures.h"

#include "irsg/radiance/SceneAtmosphere.h"
#include "irsg/signature/SurfaceTemperature.h"

namespace irsg {

EntityState stateInPlace(const Entity& entity, const ObjectGeometry& geometry, double ambient_K) {
    EntityState state = entity.state;
    state.altitude_m = geometry.path.targetAltitude_m;
    state.ambient_K = ambient_K;
    state.aspectAngle_rad = geometry.aspectAngle_rad;
    return state;
}

double surfaceTemperature_K(const Entity& entity, int index, const EntityState& inPlace) {
    return surfaceTemperature_K(temperatureEntry(entity, index)->terms, inPlace);
}

} // namespace irsg
