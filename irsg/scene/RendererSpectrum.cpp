#include <algorithm>
#include <cmath>

#include "irsg/core/Errors.h"
#include "irsg/radiance/SceneScaledView.h"
#include "irsg/radiometry/Units.h"
#include "irsg/scene/RendererImpl.h"

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

IntensitySpectrum Renderer::Impl::spectrum(const Frame& frame, const Outputs& outputs,
                                           Rendered& result) {
    const ViewFactors& factors = factorsOf(frame);
    return timed("evaluation", [&] {
        const Wavelengths wavelengths(outputs.wavenumbers_per_cm());
        const AirScene scene{terms, frame.scene.entities, frame.geometry, frame.scene.settings,
                             frame.centre};
        const std::vector<SampledBand> bands{
            SceneSampling::wavelengths(air, scene, wavelengths.ascending_um)};
        EvaluatedScene evaluated(terms, frame.scene.entities, frame.geometry, bands, fronts);
        evaluated.radiances.setBackground(backgroundOf(bands, frame.scene.settings));
        evaluated.light = lightOf(frame, evaluated.radiometry);
        const std::vector<double> ranges_m = frame.ranges_m();
        const std::vector<ObjectSums> sums = objectSums(
            factors, evaluated.radiances, evaluated.light.get(), evaluated.radiometry.rows(),
            ranges_m, std::vector<int>(wavelengths.ascending_um.size(), -1));

        IntensitySpectrum spectrum;
        spectrum.warnings = evaluated.radiometry.warnings();
        std::vector<std::vector<RadiometryErrors>> errors;
        if (frame.withErrors)
            errors = spectrumErrors(frame, factors, evaluated, bands.front().sampling,
                                    wavelengths.ascending_um, sums);
        ScaledValues nominal;
        for (const ObjectSums& one : sums) {
            nominal.intensity.push_back(one.all.intensity_W_sr);
            nominal.contrastIntensity.push_back(one.all.contrastIntensity_W_sr);
            nominal.irradiance.push_back(one.all.irradiance_W_m2);
        }
        for (std::size_t k = 0; k < wavelengths.order.size(); ++k) {
            const std::size_t i = wavelengths.order[k];
            spectrum.wavenumbers_per_cm.push_back(outputs.wavenumbers_per_cm()[k]);
            spectrum.wavelengths_um.push_back(wavelengths.ascending_um[i]);
            spectrum.intensity_W_sr_um.push_back(nominal.intensity[i]);
            spectrum.contrastIntensity_W_sr_um.push_back(nominal.contrastIntensity[i]);
            spectrum.irradiance_W_m2_um.push_back(nominal.irradiance[i]);
            if (frame.withErrors)
                spectrum.errors.push_back(errors[i].back());
        }
        for (std::size_t e = 0; ranges_m.size() > 1 && e < ranges_m.size(); ++e) {
            ObjectSpectrum& object = spectrum.objects.emplace_back();
            object.name = frame.scene.entities[e].name;
            for (const std::size_t i : wavelengths.order) {
                object.intensity_W_sr_um.push_back(sums[i].objects[e].intensity_W_sr);
                object.contrastIntensity_W_sr_um.push_back(
                    sums[i].objects[e].contrastIntensity_W_sr);
                object.irradiance_W_m2_um.push_back(sums[i].objects[e].irradiance_W_m2);
                if (frame.withErrors)
                    object.errors.push_back(errors[i][e]);
            }
        }
        // What is seen of objects, by whatever it is covered: the nearest layer of every sample.
        factors.field.forEach(0, [&](std::size_t kind, std::span<const double> numbers) {
            if (factors.field.kinds()[kind].front == 0)
                spectrum.coveredPixels += numbers[factors.layout.pixels()];
        });
        if (!outputs.scalings().empty()) {
            auto view = std::make_unique<SceneScaledView>(
                factors, evaluated.radiometry, evaluated.radiances, evaluated.light.get(),
                evaluated.planck, ranges_m,
                std::pair<std::size_t, std::size_t>{0, wavelengths.ascending_um.size()},
                outputs.scalings(), true, std::move(nominal));
            view->reorder(wavelengths.order);
            result.scaled.push_back(std::move(view));
        }
        return spectrum;
    });
}

std::vector<std::vector<RadiometryErrors>> Renderer::Impl::spectrumErrors(
    const Frame& frame, const ViewFactors& factors, EvaluatedScene& evaluated,
    const std::shared_ptr<const SpectralSampling>& nodes, const std::vector<double>& wavelengths_um,
    const std::vector<ObjectSums>& sums) {
    const std::size_t entities = frame.geometry.size();
    const std::vector<double> ranges_m = frame.ranges_m();
    const std::vector<int> uniform(sums.size(), -1);
    std::vector<std::vector<RadiometryErrors>> errors =
        samplingErrors(frame, factors, evaluated.radiances, evaluated.light.get(),
                       evaluated.radiometry.rows(), uniform);

    // Sums along other paths and as they are, both without light between surfaces.
    const auto sumsAlong = [&](const std::vector<ObjectGeometry>& geometry) {
        const AirScene scene{terms, frame.scene.entities, geometry, frame.scene.settings,
                             frame.centre};
        const std::vector<SampledBand> bands{
            SceneSampling::wavelengths(air, scene, wavelengths_um)};
        EvaluatedScene there(terms, frame.scene.entities, geometry, bands, fronts);
        there.radiances.setBackground(backgroundOf(bands, frame.scene.settings));
        return objectSums(factors, there.radiances, nullptr, there.radiometry.rows(), ranges_m,
                          uniform);
    };
    std::vector<ObjectSums> here, nearer;
    try {
        if (const auto places = seenPlaces(frame)) {
            here = sumsAlong(frame.geometry);
            nearer = sumsAlong(*places);
        }
    } catch (const InputError&) {
        nearer.clear(); // some air answers for the path to the reference point alone
    }
    const auto ofAir = [&](std::size_t k, std::size_t e) {
        const ObjectGeometry& object = frame.geometry[e];
        const double intensity = std::abs(sums[k].objects[e].intensity_W_sr);
        if (object.slices_m.size() > 1 || nearer.empty())
            return std::pair(intensity * object.likelyAirError, intensity * object.likelyAirError);
        const ObjectRadiometry &a = here[k].objects[e], &b = nearer[k].objects[e];
        if (!(a.intensity_W_sr > 0.0))
            return std::pair(0.0, 0.0);
        const double share = intensity / a.intensity_W_sr;
        return std::pair(share * std::abs(b.intensity_W_sr - a.intensity_W_sr),
                         share * std::abs(b.contrastIntensity_W_sr - a.contrastIntensity_W_sr));
    };
    const auto seenAlong = [&](const LineOfSight& sight) {
        const std::vector<double>& values =
            *air.at(AtmosphericQuery::backgroundRadiance(steadied(sight),
                                                         frame.scene.environment.sun),
                    nodes)
                 .value;
        std::vector<double> seen;
        for (std::size_t k = 0; k < wavelengths_um.size(); ++k)
            seen.push_back(evaluated.radiometry.integrate(values, k));
        return seen;
    };
    for (std::size_t e = 0; e < entities; ++e) {
        std::vector<double> behind(sums.size(), 0.0);
        if (knowsBackgroundError(frame))
            behind = backgroundErrors(frame, e, seenAlong, {});
        for (std::size_t k = 0; k < sums.size(); ++k) {
            const auto [intensity, contrast] = ofAir(k, e);
            const double square_m2 = ranges_m[e] * ranges_m[e];
            const double background = behind[k] * sums[k].objects[e].solidAngle_sr;
            for (RadiometryErrors* one : {&errors[k][e], &errors[k].back()}) {
                one->intensity_W_sr.air += intensity;
                one->contrastIntensity_W_sr.air += contrast;
                one->irradiance_W_m2.air += contrast / square_m2;
                one->contrastIntensity_W_sr.background += background * square_m2;
                one->irradiance_W_m2.background += background;
            }
        }
    }
    return errors;
}

} // namespace irsg
