#include "irsg/scene/SpectrumReporter.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "irsg/core/Errors.h"
#include "irsg/radiance/Reductions.h"
#include "irsg/radiance/SceneScaledView.h"
#include "irsg/radiometry/Units.h"

namespace irsg {

namespace {

/// Each wavelength once, ascending, and which of them each wavenumber is.
struct Wavelengths {
    std::vector<double> ascending_um;
    std::vector<std::size_t> order;

    explicit Wavelengths(const std::vector<double>& wavenumbers_per_cm) {
        for (const double wavenumber_per_cm : wavenumbers_per_cm) {
            if (!(wavenumber_per_cm > 0.0))
                throw LogicError("a wavenumber that is not positive was asked for");
            ascending_um.push_back(wavelengthFromWavenumber_um(wavenumber_per_cm));
        }
        const std::vector<double> asked_um = ascending_um;
        std::ranges::sort(ascending_um);
        ascending_um.erase(std::ranges::unique(ascending_um).begin(), ascending_um.end());
        for (const double wavelength_um : asked_um)
            order.push_back(static_cast<std::size_t>(
                std::ranges::lower_bound(ascending_um, wavelength_um) - ascending_um.begin()));
    }
};

} // namespace

SpectrumOfView SpectrumReporter::spectrum(const Frame& frame, const ViewGeometry& factors,
                                          const std::vector<double>& wavenumbers_per_cm,
                                          const std::vector<ScalingInput>& scalings) {
    return clock_.timed("evaluation", [&] {
        const Wavelengths wavelengths(wavenumbers_per_cm);
        const EvaluatedSpectrum sampled = evaluator_.atWavelengths(
            frame.request, frame.evaluation().geometry, wavelengths.ascending_um);
        EvaluatedScene& evaluated = *sampled.scene;
        const std::shared_ptr<SceneLight> light =
            interReflection_.lightOf(frame.exchange(), evaluated.radiometry, frame.settings());
        const std::vector<double> ranges_m = frame.evaluation().ranges_m();
        std::vector<ObjectSums> sums =
            objectSums(factors, evaluated.radiances, light.get(), evaluated.radiometry.rows(),
                       ranges_m, std::vector<int>(wavelengths.ascending_um.size(), -1));
        std::vector<FrameBackground> taken;
        for (std::size_t k = 0; k < sums.size(); ++k)
            taken.emplace_back(evaluated.radiances.background_W_m2_sr(k));
        sampled.behind.takeOwn(frame.request, frame.evaluation().geometry, taken, sums);

        SpectrumOfView result;
        IntensitySpectrum& spectrum = result.spectrum;
        spectrum.warnings = evaluated.radiometry.warnings();
        ErrorsByOutput errors;
        if (frame.request.withErrors)
            errors = errors_.ofSpectrum(frame, factors, sampled, light.get(),
                                        wavelengths.ascending_um, sums);
        ScaledValues nominal;
        for (const ObjectSums& one : sums) {
            nominal.intensity.push_back(one.all.intensity_W_sr);
            nominal.contrastIntensity.push_back(one.all.contrastIntensity_W_sr);
            nominal.irradiance.push_back(one.all.irradiance_W_m2);
        }
        for (std::size_t k = 0; k < wavelengths.order.size(); ++k) {
            const std::size_t i = wavelengths.order[k];
            spectrum.wavenumbers_per_cm.push_back(wavenumbers_per_cm[k]);
            spectrum.wavelengths_um.push_back(wavelengths.ascending_um[i]);
            spectrum.intensity_W_sr_um.push_back(nominal.intensity[i]);
            spectrum.contrastIntensity_W_sr_um.push_back(nominal.contrastIntensity[i]);
            spectrum.irradiance_W_m2_um.push_back(nominal.irradiance[i]);
            if (frame.request.withErrors)
                spectrum.errors.push_back(errors[i].back());
        }
        for (std::size_t e = 0; ranges_m.size() > 1 && e < ranges_m.size(); ++e) {
            ObjectSpectrum& object = spectrum.objects.emplace_back();
            object.name = frame.scene().entities[e].name;
            for (const std::size_t i : wavelengths.order) {
                object.intensity_W_sr_um.push_back(sums[i].objects[e].intensity_W_sr);
                object.contrastIntensity_W_sr_um.push_back(
                    sums[i].objects[e].contrastIntensity_W_sr);
                object.irradiance_W_m2_um.push_back(sums[i].objects[e].irradiance_W_m2);
                if (frame.request.withErrors)
                    object.errors.push_back(errors[i][e]);
            }
        }
        // What is seen of objects, by whatever it is covered: the nearest layer of every sample.
        factors.field.forEach(0, [&](std::size_t kind, std::span<const double> numbers) {
            if (factors.field.kinds()[kind].stack == 0)
                spectrum.coveredPixels += numbers[factors.layout.pixels()];
        });
        if (!scalings.empty()) {
            auto view = std::make_unique<SceneScaledView>(
                factors, evaluated.radiometry, evaluated.radiances, light.get(), evaluated.planck,
                ranges_m, std::pair<std::size_t, std::size_t>{0, wavelengths.ascending_um.size()},
                scalings, true, std::move(nominal));
            view->reorder(wavelengths.order);
            result.scaled = std::move(view);
        }
        return result;
    });
}

} // namespace irsg
