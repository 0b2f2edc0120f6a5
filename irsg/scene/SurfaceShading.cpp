#include "irsg/scene/SurfaceShading.h"

#include "irsg/render/sampling/LayerSort.h"

namespace irsg {

void SurfaceShading::join(const SheetScene& sheet, GeometrySamples& samples) const {
    samples.groups.clear();
    if (!joins.mostDifference.empty())
        joinSmoothSamples(sheet, joins, samples);
}

void SurfaceShading::apply(const SheetScene& sheet, const RenderSettings& settings,
                           GeometrySamples& samples) const {
    if (shadows)
        shadows->apply(sheet, settings.truthLayers, samples);
    if (lobes)
        lobes->apply(sheet, between.exchange ? shadows.get() : nullptr, between.exchange.get(),
                     aims.get(), samples);
}

void SurfaceShading::sortAndApply(const SheetScene& sheet, const RenderSettings& settings,
                                  GeometrySamples& samples) const {
    sortLayers(samples, settings.maximumLayers);
    join(sheet, samples);
    apply(sheet, settings, samples);
}

} // namespace irsg
