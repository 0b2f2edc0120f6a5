#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "irsg/scene/Renderer.h"

namespace irsg {

/// A renderer that remembers scene and view: for programs that change one thing at a time. Every
/// result is what Renderer::render says of the present values.
class Irsg {
  public:
    void setEnvironment(Environment environment) { scene_.environment = std::move(environment); }
    const Environment& environment() const { return scene_.environment; }
    void setSensor(const Sensor& sensor) { view_.sensor = sensor; }
    const Sensor& sensor() const { return view_.sensor; }
    void setSettings(const RenderSettings& settings) { scene_.settings = settings; }
    const RenderSettings& settings() const { return scene_.settings; }

    /// Replaces the entities. Models are shared, never copied. LogicError for an entity without
    /// model or database.
    void setEntities(std::vector<Entity> entities);
    const std::vector<Entity>& entities() const { return scene_.entities; }
    void setPose(std::size_t entity, const Pose& pose) { scene_.entities.at(entity).pose = pose; }
    void setState(std::size_t entity, const EntityState& state) {
        scene_.entities.at(entity).state = state;
    }
    void setDatabase(std::size_t entity, std::shared_ptr<const SignatureDatabase> database);
    /// In the world, at the entity's present pose.
    Vec3 referencePoint(std::size_t entity) const;

    /// Pictures around the eye and ground under it, added to the background; null for none.
    void setSkybox(std::shared_ptr<const Skybox> skybox) { scene_.skybox = std::move(skybox); }
    void setTerrain(std::shared_ptr<const Terrain> terrain) { scene_.terrain = std::move(terrain); }

    void setViewpoint(const Viewpoint& viewpoint) { view_.viewpoint = viewpoint; }
    const Viewpoint& viewpoint() const { return view_.viewpoint; }

    const Scene& scene() const { return scene_; }
    const SensorView& view() const { return view_; }

    /// See Renderer::check.
    void checkConfiguration() const { renderer_->check(scene_, view_); }

    /// Radiance image in W m-2 sr-1 with its report, whose sums have their errors on request.
    RenderedImage render(bool errors = false);
    /// The image of render(), and of its report how it was drawn: no sums (Rendered::reports).
    RenderedImage image();
    /// The image of render() alone, for a window that follows what is edited (Wanted::followed).
    RadianceImage picture();
    /// See Renderer::explainer; of the present values.
    std::shared_ptr<Renderer::Explainer> explainer() { return renderer_->explainer(scene_, view_); }
    PixelExplanation explain(Renderer::Explainer& explainer, int x, int y) {
        return renderer_->explain(explainer, x, y);
    }
    /// The report alone, in double from factors that are kept (Wanted::reports).
    RenderReport measure();
    /// The same in several bands, from the same drawings.
    std::vector<RenderReport> measure(const std::vector<Band>& bands);
    /// The same at one of many ranges along a line of sight (Wanted::alongRange).
    std::vector<RenderReport> measureAlongRange(const std::vector<Band>& bands);
    /// Begins measure() of the present values, see Renderer::begin.
    std::shared_ptr<Renderer::Begun> beginMeasure(const std::vector<Band>& bands,
                                                  bool alongRange = false, bool source = false,
                                                  bool errors = false) {
        return renderer_->begin(scene_, view_,
                                {.reports = true,
                                 .alongRange = alongRange,
                                 .source = source,
                                 .errors = errors,
                                 .bands = bands});
    }
    std::vector<RenderReport> finishMeasure(const std::shared_ptr<Renderer::Begun>& begun) {
        return renderer_->finish(begun);
    }
    /// The same, per wavelength; computed in the spectral mode, whichever is set.
    /// `errors`: with those of its numbers.
    IntensitySpectrum measureSpectrum(const std::vector<double>& wavenumbers_per_cm,
                                      bool errors = false);
    /// What measure() would say of all objects together, as a function of scales. The entities'
    /// own scales must be empty (LogicError).
    std::unique_ptr<const ScaledView> scaledView(const std::vector<ScalingInput>& inputs);
    /// The same in several bands, from the same drawings.
    std::vector<std::unique_ptr<const ScaledView>>
    scaledViews(const std::vector<ScalingInput>& inputs, const std::vector<Band>& bands);
    /// In each band the view of all objects, and behind it that of each alone.
    std::vector<std::unique_ptr<const ScaledView>>
    scaledObjects(const std::vector<ScalingInput>& inputs, const std::vector<Band>& bands);
    /// The same of measureSpectrum().
    std::unique_ptr<const ScaledView> scaledSpectrum(const std::vector<ScalingInput>& inputs,
                                                     const std::vector<double>& wavenumbers_per_cm);

    Renderer& renderer() { return *renderer_; }
    std::string rendererDescription() { return renderer_->rendererDescription(scene_); }
    std::size_t graphicsMemory_bytes() const { return renderer_->graphicsMemory_bytes(); }
    StageTimes stageTimes() const { return renderer_->stageTimes(); }
    void resetStageTimes() { renderer_->resetStageTimes(); }

  private:
    Scene scene_;
    SensorView view_;
    std::unique_ptr<Renderer> renderer_ = std::make_unique<Renderer>();
};

} // namespace irsg
