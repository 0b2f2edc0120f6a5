#pragma once

#include "irsg/render/values/TextureScale.h"

namespace irsg {

/// How a band is integrated (F19, the report's CalculationMode).
enum class CalculationMode {
    spectral = 1, ///< at every wavelength of the spectra that meet
    wideband = 2  ///< at the quadrature points of the atmosphere's correlated-k, see SensorCkData
};
/// How the sun and the diffuse fluxes are reflected (report section 4, F12).
enum class ReflectionMode {
    off,
    approx, ///< independent of geometry: the mean over all orientations, sun 1/4, up 1/2, down 1/2
    smart   ///< per pixel, from the normal
};
/// How much of the upper and lower hemisphere a tilted facet sees.
enum class FluxWeights {
    viewFactor, ///< (1 + cos theta_z) / 2, exact
    report      ///< 1 - theta_z / pi, as published
};
/// What of the air a measured spectrum passes that holds the air of its reference distance already.
enum class ReferenceTransmittance {
    ratio,  ///< T(whole path) / T(reference distance, from the target on)
    segment ///< T(what is left of the path, from the sensor on), as published
};
enum class BackgroundMode {
    none,       ///< 0
    constant,   ///< `background_W_m2_sr`, in-band
    environment ///< the environment's, along one line of sight or a grid of them
};

/// How zoom antialiasing samples.
enum class TileStrategy {
    aligned,  ///< windows on the sensor's pixel grid, see PixelAlignedStrategy
    published ///< as published, see PublishedTileStrategy
};

/// Who answers samples: surfaces, factors, distances. The answers are the same.
enum class EngineChoice {
    opengl,   ///< drawn off-screen
    rays,     ///< with Embree, without OpenGL
    automatic ///< whichever is the quicker for the scene
};

/// Whether what stands between a surface and the sun takes its light away (`sun` smart).
enum class SunShadowMode {
    off,
    point, ///< the sun is a point
    disc   ///< a disc of 0.53 degrees, equally bright: shadows have a penumbra
};

/// All reflections between surfaces, in RenderSettings::bounces.
inline constexpr int convergedBounces = -1;

inline constexpr int largestBackgroundGrid = 1024;
inline constexpr double largestPointSource_px = 1.0;

/// How a scene is rendered. The defaults are those of the settings of smatcore, which take them
/// from here.
struct RenderSettings {
    /// Light that comes from one surface alone: without shadows of the sun and inter-reflection,
    /// before a background of one row. Its numbers come without errors.
    static RenderSettings direct() {
        RenderSettings settings;
        settings.sunShadows = SunShadowMode::off;
        settings.bounces = 0;
        settings.backgroundRows = 1;
        settings.errors = false;
        return settings;
    }

    EngineChoice engine = EngineChoice::opengl;
    CalculationMode mode = CalculationMode::spectral;
    /// Of in-band quantities on the cases that wideband-ck's quadrature points are trained on,
    /// relative: 5e-4 to 0.05. Less takes more points. See CkRequest.
    double widebandError = 0.003;
    /// Zoom antialiasing: side of the windows that objects are drawn into, samples; 128, 256 or 512
    /// for modes 3 to 5 of the report, any from 8 to 2048. 0: every pixel is sampled alike.
    int tileSide_samples = 256;
    TileStrategy tileStrategy = TileStrategy::aligned;
    bool usesAlignedTiles() const {
        return tileSide_samples > 0 && tileStrategy == TileStrategy::aligned;
    }
    bool usesPublishedTiles() const {
        return tileSide_samples > 0 && tileStrategy == TileStrategy::published;
    }
    /// Objects narrower than this are drawn once per aspect and then stand for any range as points,
    /// with the aligned zoom, before no terrain and apart from other objects; see PointSources.
    /// Pixels, 0 (never) to `largestPointSource_px`.
    double pointSourceBelow_px = 1.0 / 64.0;
    /// Small parts that shine out of their object, such as exhaust pipes, have windows of their
    /// own, with the aligned zoom; see HotSpots.
    bool hotSpots = true;
    /// Supersampling, where there is no zoom window: 1, 2 or 4 for modes 0 to 2; any 1 to 16.
    int samplesPerAxis = 4;
    /// `samplesPerAxis` is meant in all, not per axis: 4 is 2 x 2, and 2 is two side by side.
    bool countsPerPixel = false;
    ReflectionMode sun = ReflectionMode::smart;
    SunShadowMode sunShadows = SunShadowMode::point;
    ReflectionMode ambientReflection = ReflectionMode::smart;
    /// Light that goes from surface to surface before it goes to the sensor: 0 for none, so many
    /// times, or convergedBounces. Where there is any, surfaces also lose what others hide of sky
    /// and ground. Not with an ambient reflection of `approx`, which is independent of geometry.
    /// See SceneLight.
    int bounces = convergedBounces;
    /// Of the view factors between surfaces, as a part of the hemisphere: 1e-5 to 0.1.
    double lightError = 0.005;
    FluxWeights fluxWeights = FluxWeights::viewFactor;
    ReferenceTransmittance referenceTransmittance = ReferenceTransmittance::ratio;
    BackgroundMode background = BackgroundMode::environment;
    double background_W_m2_sr = 0.0;
    /// Lines of sight over the field that the environment is asked for its background: 1 x 1 is
    /// uniform, the one at the field's centre; see BackgroundGrid. 0 rows are automatic: sums take
    /// what is behind each object (SightsBehind), pictures as many rows as half a percent needs.
    /// Each at most `largestBackgroundGrid`.
    int backgroundRows = 0, backgroundColumns = 1;
    /// The sun is seen as a disc, see SunDisc.
    bool sunDisc = false;
    /// Images show the light that droplets scatter around objects, with the MTF database of the
    /// environment's AtmosphereScatteringLUT; see SceneScattering.
    bool scattering = false;
    /// What the texels of skybox and terrain mean.
    TextureScale skybox, terrain;
    /// Terrain before an object hides it; else terrain is a picture behind all objects, as in the
    /// report.
    bool terrainHides = true;
    /// Transparent layers kept per sample, nearest first; what is left over is counted and
    /// reported.
    int maximumLayers = 64;
    bool truthLayers = false;
    /// Objects over whose extent the air changes by more than this, as a part of what arrives, are
    /// cut into slices of range; else the air is that of their reference point and a bound of the
    /// error is reported. See AtmosphereSlices.
    double atmosphereSliceFrom = 0.02;
    /// The sums over objects come with their errors (ErrorParts), which follow from the samples
    /// that are there; see RenderErrorEstimator.
    bool errors = true;

    bool operator==(const RenderSettings&) const = default;
};

} // namespace irsg
