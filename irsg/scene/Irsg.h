#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "irsg/atmosphere/Environment.h"
#include "irsg/scene/Entity.h"
#include "irsg/scene/RenderReport.h"
#include "irsg/scene/RenderSettings.h"
#include "irsg/scene/radiance/ProjectedFactors.h"
#include "irsg/scene/view/Pose.h"
#include "irsg/scene/view/Sensor.h"

namespace irsg {

class ScaledView;
class Skybox;
class Terrain;
struct ScalingInput;

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
