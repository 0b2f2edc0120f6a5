#pragma once

#include <array>
#include <exception>
#include <functional>
#include <future>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "irsg/core/RecentlyUsed.h"
#include "irsg/core/Stopwatch.h"
#include "irsg/radiance/AtmosphericQueryCache.h"
#include "irsg/radiance/LobeSamples.h"
#include "irsg/radiance/OtherAir.h"
#include "irsg/radiance/PointSources.h"
#include "irsg/radiance/RadiometryCache.h"
#include "irsg/radiance/RangeFactors.h"
#include "irsg/radiance/Reductions.h"
#include "irsg/radiance/SampledScene.h"
#include "irsg/radiance/SceneSampling.h"
#include "irsg/radiance/ViewFactors.h"
#include "irsg/radiance/WidebandPoints.h"
#include "irsg/render/background/SceneBackground.h"
#include "irsg/render/background/TerrainRays.h"
#include "irsg/render/opengl/WindowStream.h"
#include "irsg/render/rays/SunShadows.h"
#include "irsg/render/sampling/FrameReduction.h"
#include "irsg/render/sampling/SampleEngine.h"
#include "irsg/render/sampling/ZoomAntialiasingManager.h"
#include "irsg/scene/EngineCost.h"
#include "irsg/scene/PreparedEntities.h"
#include "irsg/scene/Renderer.h"
#include "irsg/scene/SceneCheck.h"
#include "irsg/scene/scattering/SceneScattering.h"

namespace irsg {

inline void append(std::vector<double>& numbers, const Vec3& v) {
    numbers.insert(numbers.end(), {v.x, v.y, v.z});
}

/// What a renderer keeps, and the steps that its call is made of.
struct Renderer::Impl {
    explicit Impl(const RadianceTerms& list) : terms(list) {}

    const RadianceTerms& terms;
    std::vector<StageTimes::Stage> stages;
    /// Each is made when it is first needed.
    std::unique_ptr<SampleEngine> opengl, rays;
    std::unique_ptr<TerrainPainter> glTerrain;
    TerrainRays rayTerrain;
    WindowStream stream;
    FactorSamples pictureFactors; ///< room for those of the next picture

    PreparedEntities prepared;
    ZoomAntialiasingManager antialiasing;
    SceneBackground background;
    AtmosphericQueryCache air;
    SceneSampling sampling;
    SampledScenes sampledScenes;
    /// So many that bands and samples can take turns.
    RecentlyUsed<std::shared_ptr<const WidebandPoints>> widebandPoints{128};
    RadiometryCache radiometry;
    Fronts fronts;
    PointSources pointSources;
    RangeFactors rangeFactors;
    RecentlyUsed<std::shared_ptr<const SunlitFacets>> sunlitFacets{8};
    std::shared_ptr<const Terrain> shadowingTerrain; ///< of what is kept of aspects
    /// Light between the surfaces of scenes, by all that it depends on.
    struct KnownExchange {
        std::vector<double> numbers;
        std::vector<std::shared_ptr<const BodyLight>> bodies;
        std::shared_ptr<const Terrain> terrain;
        std::vector<SurfaceKey> keys;
        std::shared_ptr<const LightExchange> exchange;
    };
    RecentlyUsed<KnownExchange> exchanges{4};
    std::string lastChosen; ///< of automatic choices
    std::shared_ptr<LobeTables> lobeTables = std::make_shared<LobeTables>();
    LightSolutions lightSolutions;
    SceneScattering scattering;
    OtherAir otherAir;

    /// All that the factors of a view depend on.
    struct ViewKey {
        std::vector<double> numbers;
        std::vector<std::shared_ptr<const Model>> models;
        std::shared_ptr<const Terrain> terrain;
        SurfaceRows rows;
        std::string shader;
        bool operator==(const ViewKey&) const = default;
    };
    struct FactorDrawing;
    /// The factors of the view that was begun last.
    std::shared_ptr<FactorDrawing> view;
    /// The details of the last view, by entity.
    struct {
        std::optional<ViewKey> key;
        std::map<int, std::vector<ImageRectangle>> byEntity;
    } details;
    /// The last view of a followed image, and once it was asked for twice what its pixels are made
    /// of.
    struct {
        std::optional<ViewKey> key;
        std::optional<PixelFactors> factors;
    } pixels;

    /// Sum of omega cos(theta) over the frame, of the last raster.
    struct {
        std::array<double, 3> raster{};
        double projected_sr = 0.0;
    } solidAngle;

    /// Everything one call needs.
    struct Frame {
        Frame(const Scene& ofScene, const SensorView& ofView, std::vector<Band> inBands)
            : scene(ofScene),
              view(ofView),
              camera(ofView.sensor, ofView.viewpoint),
              bands(std::move(inBands)) {}

        const Scene& scene;
        const SensorView& view;
        CameraFrame camera;
        SampleEngine* engine = nullptr;
        std::string renderer; ///< who that is
        std::vector<Band> bands;
        bool withSources = false; ///< outputs are the bands, then their sources
        bool withErrors = false;
        std::vector<ObjectGeometry> geometry;
        LineOfSight centre; ///< through the middle of the field, unbounded
        std::vector<std::string> answeredBy, warnings;
        std::shared_ptr<const SampledScene> sampled;
        std::shared_ptr<EvaluatedScene> evaluated;
        SharedValues background;                  ///< uniform, as evaluated radiances have it
        std::vector<FrameBackground> backgrounds; // by output
        BackgroundReport backgroundReport;
        std::vector<SurfaceItem> items; // of all objects, in their model axes until sceneOf
        std::vector<std::shared_ptr<const RayMesh>> meshes; // by entity, for rays
        std::shared_ptr<const RayMesh> terrainMesh;         // likewise
        std::shared_ptr<const SunShadows> shadows;          // null for none
        std::shared_ptr<const LightExchange> exchange;      // between surfaces, likewise
        std::shared_ptr<const LobeSamples> lobes;           // of directional ones, likewise
        std::shared_ptr<SceneLight> light;                  // of the bands, likewise
        std::vector<SurfaceRow> rows;                       // by drawn row, of the first band
        std::vector<bool> hot;              // by drawn row: worth samples of its own
        std::vector<ZoomEntityInfo> seen;   // all that the frame can see
        std::vector<ZoomEntityInfo> drawn;  // into windows
        std::vector<ZoomEntityInfo> points; // as point sources
        /// Not drawn, nor among those above: their factors are interpolated between distances.
        std::vector<ZoomEntityInfo> alongRange;

        const Entity& entity(int e) const { return scene.entities[static_cast<std::size_t>(e)]; }
        /// By entity, sensor to reference point.
        std::vector<double> ranges_m() const {
            std::vector<double> ranges_m;
            for (const ObjectGeometry& object : geometry)
                ranges_m.push_back(object.path.range_m);
            return ranges_m;
        }
        const SurfaceRows& surfaceRows() const { return evaluated->radiometry.rows(); }
        bool isTransparent() const;
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

    // RendererFrame.cpp: the radiometry of a call and what is to be drawn.
    /// How far an entity reaches from its reference point at most, m.
    double reachOf_m(const Entity& entity);
    std::vector<ObjectGeometry> geometry(const Scene& scene, const SensorView& view);
    Frame frame(const Scene& scene, const SensorView& view, const Outputs& outputs);
    std::shared_ptr<const SampledScene> sample(const Frame& frame);
    void evaluate(Frame& frame);
    std::shared_ptr<const WidebandPoints> wideband(const Scene& scene, const Band& band);
    /// Samples bands with answers of the frame's air, or of other air; both must live as long.
    SampledScenes::Sampler sampler(const Frame& frame, AtmosphericQueryCache& answers);
    /// Of one band alone, also where it is sampled with others.
    std::shared_ptr<const SpectralSampling> samplingOf(const Frame& frame, std::size_t band);
    void drawBackgrounds(Frame& frame);
    void fillRows(Frame& frame);
    /// By drawn row, in the scene's states and the others of its sweep.
    std::vector<bool> hotRows(const Frame& frame);
    void fillItems(Frame& frame);
    void planPoints(Frame& frame) const;
    /// True where all of an object is inside the frame, and no other object in its part of it.
    static bool isWholeAndApart(const Frame& frame, const ZoomEntityInfo& object);
    /// True where terrain that may hide objects is in or beside the pixels of a rectangle.
    bool touchesTerrain(const Frame& frame, const ImageRectangle& extent) const;
    /// Gives the objects that are drawn into windows their details.
    void findDetails(Frame& frame);
    /// Where a camera sees the hot parts of an entity that are not hidden by the entity itself.
    std::vector<ImageRectangle> detailsOf(const Frame& frame, const CameraFrame& camera,
                                          int entity);
    /// Where it sees the long edges of an entity; those that reach behind it are left out.
    std::vector<ImageEdge> edgesOf(const Frame& frame, const CameraFrame& camera, int entity);

    // RendererEngines.cpp: who answers samples.
    struct ChosenEngine {
        EngineChoice engine = EngineChoice::opengl;
        std::string why; ///< of an automatic choice
    };
    SampleEngine& engineOf(EngineChoice engine);
    /// `frame`: the one that is to be drawn, or null where only the scene is known.
    ChosenEngine chosenEngine(const Scene& scene, const Frame* frame);
    EngineWork workOf(const Scene& scene, const Frame* frame);
    std::string descriptionOf(const ChosenEngine& chosen);
    bool usesRays(const Frame& frame) const { return frame.engine == rays.get(); }
    TerrainPainter& terrainPainter(const Frame& frame);
    /// Gives a frame its engine, and what that needs.
    void takeEngine(Frame& frame);
    /// Gives it what stands before the sun, where shadows are asked for.
    void takeShadows(Frame& frame, const Outputs& outputs);
    /// What of the shadows is known without rays, for the directions of factors.
    std::vector<SunShadows::Sunlit> sunlitOf(const Frame& frame, const std::vector<int>& shadowed,
                                             const SunShadows& shadows);
    /// What stands in the way of light, entity by entity, and the terrain.
    std::vector<SunShadows::Caster> casters(const Frame& frame);
    /// Gives it what directional surfaces need.
    void takeLobes(Frame& frame);
    /// The same, and the air's directions that its objects reflect.
    void takeMirrorGrids(const Scene& scene, const Band& band,
                         std::vector<ObjectGeometry>& geometry);
    /// What of a drawing is left to do to sorted layers: light of the sun that is taken away,
    /// lobes.
    void shade(const Frame& frame, const SheetScene& sheet, FactorSamples& samples) const;
    static bool isShaded(const Frame& frame) { return frame.shadows || frame.lobes; }
    /// Appends what the factors of lobes depend on.
    static void appendLobes(const Frame& frame, std::vector<double>& numbers);
    /// Sorts the layers of a drawing, and does that.
    void sortAndShade(const Frame& frame, const SheetScene& sheet, FactorSamples& samples);

    // RendererLight.cpp: light between surfaces.
    bool hasLightBetween(const Frame& frame) const;
    /// Gives a frame what its surfaces see of each other, where that is asked for.
    void takeExchange(Frame& frame, const std::vector<SunShadows::Caster>& casters);
    std::shared_ptr<const LightExchange> exchangeOf(const Frame& frame,
                                                    const std::vector<SunShadows::Caster>& casters);
    /// Says of which bodies the view factors are not known as well as was asked.
    static void warnOfLight(const LightExchange& exchange, const Scene& scene,
                            std::vector<std::string>& warnings);
    /// Which triangles the samples of a drawing lie in.
    static SunShadows::LightPlaces placesOf(const Frame& frame);
    /// What the receivers that sums are made of are numbered by.
    static void appendReceivers(const Frame& frame, std::vector<double>& numbers);
    /// What of that a radiometry makes.
    std::shared_ptr<SceneLight> lightOf(const Frame& frame, const SceneRadiometry& radiometry);

    // RendererDrawing.cpp
    void onEngine(const Frame& frame, const std::function<void()>& work);
    FactorMaking factorMaking(const Frame& frame, const CameraFrame& camera) const;
    /// What of the scene stands in a window as a camera sees it, between the depths it spans.
    SurfaceScene sceneOf(const Frame& frame, const CameraFrame& camera, const SampleWindow& window);
    SheetScene scenesOf(const Frame& frame, const CameraFrame& camera, const SampleSheet& sheet);
    /// Draws the objects with the strategy that the settings ask for.
    FrameReduction drawObjects(const Frame& frame, std::vector<SampledWindow>& windows,
                               std::vector<std::string>& warnings, int& layersLeftOver);
    /// The pixels of a followed image: drawn, or a sum where the view is that of the last one.
    FrameReduction followedPixels(const Frame& frame, std::vector<SampledWindow>& windows,
                                  std::vector<std::string>& warnings, int& layersLeftOver);
    std::vector<SampledWindow> sampledWindows(const Frame& frame,
                                              const std::vector<DrawnWindow>& drawn) const;
    using TakeWindow = std::function<void(const SampleWindow&, const FactorSamples&)>;
    /// Begins to draw the factors of windows and to give their samples to `take`, on other threads;
    /// the frame must live until it is done.
    std::future<WindowStream::Seconds> beginWindows(const Frame& frame,
                                                    const std::vector<SampleWindow>& windows,
                                                    bool withDistance, TakeWindow take);
    /// Waits for it. Of the time that others took, what was waited for counts, by stages in
    /// proportion; that of `take` is called `stage`.
    void waitFor(std::future<WindowStream::Seconds>& windows, const char* stage);
    void drawFactorWindows(const Frame& frame, const std::vector<ZoomEntityInfo>& objects,
                           bool withDistance, const char* stage, TakeWindow take);

    // RendererFactors.cpp
    /// What the objects of a frame are sampled by where only their sums are asked for.
    std::vector<SampleWindow> windowsOfSums(const Frame& frame);
    bool sumsSampleAsPictures(const Frame& frame);
    ViewKey viewKey(const Frame& frame) const;
    /// Begins to draw the factors of a view, unless they are known or under way.
    std::shared_ptr<FactorDrawing> beginFactors(const Frame& frame);
    const ViewFactors& factorsOf(const Frame& frame, FactorDrawing& drawing);
    const ViewFactors& factorsOf(const Frame& frame);
    void addTruthLayers(const Frame& frame, RadianceImage& image);

    // RendererAspects.cpp: what is drawn once for an aspect and serves at many distances.
    /// An entity as it is seen from a direction in its model's axes.
    PointAspect aspectOf(const Frame& frame, int entity, const Vec3& from) const;
    /// Factors of one entity as a camera of its own sees it, with nothing before it.
    ViewFactors drawAlone(const Frame& frame, int entity, const CameraFrame& camera, int zoomWindow,
                          const SurfaceRows& rows);
    /// Factors of a point source at unit distance, kept for its aspect.
    const PointFactors& pointFactors(const Frame& frame, const ZoomEntityInfo& object);
    PointPlace placeOf(const Frame& frame, const ZoomEntityInfo& object) const;
    /// Takes the objects whose factors are interpolated out of those that are drawn.
    void planAlongRange(Frame& frame);
    bool isAlongRange(const Frame& frame, const ZoomEntityInfo& object);
    /// From an entity's reference point.
    Vec3 towardsSensor(const Frame& frame, int entity);
    void addAlongRange(const Frame& frame, const ZoomEntityInfo& object, ViewFactors& view);
    ViewFactors drawAtNode(const Frame& frame, int entity, const Vec3& from, std::size_t node,
                           const SurfaceRows& rows);

    // RendererErrors.cpp: how wrong the sums of a view may be.
    /// Gives reports, by output, their errors. `varying`: see objectSums.
    void addErrors(const Frame& frame, const ViewFactors& factors, const std::vector<int>& varying,
                   std::vector<RenderReport>& reports);
    /// Of samples alone: by output of some radiances those of each entity, then those of all.
    std::vector<std::vector<RadiometryErrors>>
    samplingErrors(const Frame& frame, const ViewFactors& factors, KindRadiances& radiances,
                   SceneLight* light, const SurfaceRows& rows, const std::vector<int>& varying);
    void addSamplingErrors(const Frame& frame, const ViewFactors& factors,
                           const std::vector<int>& varying, std::vector<RenderReport>& reports);
    void addAirErrors(const Frame& frame, const ViewFactors& factors,
                      std::vector<RenderReport>& reports);
    /// Sums as they are in other air, or in the same one along other paths.
    std::vector<ObjectSums> sumsElsewhere(const Frame& frame, const ViewFactors& factors,
                                          const std::vector<ObjectGeometry>& geometry);
    /// Those that the other air has of itself; else those of the frame.
    std::shared_ptr<const SpectralSampling> otherAirNodes(const Frame& frame, const Band& band);
    void addBackgroundErrors(const Frame& frame, std::vector<RenderReport>& reports);
    /// What is seen along a line of sight, in as many numbers as there are bands or wavelengths.
    using SeenAlong = std::function<std::vector<double>(const LineOfSight&)>;
    /// Of the background behind an object, in the unit of what is seen. `grid`: what is used of the
    /// background in places, as a part of what is used in the middle; none: the same everywhere.
    std::vector<double> backgroundErrors(const Frame& frame, std::size_t entity,
                                         const SeenAlong& seenAlong,
                                         const std::function<double(double x, double y)>& grid);
    /// In a band, W m-2 sr-1.
    double backgroundError_W_m2_sr(const Frame& frame, std::size_t entity, std::size_t band);
    bool knowsBackgroundError(const Frame& frame) const;
    /// The nearer half of what an object reaches, where the air of its reference point stands for
    /// all of it; none where that is so of none.
    static std::optional<std::vector<ObjectGeometry>> seenPlaces(const Frame& frame);

    // RendererSpectrum.cpp.
    /// Gives a spectrum of ascending wavelengths, whose sums these are, its errors by wavelength:
    /// those of each entity, then those of all.
    std::vector<std::vector<RadiometryErrors>>
    spectrumErrors(const Frame& frame, const ViewFactors& factors, EvaluatedScene& evaluated,
                   const std::shared_ptr<const SpectralSampling>& nodes,
                   const std::vector<double>& wavelengths_um, const std::vector<ObjectSums>& sums);

    // RendererScattering.cpp
    /// Tells of objects that are partly or wholly outside the frame, and near enough for their
    /// haze.
    void warnOfHazeFromOutside(const Frame& frame, int support_px,
                               std::vector<std::string>& warnings);
    /// The objects of a scene with the optical depths of their paths, still without pixels.
    std::vector<ScatteredObject> objectsToScatter(const Frame& frame,
                                                  std::vector<std::string>& warnings);
    /// Adds the haze of all objects to a composed picture.
    void scatter(const Frame& frame, RadianceImage& image, std::vector<std::string>& warnings);

    // Renderer.cpp
    void fillReport(const Frame& frame, std::size_t band, RenderReport& report) const;
    std::vector<RenderReport> reports(const Frame& frame, const ViewFactors& factors);
    std::vector<RenderReport> reports(const Frame& frame) {
        return reports(frame, factorsOf(frame));
    }
    double totalIrradiance_W_m2(const Frame& frame, std::size_t band, double contrast_W_m2);
    double frameProjectedSolidAngle_sr(const Sensor& sensor);
    void describe(const Frame& frame, RadianceImage& image) const;
    void renderImage(const Frame& frame, const Outputs& outputs, Rendered& result);
    /// What the pixels of a picture of at most one object add up to.
    RenderReport reportOf(const Frame& frame, const FrameReduction& pixels);
    IntensitySpectrum spectrum(const Frame& frame, const Outputs& outputs, Rendered& result);
};

/// The factors of a view and how far they are.
struct Renderer::Impl::FactorDrawing {
    ViewKey key;
    std::vector<FrameBackground> varying; // backgrounds that vary over the view
    Fronts fronts;                        // of its own, as it is summed on another thread
    std::optional<FactorSums> sums;
    std::future<WindowStream::Seconds> windows; // until they were waited for
    ViewFactors factors;        // with the renderer's numbers of fronts from then on
    std::exception_ptr failure; // of the drawing, for all who share it

    /// Waits until nothing refers to the frame any more that it was begun for.
    void wait() const {
        if (windows.valid())
            windows.wait();
    }
    ~FactorDrawing() { wait(); }
};

/// Reports that were begun.
struct Renderer::Begun {
    Begun(Impl& of, Scene ofScene, SensorView ofView, Outputs ofOutputs)
        : scene(std::move(ofScene)),
          view(std::move(ofView)),
          outputs(std::move(ofOutputs)),
          frame(of.frame(scene, view, outputs)) {}
    Begun(const Begun&) = delete;
    Begun& operator=(const Begun&) = delete;
    ~Begun() {
        if (drawing)
            drawing->wait();
    }

    const Scene scene;
    const SensorView view;
    const Outputs outputs;
    const Impl::Frame frame; // of these
    std::shared_ptr<Impl::FactorDrawing> drawing;
};

} // namespace irsg
