#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>

#include "irsg/render/values/PixelExplanation.h"
#include "irsg/scene/Outputs.h"
#include "irsg/scene/PendingRender.h"
#include "irsg/scene/Scene.h"

namespace irsg {

class RadianceTerms;

/// The door of the library: a scene, a view and what is asked for in; images, radiometry and
/// spectra out. The result is a function of these values alone. What is kept between calls
/// (prepared models, drawings, the air along a path, wideband points, in-band radiances) are caches
/// keyed by values, and nobody sees whether one was hit but by the time.
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
    Rendered render(const Scene& scene, const SensorView& view, const Outputs& outputs);

    /// Begins what render() says: reports are drawn while the caller does something else, most of
    /// all begins the next view; anything else is drawn before this returns. Throws what render()
    /// throws; what fails in drawing reports is thrown by PendingRender::get.
    PendingRender begin(const Scene& scene, const SensorView& view, const Outputs& outputs);

    /// Makes ready to explain the pixels of render()'s image, whoever drew it, in the sensor's
    /// band: what each of them is made of, by rays through the samples that the image takes of it.
    /// It is called with a column and a row, the top left pixel is 0, 0 (LogicError for one outside
    /// the frame), and must not outlive this renderer. Throws what render() throws, and InputError
    /// where this build has no rays.
    std::function<PixelExplanation(int x, int y)> explainer(const Scene& scene,
                                                            const SensorView& view);

    /// Checks the whole scene: every code has an entry, spectra cover the bands, sensor and targets
    /// are above the ground, an atmosphere has the calculation mode, and each quantity that will be
    /// asked for is provided over the bands, and the haze of an image has its database. Throws
    /// InputError with every diagnostic.
    void check(const Scene& scene, const SensorView& view,
               const Outputs& outputs = Outputs::image());

    /// Of an entity, in model axes; see Entity::referencePoint_m.
    Vec3 referencePoint(const Entity& entity);
    /// How far an entity reaches from that point at most, m.
    double reach_m(const Entity& entity);

    /// Who answers the samples of a scene: "llvmpipe (LLVM 15.0.6, 256 bits), OpenGL 4.5
    /// (Compatibility Profile) Mesa 22.3.6", or "rays, Embree 3.13.5", and why where it was chosen.
    /// Throws InputError where this machine or this build has not got it.
    std::string rendererDescription(const Scene& scene);
    /// Memory that drawing keeps on the graphics card apart from models and textures, bytes.
    std::size_t graphicsMemory_bytes() const;
    /// Since the renderer was made.
    StageTimes stageTimes() const;

  private:
    struct Impl;
    struct Begun;
    struct Explainer;

    std::unique_ptr<Impl> impl_;
};

} // namespace irsg
