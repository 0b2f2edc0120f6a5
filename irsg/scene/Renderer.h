#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "irsg/render/values/PixelExplanation.h"
#include "irsg/scene/Scene.h"

namespace irsg {

class RadianceTerms;

/// Infrared scene generator: a scene, a view and what is wanted in; images, radiometry and spectra
/// out. The result is a function of these values alone. What is kept between calls (prepared
/// models, drawings, the air along a path, wideband points, in-band radiances) are caches keyed by
/// values, and nobody sees whether one was hit but by the time.
///
/// Draws on the process's off-screen OpenGL context (EGL, no display needed), or with rays, which
/// ask for neither (RenderSettings::engine), and may be used from any one thread at a time; the
/// caller's current context is left as it was.
class Renderer {
  public:
    Renderer();
    /// With a list of terms of one's own, which must live as long.
    explicit Renderer(const RadianceTerms& terms);
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    /// Throws InputError with every diagnostic of the scene: see check().
    Rendered render(const Scene& scene, const SensorView& view, const Wanted& wanted);

    /// Begins what render() would say when reports are wanted, `alongRange` or not: the view is
    /// drawn while the caller does something else, most of all sets up the next one. Throws what
    /// render() throws; what fails in drawing is thrown by finish().
    struct Begun;
    std::shared_ptr<Begun> begin(const Scene& scene, const SensorView& view, const Wanted& wanted);
    /// Its reports, by band. What was begun must not outlive this renderer.
    std::vector<RenderReport> finish(const std::shared_ptr<Begun>& begun);

    /// Makes ready to explain the pixels of render()'s image, whoever drew it, in the sensor's
    /// band: what each of them is made of, by rays through the samples that the image takes of it.
    /// Throws what render() throws, and InputError where this build has no rays.
    struct Explainer;
    std::shared_ptr<Explainer> explainer(const Scene& scene, const SensorView& view);
    /// LogicError for a pixel outside the frame. An explainer must not outlive this renderer.
    PixelExplanation explain(Explainer& explainer, int x, int y);

    /// Checks the whole scene: every code has an entry, spectra cover the bands, sensor and targets
    /// are above the ground, an atmosphere has the calculation mode. Throws InputError with every
    /// diagnostic.
    void check(const Scene& scene, const SensorView& view, const Wanted& wanted = {});

    /// Of an entity, in model axes; see Entity::referencePoint_m.
    Vec3 referencePoint(const Entity& entity);

    /// Who answers the samples of a scene: "llvmpipe (LLVM 15.0.6, 256 bits), OpenGL 4.5
    /// (Compatibility Profile) Mesa 22.3.6", or "rays, Embree 3.13.5", and why where it was chosen.
    /// Throws InputError where this machine or this build has not got it.
    std::string rendererDescription(const Scene& scene);
    /// Memory that drawing keeps on the graphics card apart from models and textures, bytes.
    std::size_t graphicsMemory_bytes() const;
    StageTimes stageTimes() const;
    void resetStageTimes();

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace irsg
