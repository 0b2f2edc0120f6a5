#include "irsg/core/ParallelFor.h"
#include "smatcore/data/ImageSource.h"

namespace smat {

namespace {

/// Passes everything on: the one place of this floor that knows the infrared scene generator.
class IrsgImageSource : public ImageSource {
  public:
    void configure(const SceneDescription& scene) override {
        setView(scene);
        irsg_.setEntities(scene.entities);
    }
    void setView(const SceneDescription& scene) override { smat::setView(irsg_, scene); }

    irsg::Vec3 referencePointInModel(std::size_t entity) override {
        const irsg::Pose& pose = irsg_.entities().at(entity).pose;
        return pose.attitude.rotation().transposed() *
               (irsg_.referencePoint(entity) - pose.position_m);
    }

    void setPose(std::size_t entity, const irsg::Pose& pose) override {
        irsg_.setPose(entity, pose);
    }
    void setState(std::size_t entity, const irsg::EntityState& state) override {
        irsg_.setState(entity, state);
    }
    void setViewpoint(const irsg::Viewpoint& viewpoint) override { irsg_.setViewpoint(viewpoint); }

    irsg::RenderedImage render() override { return irsg_.render(); }
    irsg::RenderedImage renderWithErrors() override { return irsg_.render(true); }
    irsg::RenderedImage renderImage() override { return irsg_.image(); }
    std::function<irsg::PixelExplanation(int x, int y)> explainer() override {
        return
            [this, ready = irsg_.explainer()](int x, int y) { return irsg_.explain(*ready, x, y); };
    }
    irsg::RenderReport measure() override { return irsg_.measure(); }
    std::vector<irsg::RenderReport> measure(const std::vector<irsg::Band>& bands) override {
        return irsg_.measure(bands);
    }
    std::vector<irsg::RenderReport>
    measureAlongRange(const std::vector<irsg::Band>& bands) override {
        return irsg_.measureAlongRange(bands);
    }
    std::function<Reports()> beginMeasure(const Measure& wanted) override {
        return [this, begun = irsg_.beginMeasure(wanted.bands, wanted.alongRange, wanted.source,
                                                 wanted.errors)] {
            return irsg_.finishMeasure(begun);
        };
    }
    bool drawsBeside() const override { return irsg::mostThreads() > 1; }
    irsg::IntensitySpectrum
    measureSpectrum(const std::vector<double>& wavenumbers_per_cm) override {
        return irsg_.measureSpectrum(wavenumbers_per_cm);
    }
    irsg::IntensitySpectrum
    measureSpectrumWithErrors(const std::vector<double>& wavenumbers_per_cm) override {
        return irsg_.measureSpectrum(wavenumbers_per_cm, true);
    }

    std::unique_ptr<const irsg::ScaledView>
    scaledView(const std::vector<irsg::ScalingInput>& inputs,
               const std::vector<double>& wavenumbers_per_cm) override {
        return wavenumbers_per_cm.empty() ? irsg_.scaledView(inputs)
                                          : irsg_.scaledSpectrum(inputs, wavenumbers_per_cm);
    }

    std::vector<std::unique_ptr<const irsg::ScaledView>>
    scaledViews(const std::vector<irsg::ScalingInput>& inputs,
                const std::vector<irsg::Band>& bands) override {
        return irsg_.scaledViews(inputs, bands);
    }
    std::vector<std::unique_ptr<const irsg::ScaledView>>
    scaledObjects(const std::vector<irsg::ScalingInput>& inputs,
                  const std::vector<irsg::Band>& bands) override {
        return irsg_.scaledObjects(inputs, bands);
    }

    std::string rendererDescription() override { return irsg_.rendererDescription(); }
    irsg::StageTimes stageTimes() const override { return irsg_.stageTimes(); }
    void resetStageTimes() override { irsg_.resetStageTimes(); }

  private:
    irsg::Irsg irsg_;
};

} // namespace

void setView(irsg::Irsg& irsg, const SceneDescription& scene) {
    irsg.setEnvironment(scene.environment);
    irsg.setSensor(scene.sensor);
    irsg.setSettings(scene.render);
    irsg.setSkybox(scene.skybox);
    irsg.setTerrain(scene.terrain);
}

std::unique_ptr<ImageSource> makeIrsgImageSource() {
    return std::make_unique<IrsgImageSource>();
}

} // namespace smat
