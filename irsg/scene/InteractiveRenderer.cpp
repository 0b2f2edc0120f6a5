#include "irsg/scene/InteractiveRenderer.h"

#include <utility>

namespace irsg {

Vec3 InteractiveRenderer::referencePoint(std::size_t entity) const {
    const Entity& own = scene.entities.at(entity);
    return own.pose.toWorld(renderer_->referencePoint(own));
}

RenderedImage InteractiveRenderer::imageWithReport() {
    Rendered made = render(Outputs::imageWithReports());
    return {std::move(made.image), std::move(made.reports.front())};
}

RenderedImage InteractiveRenderer::image() {
    Rendered made = render(Outputs::image());
    return {std::move(made.image), std::move(made.reports.front())};
}

RadianceImage InteractiveRenderer::picture() {
    return render(Outputs::followedImage()).image;
}

RenderReport InteractiveRenderer::measure() {
    return std::move(measure({}).front());
}

std::vector<RenderReport> InteractiveRenderer::measure(const std::vector<Band>& bands) {
    return render(Outputs::reports(bands)).reports;
}

IntensitySpectrum
InteractiveRenderer::measureSpectrum(const std::vector<double>& wavenumbers_per_cm) {
    return render(Outputs::spectrum(wavenumbers_per_cm)).spectrum;
}

std::unique_ptr<const ScaledView>
InteractiveRenderer::scaledView(const std::vector<ScalingInput>& inputs) {
    return std::move(render(Outputs::scaledView(inputs)).scaled.front());
}

std::unique_ptr<const ScaledView>
InteractiveRenderer::scaledSpectrum(const std::vector<ScalingInput>& inputs,
                                    const std::vector<double>& wavenumbers_per_cm) {
    return std::move(render(Outputs::scaledSpectrum(inputs, wavenumbers_per_cm)).scaled.front());
}

} // namespace irsg
