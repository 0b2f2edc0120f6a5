#include "irsg/scene/SurfaceShading.h"

#include "irsg/render/sampling/LayerSort.h"
#include "irsg/render/sampling/SmoothShares.h"

namespace irsg {

void SurfaceShading::apply(const SheetScene& sheet, const RenderSettings& settings,
                           GeometrySamples& samples) const {
    samples.groups.clear();
    if (!joins.mostDifference.empty())
        joinSmoothSamples(sheet, joins, samples);
    if (shadows)
        shadows->apply(sheet, settings.truthLayers, samples);
    if (lobes)
        lobes->apply(sheet, between.exchange ? shadows.get() : nullptr, between.exchange.get(),
                     aims.get(), samples);
    if (hasGas)
        shareOutGas(sheet.sheet, samples);
}

void SurfaceShading::sortAndApply(const SheetScene& sheet, const RenderSettings& settings,
                                  GeometrySamples& samples) const {
    sortLayers(samples, settings.maximumLayers);
    apply(sheet, settings, samples);
}

} // namespace irsg
