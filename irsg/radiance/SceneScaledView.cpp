#include "irsg/radiance/SceneScaledView.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <span>
#include <tuple>

#include "irsg/core/Errors.h"
#include "irsg/radiometry/Planck.h"
#include "irsg/radiometry/Units.h"

namespace irsg {

SceneScaledView::SceneScaledView(const ViewGeometry& view, const SceneRadiometry& radiometry,
                                 const SurfaceRadianceTable& radiances, SceneLight* light,
                                 PlanckTable& planck, const std::vector<double>& ranges_m,
                                 std::pair<std::size_t, std::size_t> nodes,
                                 const std::vector<ScalingInput>& inputs, bool isSpectrum,
                                 ScaledValues nominal, std::optional<int> only)
    : nodes_(nodes), isSpectrum_(isSpectrum), base_(std::move(nominal)) {
    const auto& all_um = radiometry.wavelengths_um();
    wavelengths_um_.assign(all_um.begin() + static_cast<std::ptrdiff_t>(nodes.first),
                           all_um.begin() + static_cast<std::ptrdiff_t>(nodes.second));
    std::vector<Surface> surfaces;
    for (std::size_t drawn = 0; drawn < radiometry.rows().renderedCount(); ++drawn) {
        const auto& [entity, codes] = radiometry.rows().keyOf(static_cast<int>(drawn));
        Surface surface = surfaceOf(radiometry, static_cast<int>(drawn));
        // Lobes that reflect the atmosphere or other surfaces do not emit.
        const SurfaceSpectra& spectra = radiometry.surfaces()[drawn];
        const bool emits = spectra.lobeLight == nullptr && !spectra.reflectsSurfacesAlone;
        for (std::size_t i = 0; i < inputs.size(); ++i) {
            if (inputs[i].entity != entity)
                continue;
            if (inputs[i].kind == ScalingKind::temperature) {
                if (emits && inputs[i].index == codes.temperature && surface.temperature_K > 0.0)
                    surface.inputs.temperatureInput = static_cast<int>(i);
            } else if (inputs[i].index == codes.material) {
                surface.inputs.emissivityInput = static_cast<int>(i);
            }
        }
        surfaces.push_back(std::move(surface));
    }
    gather(view, radiometry, radiances, ranges_m, surfaces);
    if (light) {
        std::vector<ScaledRow> rows;
        for (const Surface& surface : surfaces)
            rows.push_back(surface.inputs);
        light_.emplace(view, radiometry, radiances, *light, rows, ranges_m, nodes, inputs.size(),
                       isSpectrum, only);
    }

    // What belongs to other objects is seen by nobody here.
    for (std::size_t drawn = 0; only && drawn < surfaces.size(); ++drawn)
        if (radiometry.rows().keyOf(static_cast<int>(drawn)).first != *only)
            surfaces[drawn].emitted.intensity.clear();
    // What no input reaches, or nobody sees, stays in the base; the others leave it.
    ScaledValues atOne;
    for (std::vector<double>* column :
         {&atOne.intensity, &atOne.contrastIntensity, &atOne.irradiance})
        column->resize(base_.intensity.size());
    // What directional surfaces and their lobes emit whatever the scale of the emissivity is.
    for (std::size_t drawn = 0, last = surfaces.size(); drawn < last; ++drawn) {
        const SurfaceSpectra& spectra = radiometry.surfaces()[drawn];
        const Surface& own = surfaces[drawn];
        if (spectra.emitsAlways.empty() || own.temperature_K <= 0.0 || spectra.lobeLight ||
            own.emitted.intensity.empty())
            continue;
        Surface always;
        always.inputs.temperatureInput = own.inputs.temperatureInput;
        always.temperature_K = own.temperature_K;
        always.emitted = own.emitted;
        const std::size_t count = wavelengths_um_.size();
        always.emissivity.assign(count, 1.0);
        always.absorbedAtMost = always.emissivity;
        always.reflected.intensity.assign(count, 0.0);
        always.reflected.irradiance = always.reflected.intensity;
        for (std::size_t i = 0; i < count; ++i) {
            always.emitted.intensity[i] *= spectra.emitsAlways[nodes_.first + i];
            always.emitted.irradiance[i] *= spectra.emitsAlways[nodes_.first + i];
        }
        surfaces.push_back(std::move(always));
    }
    for (Surface& surface : surfaces) {
        const bool isSeen = !surface.emitted.intensity.empty();
        if (!isSeen || (surface.inputs.temperatureInput < 0 && surface.inputs.emissivityInput < 0))
            continue;
        add(surface, 1.0, 1.0, atOne);
        if (!isSpectrum)
            close(surface, planck, inputs);
        surfaces_.push_back(std::move(surface));
    }
    for (std::size_t i = 0; i < base_.intensity.size(); ++i) {
        base_.intensity[i] -= atOne.intensity[i];
        base_.contrastIntensity[i] -= atOne.contrastIntensity[i];
        base_.irradiance[i] -= atOne.irradiance[i];
    }
}

SceneScaledView::Surface SceneScaledView::surfaceOf(const SceneRadiometry& radiometry,
                                                    int drawn) const {
    const SurfaceSpectra& spectra = radiometry.scaling(drawn);
    Surface surface;
    surface.temperature_K = spectra.temperature_K;
    for (std::size_t i = nodes_.first; i < nodes_.second; ++i) {
        surface.emissivity.push_back(spectra.emissivity[i]);
        surface.absorbedAtMost.push_back(spectra.absorbsAtMost(i));
    }
    return surface;
}

void SceneScaledView::gather(const ViewGeometry& view, const SceneRadiometry& radiometry,
                             const SurfaceRadianceTable& radiances,
                             const std::vector<double>& ranges_m,
                             std::vector<Surface>& surfaces) const {
    const std::size_t count = wavelengths_um_.size();
    const std::vector<RadianceTerm>& terms = radiometry.terms().terms;
    // By front, whether air follows, and the gas that it is a column of, or -1.
    std::map<std::tuple<int, bool, int>, std::vector<double>> passed;
    const auto add = [&](const SurfaceStackId& kind, int drawn, std::span<const double> numbers) {
        Surface& surface = surfaces[static_cast<std::size_t>(drawn)];
        const SurfaceSpectra& spectra = radiometry.surfaces()[static_cast<std::size_t>(drawn)];
        const AtmosphereSamples& air = radiometry.air(kind.row);
        const double range_m =
            ranges_m[static_cast<std::size_t>(radiometry.rows().keyOf(drawn).first)];
        const double square_m2 = range_m * range_m;
        const auto passedBy = [&](bool throughAir) -> const std::vector<double>& {
            const int gas = spectra.isGas ? drawn : -1;
            const auto [stack, isNew] = passed.try_emplace({kind.stack, throughAir, gas});
            if (isNew)
                stack->second = radiances.passed(kind.stack, nodes_, throughAir, gas);
            return stack->second;
        };
        for (Surface::Drive* drive : {&surface.emitted, &surface.reflected}) {
            drive->intensity.resize(count);
            drive->irradiance.resize(count);
        }

        for (std::size_t k = 0; k < terms.size(); ++k) {
            const RadianceTerm& term = terms[k];
            const bool isEmission = term.surface == SurfaceQuantity::emission;
            const bool isMirror = term.surface == SurfaceQuantity::specular;
            if (term.surface == SurfaceQuantity::opacity || spectra.reflectsSurfacesAlone ||
                (spectra.isGas && !isEmission) || (term.light && !air.light[k]) ||
                isMirror != (spectra.lobeLight != nullptr))
                continue;
            // Coverage, a factor, or what is left of the coverage beside it.
            const auto sumOf = [&](std::size_t coverage) {
                const double whole = numbers[coverage];
                if (term.factor.drawn < 0)
                    return whole;
                const double part =
                    numbers[coverage + 1 + static_cast<std::size_t>(term.factor.drawn)];
                return term.factor.complement ? whole - part : part;
            };
            const double plain_sr = sumOf(view.layout.coverage());
            const double cosine_sr = sumOf(view.layout.withCosine(view.layout.coverage()));
            Surface::Drive& drive = isEmission ? surface.emitted : surface.reflected;
            const std::vector<double> unit =
                unitOf(spectra, term, air, k,
                       passedBy(term.passesAtmosphere ||
                                (isEmission && spectra.emissionPassesAtmosphere)));
            for (std::size_t i = 0; i < count; ++i) {
                drive.intensity[i] += unit[i] * plain_sr * square_m2;
                drive.irradiance[i] += unit[i] * cosine_sr;
            }
        }
    };
    view.field.forEach(0, [&](std::size_t number, std::span<const double> numbers) {
        const SurfaceStackId& kind = view.field.kinds()[number];
        for (const int drawn : radiometry.partsOf(radiometry.rows().renderedOf(kind.row)))
            add(kind, drawn, numbers);
    });
}

std::vector<double> SceneScaledView::unitOf(const SurfaceSpectra& surface, const RadianceTerm& term,
                                            const AtmosphereSamples& air, std::size_t number,
                                            std::vector<double> passed) const {
    const auto multiply = [&](const std::vector<double>& values) {
        for (std::size_t i = 0; i < passed.size(); ++i)
            passed[i] *= values[nodes_.first + i];
    };
    const bool isEmission = term.surface == SurfaceQuantity::emission;
    if (term.light)
        multiply(*air.light[number]);
    if (term.passesAtmosphere || (isEmission && surface.emissionPassesAtmosphere))
        multiply(*air.transmittance);
    if (term.surface == SurfaceQuantity::specular)
        multiply(*surface.lobeLight);
    else if (!isEmission)
        for (double& value : passed)
            value /= pi;
    if (isEmission && !(surface.temperature_K > 0.0))
        for (std::size_t i = 0; i < passed.size(); ++i) {
            double measured = 0.0;
            for (const SurfaceSpectra::Emission& part : surface.emission)
                measured += part.factor * part.radiance[nodes_.first + i];
            passed[i] *= measured;
        }
    return passed;
}

void SceneScaledView::close(Surface& surface, PlanckTable& planck,
                            const std::vector<ScalingInput>& inputs) const {
    ScaledSum::Range range;
    if (surface.inputs.temperatureInput >= 0) {
        const ScalingInput& input =
            inputs[static_cast<std::size_t>(surface.inputs.temperatureInput)];
        range.least = input.least;
        range.most = input.most;
    }
    if (surface.inputs.emissivityInput >= 0)
        range.mostEmissivity =
            inputs[static_cast<std::size_t>(surface.inputs.emissivityInput)].most;
    surface.sum = ScaledSum::of(surface, planck, nodes_.first, range);
    if (!surface.sum)
        return;
    surface.emitted = surface.reflected = {};
    surface.emissivity = surface.absorbedAtMost = {};
}

void SceneScaledView::add(const Surface& surface, double scaleT, double scaleE,
                          ScaledValues& values) const {
    if (surface.sum) {
        const ScaledPair sum = surface.sum->at(scaleT, scaleE);
        values.intensity[0] += sum.intensity;
        values.contrastIntensity[0] += sum.intensity;
        values.irradiance[0] += sum.irradiance;
        return;
    }
    const double temperature_K = scaleT * surface.temperature_K;
    for (std::size_t i = 0; i < wavelengths_um_.size(); ++i) {
        const double emissivity =
            std::clamp(scaleE * surface.emissivity[i], 0.0, surface.absorbedAtMost[i]);
        const double reflectivity = surface.absorbedAtMost[i] - emissivity;
        const double emitted =
            surface.temperature_K > 0.0
                ? emissivity * planckRadiance_W_m2_sr_um(wavelengths_um_[i], temperature_K)
                : scaleE;
        const double intensity =
            emitted * surface.emitted.intensity[i] + reflectivity * surface.reflected.intensity[i];
        const std::size_t at = isSpectrum_ ? i : 0;
        values.intensity[at] += intensity;
        values.contrastIntensity[at] += intensity;
        values.irradiance[at] += emitted * surface.emitted.irradiance[i] +
                                 reflectivity * surface.reflected.irradiance[i];
    }
}

std::unique_ptr<ScaledView::Memo> SceneScaledView::memo() const {
    if (std::ranges::none_of(surfaces_, [](const Surface& one) { return one.sum.has_value(); }))
        return nullptr;
    auto made = std::make_unique<SceneMemo>();
    made->surfaces.resize(surfaces_.size());
    return made;
}

void SceneScaledView::evaluate(std::span<const double> scales, ScaledValues& values,
                               Memo* memo) const {
    values = base_;
    auto* known = dynamic_cast<SceneMemo*>(memo);
    const auto scaleOf = [&](int input) {
        return input < 0 ? 1.0 : scales[static_cast<std::size_t>(input)];
    };
    for (std::size_t i = 0; i < surfaces_.size(); ++i) {
        const Surface& surface = surfaces_[i];
        const double scaleT = scaleOf(surface.inputs.temperatureInput);
        const double scaleE = scaleOf(surface.inputs.emissivityInput);
        if (known == nullptr || !surface.sum) {
            add(surface, scaleT, scaleE, values);
            continue;
        }
        SceneMemo::OfSurface& own = known->surfaces[i];
        auto found = std::ranges::find_if(own.known, [&](const SceneMemo::Known& one) {
            return one.scaleT == scaleT && one.scaleE == scaleE;
        });
        if (found == own.known.end()) {
            found = own.known.begin() + static_cast<std::ptrdiff_t>(own.oldest);
            own.oldest = (own.oldest + 1) % own.known.size();
            *found = {scaleT, scaleE, surface.sum->at(scaleT, scaleE)};
        }
        values.intensity[0] += found->sum.intensity;
        values.contrastIntensity[0] += found->sum.intensity;
        values.irradiance[0] += found->sum.irradiance;
    }
    if (light_)
        light_->addTo(scales, values);
    if (order_.empty())
        return;
    for (std::vector<double>* column :
         {&values.intensity, &values.contrastIntensity, &values.irradiance}) {
        const std::vector<double> ascending = *column;
        column->resize(order_.size());
        for (std::size_t i = 0; i < order_.size(); ++i)
            (*column)[i] = ascending[order_[i]];
    }
}

} // namespace irsg
