#include <algorithm>

#include "irsg/radiometry/Errors.h"
#include "irsg/radiometry/Units.h"
#include "irsg/scene/IrsgParts.h"
#include "irsg/scene/radiance/FactorTable.h"
#include "irsg/scene/radiance/SceneScaledView.h"

namespace irsg {

namespace {

void requireNoScales(const std::vector<Entity>& entities) {
    for (const Entity& entity : entities)
        if (!entity.temperatureScale.empty() || !entity.emissivityScale.empty())
            throw LogicError("a view as a function of scales was asked of a scaled scene");
}

} // namespace

std::unique_ptr<const ScaledView> Irsg::scaledView(const std::vector<ScalingInput>& inputs) {
    Parts& p = *parts_;
    requireNoScales(p.entities);
    const Parts::Frame frame = p.frame();
    const ProjectedFactors& factors = p.factorsOf(frame);
    return p.timed("scaled view", [&] {
        RenderReport report;
        evaluateFactors(factors, frame.radiometry, frame.background, frame.geometry, p.entities,
                        report);
        ScaledValues nominal{{report.all.intensity_W_sr},
                             {report.all.contrastIntensity_W_sr},
                             {report.all.irradiance_W_m2}};
        return std::make_unique<const SceneScaledView>(factors, frame.radiometry, frame.geometry,
                                                       inputs, false, std::move(nominal));
    });
}

std::unique_ptr<const ScaledView> Irsg::scaledSpectrum(const std::vector<ScalingInput>& inputs,
                                                       const std::vector<double>& wavenumbers_cm1) {
    Parts& p = *parts_;
    requireNoScales(p.entities);
    const Parts::Frame frame = p.frame(CalculationMode::spectral);
    const ProjectedFactors& factors = p.factorsOf(frame);
    return p.timed("scaled view", [&] {
        // Each wavelength once, ascending, whatever was asked for.
        std::vector<double> wavelengths_um;
        for (const double wavenumber_cm1 : wavenumbers_cm1) {
            if (!(wavenumber_cm1 > 0.0))
                throw LogicError("a wavenumber that is not positive was asked for");
            wavelengths_um.push_back(wavelengthFromWavenumber_um(wavenumber_cm1));
        }
        std::vector<double> ascending = wavelengths_um;
        std::ranges::sort(ascending);
        ascending.erase(std::ranges::unique(ascending).begin(), ascending.end());
        std::vector<std::size_t> order;
        for (const double wavelength_um : wavelengths_um)
            order.push_back(static_cast<std::size_t>(
                std::ranges::lower_bound(ascending, wavelength_um) - ascending.begin()));

        const SceneRadiometry radiometry(p.environment, p.entities, frame.geometry, p.settings,
                                         p.centre(), ascending);
        IntensitySpectrum spectrum =
            evaluateSpectrum(factors, radiometry, frame.geometry, p.entities);
        ScaledValues nominal{std::move(spectrum.intensity_W_sr_um),
                             std::move(spectrum.contrastIntensity_W_sr_um),
                             std::move(spectrum.irradiance_W_m2_um)};
        auto view = std::make_unique<SceneScaledView>(factors, radiometry, frame.geometry, inputs,
                                                      true, std::move(nominal));
        view->reorder(std::move(order));
        return std::unique_ptr<const ScaledView>(std::move(view));
    });
}

} // namespace irsg
