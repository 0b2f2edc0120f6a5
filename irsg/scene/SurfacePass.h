#pragma once

#include <functional>
#include <memory>
#include <vector>

#include <osg/Geometry>
#include <osg/Matrixd>

#include "irsg/scene/CameraFrame.h"

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
    int row = 0; ///< index into the rows
    bool transparent = false;
    bool cullsBackFaces = false;
    PixelWindow window; ///< pixels it can touch
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
    std::vector<SurfaceRow> rows;
    int maximumLayers = 16;
};

/// Draws surfaces into float targets, transparent ones in exact order per sample by depth peeling.
/// Lives on the context's thread.
class SurfacePass {
  public:
    SurfacePass();
    ~SurfacePass();

    /// Samples of (A_pre, alpha) interleaved as RGBA in `samples`, window.width n x window.height
    /// n, bottom row first. Returns the number of samples with layers left over.
    int drawRadiance(osg::RenderInfo& info, const SurfaceScene& scene, const PixelWindow& window,
                     int samplesPerAxis, std::vector<float>& samples);

    /// The factors of each layer from front to back: transparent layers in order, the opaque
    /// surfaces last. `layer(plane0, plane1)` gets RGBA planes as surface.frag.glsl writes them, of
    /// the same size and order as above. Returns the number of samples with layers left over.
    using LayerSink =
        std::function<void(const std::vector<float>& plane0, const std::vector<float>& plane1)>;
    int drawFactors(osg::RenderInfo& info, const SurfaceScene& scene, const PixelWindow& window,
                    int samplesPerAxis, const LayerSink& layer);

    /// Seconds spent drawing and reading back since the last call.
    double takeDrawSeconds();
    double takeReadSeconds();

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

} // namespace irsg
