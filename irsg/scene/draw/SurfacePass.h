#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include <osg/Geometry>
#include <osg/Matrixd>

#include "irsg/scene/sampling/SampleWindow.h"
#include "irsg/scene/sampling/Samples.h"
#include "irsg/scene/view/CameraFrame.h"

namespace osg {
class RenderInfo;
}

namespace irsg {

/// What the shader is told of one kind of surface.
struct SurfaceRow {
    float thermal = 0.0f, up = 0.0f, down = 0.0f, sun = 0.0f; ///< W m-2 sr-1 at factor 1
    float path = 0.0f;                                        ///< W m-2 sr-1, already times (1 - t)
    float opacity = 1.0f;                                     ///< 1 - t
    float nAngleFactor = 0.0f;
};

/// One piece of the scene as it is drawn.
struct SurfaceItem {
    osg::Geometry* geometry = nullptr;
    osg::Matrixd eyeFromLocal;
    int entity = 0;
    int row = 0; ///< index into the rows
    bool transparent = false;
    bool cullsBackFaces = false;
    int layer = 0; ///< of a subface, which lies in the plane of the layer below
};

/// What hides surfaces and is not drawn itself: terrain, whose picture belongs to the background.
struct OccluderItem {
    osg::Geometry* geometry = nullptr;
    osg::Matrixd eyeFromLocal;
};

/// How the shader weighs sun and fluxes; the numbers of surface.frag.glsl.
struct SurfaceModes {
    int sun = 2;
    int flux = 2;
    Vec3 zenithEye{0, 1, 0};
    Vec3 sunEye{0, 1, 0};
};

/// A frame to be drawn: its items, their rows, and where on the sensor's pixel grid.
struct SurfaceScene {
    const CameraFrame* camera = nullptr;
    DepthRange depth;
    SurfaceModes modes;
    std::vector<SurfaceItem> items;
    std::vector<OccluderItem> occluders; ///< at any depth: the range need not hold them
    std::vector<SurfaceRow> rows;
    int maximumLayers = 64;
};

/// Draws surfaces into float targets. Opaque ones by depth; transparent ones into a list of
/// fragments that is sorted per sample, so that their order is exact also where they cross. Lives
/// on the context's thread.
class SurfacePass {
  public:
    SurfacePass();
    ~SurfacePass();

    void drawRadiance(osg::RenderInfo& info, const SurfaceScene& scene, const SampleWindow& window,
                      RadianceSamples& samples);
    void drawFactors(osg::RenderInfo& info, const SurfaceScene& scene, const SampleWindow& window,
                     bool withDistance, FactorSamples& samples);

    /// Memory of the targets and the list, which every drawing shares.
    std::size_t bytes() const;

    /// Seconds spent drawing, reading back and sorting since the last call.
    double takeDrawSeconds();
    double takeReadSeconds();
    double takeSortSeconds();

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

} // namespace irsg
