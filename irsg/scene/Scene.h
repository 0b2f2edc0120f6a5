#pragma once

#include <memory>
#include <vector>

#include "irsg/atmosphere/Environment.h"
#include "irsg/geometry/Entity.h"
#include "irsg/geometry/view/Pose.h"
#include "irsg/geometry/view/Sensor.h"
#include "irsg/radiance/ScaledView.h"
#include "irsg/render/values/RenderReport.h"
#include "irsg/render/values/RenderSettings.h"

namespace irsg {

class Skybox;
class Terrain;

/// What there is to see, and how it is to be computed: a value.
struct Scene {
    Environment environment = Environment::vacuum();
    std::vector<Entity> entities;
    RenderSettings settings;
    /// Pictures around the eye and ground under it, added to the background; null for none.
    std::shared_ptr<const Skybox> skybox;
    std::shared_ptr<const Terrain> terrain;
};

/// Who looks, and from where.
struct SensorView {
    Sensor sensor;
    Viewpoint viewpoint;
};

/// What comes out of a view: what was asked for, and nothing else.
struct Rendered {
    RadianceImage image; ///< "L"; with truth layers the other planes (TruthLayers.h)
    /// By band, then of the sources; of an image alone one, which says how it was drawn (windows,
    /// warnings, layers left over) and has no sums.
    std::vector<RenderReport> reports;
    IntensitySpectrum spectrum;
    std::vector<std::unique_ptr<const ScaledView>> scaled; ///< by band, or one of the spectrum
};

} // namespace irsg
