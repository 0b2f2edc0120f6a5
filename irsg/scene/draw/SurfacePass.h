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

#include "irsg/scene/sampling/SampleSheet.h"
#include "irsg/scene/sampling/Samples.h"
#include "irsg/scene/view/CameraFrame.h"

namespace osg {
class RenderInfo;
}

namespace irsg {

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

/// How the shader makes factors of a sample's geometry.
struct FactorShader {
    std::size_t factorCount = 0; ///< at most `mostFactors`
    std::string glsl;            ///< directions and FILL_FACTORS, see surface.frag.glsl
    std::vector<std::pair<std::string, Vec3>> directionsEye; ///< unit, eye space
};

/// A frame to be drawn: its items, their rows, and where on the sensor's pixel grid.
struct SurfaceScene {
    const CameraFrame* camera = nullptr;
    DepthRange depth;
    FactorShader factors;
    std::vector<SurfaceItem> items;
    std::vector<OccluderItem> occluders; ///< at any depth: the range need not hold them
    std::vector<SurfaceRow> rows;

    bool hasTransparent() const { return std::ranges::any_of(items, &SurfaceItem::transparent); }
};

/// The windows of a sheet, and what stands in each.
struct SheetScene {
    SampleSheet sheet;
    std::vector<SurfaceScene> scenes;
};

/// Draws surfaces into float targets. Opaque ones by depth; transparent ones into a list of
/// fragments that sortLayers sorts per sample, so that their order is exact also where they
/// cross. Lives on the context's thread.
class SurfacePass {
  public:
    SurfacePass();
    ~SurfacePass();

    /// Radiances of rows; LogicError where an item is transparent.
    void drawRadiance(osg::RenderInfo& info, const SheetScene& sheet, RadianceSamples& samples);
    /// Factors of all layers, the transparent ones not sorted yet.
    void drawFactors(osg::RenderInfo& info, const SheetScene& sheet, bool withDistance,
                     FactorSamples& samples);

    /// Memory of the targets and the list, which every drawing shares.
    std::size_t bytes() const;

    /// Seconds spent drawing and reading back since the last call.
    double takeDrawSeconds();
    double takeReadSeconds();

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace irsg
