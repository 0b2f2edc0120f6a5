#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "irsg/atmosphere/path/AtmosphericQuery.h"
#include "irsg/geometry/view/CameraFrame.h"
#include "irsg/radiometry/Band.h"
#include "irsg/scene/Outputs.h"
#include "irsg/scene/Scene.h"

namespace irsg {

/// One view of a scene and what is asked of it: the input of every stage. Scene and view must live
/// as long.
struct FrameRequest {
    /// LogicError for a depth of the path that is not above 0.
    FrameRequest(const Scene& ofScene, const SensorView& ofView, const Outputs& outputs);

    const Scene& scene;
    const SensorView& view;
    CameraFrame camera;
    /// Through the middle of the field, unbounded; apparent: along the direction in which the
    /// object that is looked at appears.
    LineOfSight centre;
    // Of the scene, once it is known: see EarthHorizon.h.
    std::vector<Vec3> referencePoints_m; ///< by entity
    int lookedAt = -1;                   ///< the entity nearest to the middle of the field
    /// Apparent elevations less those of the flat scene, over the field.
    double raised_rad = 0.0;
    std::vector<Band> bands;
    bool withSources; ///< outputs are the bands, then their sources
    bool withErrors;
    bool withImage;
    bool withObjects;                    ///< false: of an image of the background alone
    bool bySurface;                      ///< sums of objects have those of their surfaces
    bool alongRange;                     ///< objects may be interpolated between distances
    std::optional<double> sampledFrom_m; ///< such objects are sampled from there alone
    double pathDepth;                    ///< see Outputs::throughDepth
    bool isScaled; ///< emissivities may be scaled, those of surfaces that reflect nothing, too

    const Entity& entity(int e) const { return scene.entities[static_cast<std::size_t>(e)]; }
};

} // namespace irsg
