#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "irsg/geometry/mesh/Mesh.h"
#include "irsg/geometry/view/CameraFrame.h"
#include "irsg/render/sampling/SampleGeometry.h"
#include "irsg/render/sampling/SampleSheet.h"
#include "irsg/render/sampling/Samples.h"

namespace irsg {

class RayMesh;

/// What the shader is told of one kind of surface. Radiances are in-band, W m-2 sr-1.
struct SurfaceRow {
    std::array<float, mostFactors> radiance{}; ///< for each factor at 1
    float constant = 0.0f;                     ///< whatever the factors are
    float opacity = 1.0f;                      ///< 1 - t
    float nAngleFactor = 0.0f;
};

/// An entity, or the terrain, as it stands before the camera.
struct SurfaceBody {
    int entity = -1; ///< -1 for the terrain
    std::shared_ptr<const Mesh> mesh;
    std::shared_ptr<const RayMesh> rays; ///< the same as rays meet it; null for OpenGL
    Matrix4 eyeFromModel;
};

/// One piece of the scene as it is sampled.
struct SurfaceItem {
    int entity = 0;
    std::size_t piece = 0; ///< of the entity's mesh
    int row = 0;           ///< index into the rows
    bool transparent = false;
    std::size_t body = 0; ///< of the frame, index into its bodies
};

/// How factors are made of a sample's geometry: on the graphics card and on the CPU.
struct GeometryFactors {
    std::size_t factorCount = 0; ///< at most `mostFactors`
    std::string glsl;            ///< directions and FILL_FACTORS, see surface.frag.glsl
    std::vector<GeometryFactorFunction> functions;           ///< the same
    std::vector<std::pair<std::string, Vec3>> directionsEye; ///< unit, eye space
    /// Of each factor, the number of the direction from which its light can be taken away; -1:
    /// none.
    std::vector<int> shadowedFrom;
};

/// A frame to be drawn: its items, their rows, and where on the sensor's pixel grid.
struct SurfaceScene {
    const CameraFrame* camera = nullptr;
    DepthRange depth;
    GeometryFactors factors;
    std::vector<SurfaceItem> items;
    std::vector<SurfaceBody> bodies; ///< that the items belong to
    /// Hides surfaces and is not sampled itself, because its picture belongs to the background; at
    /// any depth, the range need not hold it. Without a mesh there is none.
    SurfaceBody terrain;
    /// What the earth's curve hides of the entities of the scene behind it; as the terrain.
    std::vector<SurfaceBody> groundBefore;
    std::vector<SurfaceRow> rows;
    std::vector<int> gasesAboutEye; ///< rows of gases that the eye is in

    const SurfaceBody& bodyOf(const SurfaceItem& item) const { return bodies[item.body]; }
    const Mesh::Piece& pieceOf(const SurfaceItem& item) const {
        return bodyOf(item).mesh->pieces[item.piece];
    }
    const Mesh::Part& partOf(const SurfaceItem& item) const {
        return bodyOf(item).mesh->partOf(pieceOf(item));
    }

    bool hasTransparent() const { return std::ranges::any_of(items, &SurfaceItem::transparent); }
};

/// The tiles of a sheet, and what stands in each.
struct SheetScene {
    SampleSheet sheet;
    std::vector<SurfaceScene> scenes;

    /// Of all tiles, which one eye sees.
    std::vector<int> gasesAboutEye() const {
        std::vector<int> all;
        for (const SurfaceScene& scene : scenes)
            for (const int row : scene.gasesAboutEye)
                if (std::ranges::find(all, row) == all.end())
                    all.push_back(row);
        return all;
    }
};

} // namespace irsg
