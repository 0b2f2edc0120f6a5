#pragma once

#include <vector>

#include "irsg/reference/Scenes.h"
#include "irsg/scene/InteractiveRenderer.h"

namespace irsg::reference {

/// What the reference renderer is told of a surface: in-band terms at geometric factor 1.
struct SurfaceTerms {
    double thermal = 0, up = 0, down = 0, sun = 0, path = 0;
    double transmissivity = 0;
    double nAngleFactor = 0;
};

struct RayScene {
    Triangles mesh;                     ///< in the world
    std::vector<SurfaceTerms> surfaces; ///< by temperature code
    Vec3 sunDirection{0, 0, 1};
    double background = 0.0;
};

struct RayPixel {
    double radiance = 0.0;
    double opacity = 0.0;
    int facet = -1;          ///< index of the nearest triangle, -1 for none
    bool isInterior = false; ///< the 3 x 3 neighbours hit the same facets in the same order
};

/// Renders pixel centres in double by casting a ray at every triangle: the reference that shader
/// images are held against. Written from the equations, sharing no code with the shader.
std::vector<RayPixel> castRays(const RayScene& scene, const Sensor& sensor,
                               const Viewpoint& viewpoint);

} // namespace irsg::reference
