#include "irsg/scene/FrameRequest.h"

#include <algorithm>
#include <cmath>

#include "irsg/core/Errors.h"
#include "irsg/radiance/SceneAtmosphere.h"

namespace irsg {

namespace {

LineOfSight centreOf(const Viewpoint& viewpoint) {
    const Vec3 view = viewpoint.forward();
    LineOfSight sight;
    sight.sensorAltitude_m = std::max(viewpoint.position_m.z, 0.0);
    sight.elevation_rad = std::asin(std::clamp(view.z, -1.0, 1.0));
    sight.azimuth_rad = std::atan2(view.x, view.y);
    return steadied(sight);
}

} // namespace

FrameRequest::FrameRequest(const Scene& ofScene, const SensorView& ofView, const Outputs& outputs)
    : scene(ofScene),
      view(ofView),
      camera(ofView.sensor, ofView.viewpoint),
      centre(centreOf(ofView.viewpoint)),
      bands(outputs.bands().empty() ? std::vector<Band>{ofView.sensor.band} : outputs.bands()),
      withSources(outputs.hasSource() && !outputs.hasImage()),
      withErrors(outputs.errors().value_or(ofScene.settings.errors) &&
                 (outputs.hasReports() || !outputs.wavenumbers_per_cm().empty())),
      withImage(outputs.hasImage()),
      withObjects(outputs.hasObjects()),
      bySurface(outputs.isBySurface()),
      alongRange(outputs.isAlongRange() && !outputs.hasImage()),
      sampledFrom_m(outputs.sampledFrom_m()),
      pathDepth(outputs.pathDepth()),
      isScaled(!outputs.scalings().empty()) {
    if (!(pathDepth > 0.0 && std::isfinite(pathDepth)))
        throw LogicError("a view through air of no optical depth was asked for");
}

} // namespace irsg
