#include "irsg/scene/Irsg.h"

#include "irsg/core/Errors.h"

namespace irsg {

void Irsg::setEntities(std::vector<Entity> entities) {
    for (const Entity& entity : entities)
        if (!entity.model || !entity.database)
            throw LogicError("an entity needs a model and a database");
    scene_.entities = std::move(entities);
}

void Irsg::setDatabase(std::size_t entity, std::shared_ptr<const SignatureDatabase> database) {
    if (!database)
        throw LogicError("an entity needs a database");
    scene_.entities.at(entity).database = std::move(database);
}

Vec3 Irsg::referencePoint(std::size_t entity) const {
    const Entity& own = scene_.entities.at(entity);
    return own.pose.toWorld(renderer_->referencePoint(own));
}

RenderedImage Irsg::render(bool errors) {
    Rendered made =
        renderer_->render(scene_, view_, {.image = true, .reports = true, .errors = errors});
    return {std::move(made.image), std::move(made.reports.front())};
}

RenderedImage Irsg::image() {
    Rendered made = renderer_->render(scene_, view_, {.image = true});
    return {std::move(made.image), std::move(made.reports.front())};
}

RadianceImage Irsg::picture() {
    return renderer_->render(scene_, view_, {.image = true, .followed = true}).image;
}

RenderReport Irsg::measure() {
    return std::move(renderer_->render(scene_, view_, {.reports = true}).reports.front());
}

std::vector<RenderReport> Irsg::measure(const std::vector<Band>& bands) {
    return renderer_->render(scene_, view_, {.reports = true, .bands = bands}).reports;
}

std::vector<RenderReport> Irsg::measureAlongRange(const std::vector<Band>& bands) {
    return renderer_->render(scene_, view_, {.reports = true, .alongRange = true, .bands = bands})
        .reports;
}

IntensitySpectrum Irsg::measureSpectrum(const std::vector<double>& wavenumbers_per_cm,
                                        bool errors) {
    return renderer_
        ->render(scene_, view_, {.errors = errors, .wavenumbers_per_cm = wavenumbers_per_cm})
        .spectrum;
}

std::unique_ptr<const ScaledView> Irsg::scaledView(const std::vector<ScalingInput>& inputs) {
    return std::move(renderer_->render(scene_, view_, {.scalings = inputs}).scaled.front());
}

std::vector<std::unique_ptr<const ScaledView>>
Irsg::scaledViews(const std::vector<ScalingInput>& inputs, const std::vector<Band>& bands) {
    return renderer_->render(scene_, view_, {.bands = bands, .scalings = inputs}).scaled;
}

std::vector<std::unique_ptr<const ScaledView>>
Irsg::scaledObjects(const std::vector<ScalingInput>& inputs, const std::vector<Band>& bands) {
    return renderer_
        ->render(scene_, view_, {.bands = bands, .scalings = inputs, .scaledObjects = true})
        .scaled;
}

std::unique_ptr<const ScaledView>
Irsg::scaledSpectrum(const std::vector<ScalingInput>& inputs,
                     const std::vector<double>& wavenumbers_per_cm) {
    return std::move(
        renderer_
            ->render(scene_, view_, {.wavenumbers_per_cm = wavenumbers_per_cm, .scalings = inputs})
            .scaled.front());
}

} // namespace irsg
