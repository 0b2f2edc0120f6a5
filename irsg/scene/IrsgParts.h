#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "irsg/scene/Irsg.h"
#include "irsg/scene/SceneCheck.h"
#include "irsg/scene/background/SceneBackground.h"
#include "irsg/scene/draw/OffscreenContext.h"
#include "irsg/scene/draw/Stopwatch.h"
#include "irsg/scene/draw/SurfacePass.h"
#include "irsg/scene/model/DrawList.h"
#include "irsg/scene/model/LongEdges.h"
#include "irsg/scene/radiance/PixelFactors.h"
#include "irsg/scene/radiance/PointSources.h"
#include "irsg/scene/radiance/SceneRadiometry.h"
#include "irsg/scene/radiance/WidebandTerms.h"
#include "irsg/scene/sampling/FrameReduction.h"
#include "irsg/scene/sampling/HotParts.h"
#include "irsg/scene/sampling/ZoomAntialiasingManager.h"
#include "irsg/scene/view/CameraFrame.h"
#include "irsg/scene/view/FrameBackground.h"

namespace irsg {

/// What a generator holds, and the steps its public calls are made of.
struct Irsg::Parts {
    OffscreenContext& context = OffscreenContext::shared();
    std::unique_ptr<SurfacePass> pass; // made and destroyed on the context's thread

    Environment environment = Environment::vacuum();
    Sensor sensor;
    RenderSettings settings;
    std::vector<Entity> entities;
    Viewpoint viewpoint;

    std::vector<std::vector<DrawItem>> drawItems;  // by entity
    std::vector<BoundingBall> balls;               // by entity
    std::vector<Vec3> referencePoints;             // in model axes, by entity
    std::vector<HotParts> hotParts;                // by entity
    std::vector<std::vector<ModelEdge>> longEdges; // by entity
    ZoomAntialiasingManager antialiasing;
    PointSources pointSources;
    SceneBackground background;
    std::vector<StageTimes::Stage> stages;

    // The factors of the last view, kept while nothing they depend on changes.
    std::vector<double> factorFingerprint;
    std::vector<std::shared_ptr<const Model>> factorModels;
    FrameBackground factorBackground;
    ProjectedFactors factors;

    /// The last view of a picture, and once it was asked for twice what its pixels are made of.
    struct PixelView {
        std::vector<double> fingerprint;
        std::vector<std::shared_ptr<const Model>> models;
        std::optional<PixelFactors> factors;
    } pixelView;

    // Wideband terms, latest first, kept while environment, band and surface spectra stay.
    std::vector<std::unique_ptr<const WidebandTerms>> widebandTerms;

    // Sum of omega cos(theta) over the frame, kept for one raster.
    std::array<double, 3> frameRaster{};
    double frameProjectedSolidAngle_sr = 0.0;

    /// Everything one drawing needs, made anew for each.
    struct Frame {
        CameraFrame camera;
        std::vector<ObjectGeometry> geometry;
        SceneRadiometry radiometry;
        FrameBackground background;
        BackgroundReport backgroundReport;
        SurfaceScene scene;                 // of all objects, in their model axes until sceneOf
        std::vector<bool> hot;              // by surface: worth samples of its own
        std::vector<ZoomEntityInfo> seen;   // all that the frame can see
        std::vector<ZoomEntityInfo> drawn;  // into windows
        std::vector<ZoomEntityInfo> points; // as point sources
    };

    template <typename Work>
    auto timed(const char* stage, Work work) {
        double seconds = 0.0;
        if constexpr (std::is_void_v<decltype(work())>) {
            {
                Stopwatch watch(seconds);
                work();
            }
            addTime(stage, seconds);
        } else {
            auto result = [&] {
                Stopwatch watch(seconds);
                return work();
            }();
            addTime(stage, seconds);
            return result;
        }
    }

    void addTime(const std::string& name, double seconds);

    /// Centre of the box around what does not let light through, or around all of it.
    Vec3 modelReferencePoint(const Entity& entity) const;

    void prepareEntity(std::size_t e);

    std::vector<ObjectGeometry> geometry() const;

    /// The unbounded line of sight through the middle of the field.
    LineOfSight centre() const;

    SurfaceModes modes(const CameraFrame& camera) const;

    /// In the mode of the settings, or in a given one.
    Frame frame() { return frame(settings.mode); }
    Frame frame(CalculationMode mode);

    /// On wideband terms, or in the spectral mode where there are none.
    SceneRadiometry radiometry(const std::vector<ObjectGeometry>& objects,
                               const WidebandTerms* wideband) const;

    /// The wideband terms of the present scene, trained where it is a new one.
    const WidebandTerms& terms();

    /// What is behind the objects, and the terrain that hides them.
    void drawBackground(Frame& frame);

    /// True where terrain that may hide objects is in or beside the pixels of a rectangle.
    bool touchesTerrain(const ImageRectangle& extent) const;

    static void fillRows(Frame& frame);

    void fillItems(Frame& frame);

    /// Gives the objects that are drawn into windows their details.
    void findDetails(Frame& frame);
    /// Where a camera sees the hot parts of an entity that are not hidden by the entity itself.
    std::vector<ImageRectangle> detailsOf(const Frame& frame, const CameraFrame& camera,
                                          std::size_t entity);
    /// Where a camera sees the long edges of an entity; those that reach behind it are left out.
    std::vector<ImageEdge> edgesOf(const CameraFrame& camera, std::size_t entity) const;

    /// Largest side of one drawing, samples.
    int largestDrawing() const;

    /// What of the scene stands in a window as a camera sees it, between the depths it spans.
    SurfaceScene sceneOf(const Frame& frame, const CameraFrame& camera,
                         const SampleWindow& window) const;

    /// Divides what is seen into windows and points.
    void planPoints(Frame& frame) const;
    /// Factors of a point source at unit distance, kept for its aspect.
    const ProjectedFactors& pointFactors(const Frame& frame, const ZoomEntityInfo& object);
    void addPoint(const Frame& frame, const ZoomEntityInfo& object, FrameReduction& reduction);
    /// The pixel of a point source and what it is to it.
    struct PointPixel {
        int x, y;
        double distance_m, solidAngle_sr, cosOffAxis;
    };
    PointPixel pixelOf(const Frame& frame, const ZoomEntityInfo& object) const;

    /// The pixels of the objects: drawn, or a sum where the view is that of the last picture.
    FrameReduction pixelsOf(const Frame& frame, RenderReport& report);

    /// Draws the objects with the strategy that the settings ask for.
    FrameReduction drawObjects(const Frame& frame, RenderReport& report);
    std::vector<SampledWindow> sampledWindows(const std::vector<DrawnWindow>& drawn,
                                              const std::vector<ZoomEntityInfo>& points) const;

    void onContext(const std::function<void(osg::RenderInfo&)>& work);

    /// Draws the factors of the objects' windows and times what `sink` makes of them.
    template <typename Sink>
    void drawFactorWindows(const Frame& frame, const std::vector<ZoomEntityInfo>& objects,
                           bool withDistance, const char* stage, Sink sink) {
        if (objects.empty())
            return;
        const std::vector<SampleWindow> windows =
            piecesOf(antialiasing.strategyFor(settings).windows(objects), largestDrawing());
        double sinking_s = 0.0;
        onContext([&](osg::RenderInfo& info) {
            FactorSamples samples;
            for (const SampleWindow& window : windows) {
                pass->drawFactors(info, sceneOf(frame, frame.camera, window), window, withDistance,
                                  samples);
                Stopwatch watch(sinking_s);
                sink(window, samples);
            }
        });
        addTime(stage, sinking_s);
    }

    /// What the projected factors depend on, as numbers.
    std::vector<double> fingerprint(const Frame& frame) const;

    const ProjectedFactors& factorsOf(const Frame& frame);

    /// Of the whole frame on the detector: the objects' contrast upon the background.
    double totalIrradiance_W_m2(const Frame& frame, const RenderReport& report);

    void addTruthLayers(const Frame& frame, RadianceImage& image);

    void fillReport(const Frame& frame, RenderReport& report) const;

    void describe(const Frame& frame, RadianceImage& image) const;
};

} // namespace irsg
