#pragma once

#include <memory>
#include <string>
#include <vector>

#include "irsg/render/background/TerrainPainter.h"
#include "irsg/render/rays/RayMesh.h"
#include "irsg/render/sampling/SampleEngine.h"

namespace irsg {

/// Who samples the surfaces of a frame, and the scene as that needs it.
struct FrameEngine {
    SampleEngine& engine;
    TerrainPainter& terrainPainter;
    bool isRays = false;
    std::string description; ///< who that is, and why where it was chosen
    std::vector<std::shared_ptr<const RayMesh>> meshes; ///< by entity; none for OpenGL
    std::shared_ptr<const RayMesh> terrainMesh; ///< null for OpenGL and where terrain hides nothing
};

} // namespace irsg
