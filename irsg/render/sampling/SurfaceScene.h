#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <osg/Geometry>
#include <osg/Matrixd>

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

/// One piece of the scene as it is drawn.
struct SurfaceItem {
    osg::Geometry* geometry = nullptr;
    osg::Matrixd eyeFromLocal;
    int entity = 0;
    int piece = 0; ///< its number in the entity's model
    int row = 0;   ///< index into the rows
    bool transparent = false;
    bool cullsBackFaces = false;
    int layer = 0; ///< of a subface, which lies in the plane of the layer below
};

/// What hides surfaces and is not drawn itself: terrain, whose picture belongs to the background.
struct OccluderItem {
    osg::Geometry* geometry = nullptr;
    osg::Matrixd eyeFromLocal;
};

/// An entity as rays meet it.
struct SurfaceBody {
    int entity = 0;
    std::shared_ptr<const RayMesh> mesh; ///< its pieces are those of the items; null for OpenGL
    osg::Matrixd eyeFromModel;
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
    std::vector<SurfaceBody> bodies;     ///< that the items belong to
    std::vector<OccluderItem> occluders; ///< at any depth: the range need not hold them
    SurfaceBody terrain;                 ///< the occluders as rays meet them
    std::vector<SurfaceRow> rows;

    bool hasTransparent() const { return std::ranges::any_of(items, &SurfaceItem::transparent); }
};

/// The tiles of a sheet, and what stands in each.
struct SheetScene {
    SampleSheet sheet;
    std::vector<SurfaceScene> scenes;
};

} // namespace irsg
