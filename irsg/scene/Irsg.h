#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "irsg/atmosphere/Environment.h"
#include "irsg/image/RadianceImage.h"
#include "irsg/image/SampledWindows.h"
#include "irsg/scene/Model.h"
#include "irsg/scene/Pose.h"
#include "irsg/scene/ProjectedFactors.h"
#include "irsg/scene/Sensor.h"
#include "irsg/scene/background/TextureScale.h"
#include "irsg/signature/EntityState.h"
#include "irsg/signature/SignatureDatabase.h"

namespace irsg {

class ScaledView;
class Skybox;
class Terrain;
struct ScalingInput;

/// How a band is integrated (F19, the report's CalculationMode).
enum class CalculationMode {
    spectral = 1, ///< at every wavelength of the spectra that meet
    wideband = 2  ///< at the terms of the atmosphere's correlated-k, see SensorCkData
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
enum class BackgroundMode {
    none,       ///< 0
    constant,   ///< `background_W_m2_sr`, in-band
    environment ///< the environment's, along one line of sight or a grid of them
};

/// How zoom antialiasing samples.
enum class ZoomStrategy {
    aligned, ///< windows on the sensor's pixel grid, see PixelAlignedStrategy
    sills    ///< as published, see SillsBasedStrategy
};

struct RenderSettings {
    CalculationMode mode = CalculationMode::spectral;
    /// Zoom antialiasing: side of the windows that objects are drawn into, samples; 128, 256 or 512
    /// for modes 3 to 5 of the report, any from 8 to 2048. 0: every pixel is sampled alike.
    int zoomWindow = 256;
    ZoomStrategy zoomStrategy = ZoomStrategy::aligned;
    /// Objects narrower than this are drawn once per aspect and then stand for any range as points,
    /// with the aligned zoom, before no terrain and apart from other objects; see PointSources.
    /// Pixels, 0 (never) to 1.
    double pointSourceBelow_px = 1.0 / 64.0;
    /// Small parts that shine out of their object, such as exhaust pipes, have windows of their
    /// own, with the aligned zoom; see HotParts.
    bool hotParts = true;
    /// Supersampling, where there is no zoom window: 1, 2 or 4 for modes 0 to 2; any 1 to 16.
    int samplesPerAxis = 4;
    /// `samplesPerAxis` is meant in all, not per axis: 4 is 2 x 2, and 2 is two side by side.
    bool samplesInAll = false;
    ReflectionMode sun = ReflectionMode::smart;
    ReflectionMode fluxes = ReflectionMode::smart;
    FluxWeights fluxWeights = FluxWeights::viewFactor;
    BackgroundMode background = BackgroundMode::environment;
    double background_W_m2_sr = 0.0;
    /// Lines of sight over the field that the environment is asked for its background: 1 x 1 is
    /// uniform, the one at the field's centre, 0 rows are as many as half a percent needs; see
    /// BackgroundGrid.
    int backgroundRows = 1, backgroundColumns = 1;
    /// The sun is seen as a disc, see SunDisc.
    bool sunDisc = false;
    /// What the texels of skybox and terrain mean.
    TextureScale skybox, terrain;
    /// Terrain before an object hides it; else terrain is a picture behind all objects, as in the
    /// report.
    bool terrainHides = true;
    /// Transparent layers kept per sample, nearest first; what is left over is counted and
    /// reported.
    int maximumLayers = 64;
    bool truthLayers = false;

    bool operator==(const RenderSettings&) const = default;
};

/// One thing that flies, drives or floats.
struct Entity {
    std::string name;
    std::shared_ptr<const Model> model;
    std::shared_ptr<const SignatureDatabase> database;
    Pose pose;
    /// Altitude, ambient temperature and aspect angle are filled in by Irsg.
    EntityState state;
    /// In model axes; the centre of the bounding box of the opaque geometry where it is not set.
    std::optional<Vec3> referencePoint_m;
    /// Entries that stand in for codes without one; otherwise such a face is an InputError.
    std::optional<int> fallbackTemperature;
    std::optional<int> fallbackMaterial;
    /// Scalings (report section 11): T in K is multiplied, emissivity is multiplied.
    std::map<int, double> temperatureScale;
    std::map<int, double> emissivityScale;
};

/// The radiometry of one object as the sensor sees it, summed in double over its samples.
struct ObjectRadiometry {
    std::string name;
    double range_m = 0.0;                ///< sensor to reference point
    double intensity_W_sr = 0.0;         ///< sum of A_pre omega d^2
    double contrastIntensity_W_sr = 0.0; ///< sum of (A_pre - alpha L_bg) omega d^2
    double irradiance_W_m2 = 0.0;        ///< sum of (A_pre - alpha L_bg) omega cos theta
    double coveredPixels = 0.0;          ///< sum of the coverage
    double solidAngle_sr = 0.0;          ///< sum of coverage omega
};

struct RenderReport {
    double totalIrradiance_W_m2 = 0.0; ///< of the whole frame, background included
    double background_W_m2_sr = 0.0;
    std::vector<ObjectRadiometry> objects;
    ObjectRadiometry all;                ///< of all objects together, at the first object's range
    std::vector<std::string> answeredBy; ///< "transmittance: vacuum"
    std::vector<std::string> warnings;   ///< each said once
    std::vector<SampledWindow> windows;  ///< what the antialiasing sampled by itself
    long flooredPixels = 0;              ///< of the background, whose sum was below 0
    int layersLeftOver = 0;              ///< samples with more transparent layers than are kept
    double transmissivityResidue = 0.0;  ///< largest relative error of the scalar t for t(lambda)
    std::string renderer;                ///< GL renderer and version
};

struct RenderedImage {
    RadianceImage image; ///< "L"; with truth layers the other planes of formats.md
    RenderReport report;
};

/// Spectral quantities of all objects together as they arrive at the sensor, through the air but
/// without the sensor's response; at the first object's range.
struct IntensitySpectrum {
    std::vector<double> wavenumbers_cm1; ///< as asked for
    std::vector<double> wavelengths_um;  ///< 1e4 / wavenumber
    std::vector<double> intensity_W_sr_um;
    std::vector<double> contrastIntensity_W_sr_um;
    std::vector<double> irradiance_W_m2_um; ///< of the contrast
    double coveredPixels = 0.0;
    std::vector<std::string> warnings;
};

/// Time spent in each stage since the last reset, s.
struct StageTimes {
    struct Stage {
        std::string name;
        double seconds = 0.0;
        long calls = 0;
    };
    std::vector<Stage> stages;
};

/// Infrared scene generator: a scene, a sensor and an environment in; images, radiometry or
/// projected factors out. Owns an off-screen OpenGL context of its own (EGL, no display needed) and
/// may be used from any one thread at a time; the caller's current context is left as it was.
class Irsg {
  public:
    Irsg();
    ~Irsg();
    Irsg(const Irsg&) = delete;
    Irsg& operator=(const Irsg&) = delete;

    void setEnvironment(Environment environment);
    const Environment& environment() const;
    void setSensor(const Sensor& sensor);
    const Sensor& sensor() const;
    void setSettings(const RenderSettings& settings);
    const RenderSettings& settings() const;

    /// Replaces the scene. Models are shared, never copied; databases are read at the next drawing.
    void setEntities(std::vector<Entity> entities);
    const std::vector<Entity>& entities() const;
    void setPose(std::size_t entity, const Pose& pose);
    void setState(std::size_t entity, const EntityState& state);
    void setDatabase(std::size_t entity, std::shared_ptr<const SignatureDatabase> database);
    /// In the world, at the entity's present pose.
    Vec3 referencePoint(std::size_t entity) const;

    /// Pictures around the eye and ground under it, added to the background; null for none.
    void setSkybox(std::shared_ptr<const Skybox> skybox);
    void setTerrain(std::shared_ptr<const Terrain> terrain);

    void setViewpoint(const Viewpoint& viewpoint);
    const Viewpoint& viewpoint() const;

    /// Checks the whole scene: every code has an entry, spectra cover the band, sensor and targets
    /// are above the ground, an atmosphere has the calculation mode. Throws InputError with every
    /// offence.
    void checkConfiguration() const;

    /// Radiance image in W m-2 sr-1 with its report.
    RenderedImage render();
    /// The image of render() alone, for a window that follows what is edited. For the second
    /// picture of a view what each pixel takes of each surface is drawn and kept; from then on
    /// another time, temperature, spectrum or air is a sum, equal to render() within the rounding
    /// of float.
    RadianceImage picture();
    /// The report alone, in double from the projected factors. These are kept and drawn anew only
    /// when geometry, viewpoint, sensor raster, transparency or N change; another time, power,
    /// band, temperature or spectrum is a dot product.
    RenderReport measure();
    /// The same, per wavelength; computed in the spectral mode, whichever is set.
    IntensitySpectrum measureSpectrum(const std::vector<double>& wavenumbers_cm1);
    /// What measure() would say of all objects together, as a function of scales. The entities'
    /// own scales must be empty (LogicError).
    std::unique_ptr<const ScaledView> scaledView(const std::vector<ScalingInput>& inputs);
    /// The same of measureSpectrum().
    std::unique_ptr<const ScaledView> scaledSpectrum(const std::vector<ScalingInput>& inputs,
                                                     const std::vector<double>& wavenumbers_cm1);
    /// The table that gives the intensity of this view in any band (architecture, decision 1).
    ProjectedFactors projectFactors();

    /// GL renderer string: "llvmpipe (LLVM 15.0.6, 256 bits), 4.5 (Compatibility Profile)
    /// Mesa 22.3.6".
    std::string rendererDescription();
    /// Memory that drawing keeps on the graphics card apart from models and textures, bytes.
    std::size_t graphicsMemory_bytes() const;
    StageTimes stageTimes() const;
    void resetStageTimes();

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

} // namespace irsg
