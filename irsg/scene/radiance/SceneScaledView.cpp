#include "irsg/scene/radiance/SceneScaledView.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <span>

#include "irsg/radiometry/Errors.h"
#include "irsg/radiometry/Planck.h"
#include "irsg/radiometry/Units.h"

namespace irsg {

template <typename Function>
std::optional<ScaleSeries> ScaleSeries::fitted(double least, double most,
                                               const Function& function) {
    if (!(most > least))
        return ScaleSeries(function(least));
    ScaleSeries series;
    series.middle_ = 0.5 * (1.0 / least + 1.0 / most);
    series.halfWidth_ = 0.5 * (1.0 / least - 1.0 / most);
    const auto valueAt = [&](double x) {
        return function(1.0 / (series.middle_ + series.halfWidth_ * x));
    };
    for (int count = 9; count <= 65; count = 2 * count - 1) {
        std::vector<double> logs;
        for (int i = 0; i < count; ++i) {
            const double value = valueAt(std::cos(pi * (i + 0.5) / count));
            if (!(value > 0.0) || !std::isfinite(value))
                return std::nullopt;
            logs.push_back(std::log(value));
        }
        series.terms_.assign(static_cast<std::size_t>(count), 0.0);
        for (int j = 0; j < count; ++j) {
            double sum = 0.0;
            for (int i = 0; i < count; ++i)
                sum += logs[static_cast<std::size_t>(i)] * std::cos(pi * j * (i + 0.5) / count);
            series.terms_[static_cast<std::size_t>(j)] = sum * (j == 0 ? 1.0 : 2.0) / count;
        }
        bool isExact = true;
        for (const double x : {-1.0, -0.83, -0.41, 0.07, 0.52, 0.91, 1.0}) {
            const double value = valueAt(x);
            const double found = series.at(1.0 / (series.middle_ + series.halfWidth_ * x));
            isExact = isExact && std::abs(found - value) <= 1e-11 * value;
        }
        if (isExact) {
            while (series.terms_.size() > 2 && std::abs(series.terms_.back()) < 1e-14)
                series.terms_.pop_back();
            return series;
        }
    }
    return std::nullopt;
}

double ScaleSeries::at(double scale) const {
    if (terms_.empty())
        return constant_;
    // Clenshaw's recurrence.
    const double x = (1.0 / scale - middle_) / halfWidth_;
    double next = 0.0, afterNext = 0.0;
    for (std::size_t j = terms_.size() - 1; j > 0; --j) {
        const double here = terms_[j] + 2.0 * x * next - afterNext;
        afterNext = next;
        next = here;
    }
    return std::exp(terms_[0] + x * next - afterNext);
}

SceneScaledView::SceneScaledView(const ViewFactors& view, const SceneRadiometry& radiometry,
                                 const KindRadiances& radiances,
                                 const std::vector<double>& ranges_m,
                                 std::pair<std::size_t, std::size_t> nodes,
                                 const std::vector<ScalingInput>& inputs, bool isSpectrum,
                                 ScaledValues nominal)
    : nodes_(nodes), isSpectrum_(isSpectrum), base_(std::move(nominal)) {
    const auto& all_um = radiometry.wavelengths_um();
    wavelengths_um_.assign(all_um.begin() + static_cast<std::ptrdiff_t>(nodes.first),
                           all_um.begin() + static_cast<std::ptrdiff_t>(nodes.second));
    std::vector<Surface> surfaces;
    for (std::size_t drawn = 0; drawn < radiometry.rows().keys().size(); ++drawn) {
        const auto& [entity, codes] = radiometry.rows().keys()[drawn];
        Surface surface = surfaceOf(radiometry, static_cast<int>(drawn));
        for (std::size_t i = 0; i < inputs.size(); ++i) {
            if (inputs[i].entity != entity)
                continue;
            if (inputs[i].kind == ScalingKind::temperature) {
                if (inputs[i].index == codes.temperature && surface.temperature_K > 0.0)
                    surface.temperatureInput = static_cast<int>(i);
            } else if (inputs[i].index == codes.material) {
                surface.emissivityInput = static_cast<int>(i);
            }
        }
        surfaces.push_back(std::move(surface));
    }
    gather(view, radiometry, radiances, ranges_m, surfaces);

    // What no input reaches, or nobody sees, stays in the base; the others leave it.
    ScaledValues atOne;
    for (std::vector<double>* column :
         {&atOne.intensity, &atOne.contrastIntensity, &atOne.irradiance})
        column->resize(base_.intensity.size());
    for (Surface& surface : surfaces) {
        const bool isSeen = !surface.emitted.intensity.empty();
        if (!isSeen || (surface.temperatureInput < 0 && surface.emissivityInput < 0))
            continue;
        add(surface, 1.0, 1.0, atOne);
        if (!isSpectrum)
            close(surface, inputs);
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
    const SurfaceSpectra& spectra = radiometry.surfaces()[static_cast<std::size_t>(drawn)];
    Surface surface;
    surface.temperature_K = spectra.temperature_K;
    for (std::size_t i = nodes_.first; i < nodes_.second; ++i) {
        surface.emissivity.push_back(spectra.emissivity[i]);
        surface.absorbedAtMost.push_back(1.0 - spectra.transmissivity[i]);
    }
    return surface;
}

void SceneScaledView::gather(const ViewFactors& view, const SceneRadiometry& radiometry,
                             const KindRadiances& radiances, const std::vector<double>& ranges_m,
                             std::vector<Surface>& surfaces) const {
    const std::size_t count = wavelengths_um_.size();
    const std::vector<RadianceTerm>& terms = radiometry.terms().terms;
    std::map<int, std::vector<double>> passed; // by front
    view.field.forEach(0, [&](std::size_t number, std::span<const double> numbers) {
        const FactorKind& kind = view.field.kinds()[number];
        const int drawn = radiometry.rows().drawnOf(kind.row);
        Surface& surface = surfaces[static_cast<std::size_t>(drawn)];
        const SurfaceSpectra& spectra = radiometry.surfaces()[static_cast<std::size_t>(drawn)];
        const AirSamples& air = radiometry.air(kind.row);
        const double range_m = ranges_m[static_cast<std::size_t>(
            radiometry.rows().keys()[static_cast<std::size_t>(drawn)].first)];
        const double square_m2 = range_m * range_m;
        const auto [front, isNew] = passed.try_emplace(kind.front);
        if (isNew)
            front->second = radiances.passed(kind.front);
        for (Drive* drive : {&surface.emitted, &surface.reflected}) {
            drive->intensity.resize(count);
            drive->irradiance.resize(count);
        }

        for (std::size_t k = 0; k < terms.size(); ++k) {
            const RadianceTerm& term = terms[k];
            const bool isEmission = term.surface == SurfaceQuantity::emission;
            if (term.surface == SurfaceQuantity::opacity || (term.light && !air.light[k]))
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
            Drive& drive = isEmission ? surface.emitted : surface.reflected;
            const bool isMeasured = isEmission && !(surface.temperature_K > 0.0);
            const std::vector<double> measured =
                isMeasured ? apparentTerm(spectra, radiometry.terms(), k, air)
                           : std::vector<double>();
            for (std::size_t i = 0; i < count; ++i) {
                const std::size_t node = nodes_.first + i;
                double unit = front->second[node];
                if (isEmission)
                    unit *= isMeasured ? measured[node] : (*air.transmittance)[node];
                else
                    unit *= (*air.light[k])[node] * (*air.transmittance)[node] / pi;
                drive.intensity[i] += unit * plain_sr * square_m2;
                drive.irradiance[i] += unit * cosine_sr;
            }
        }
    });
}

std::vector<SceneScaledView::Group> SceneScaledView::groupsOf(const Surface& surface,
                                                              double mostEmissivity) const {
    constexpr double never = std::numeric_limits<double>::infinity();
    std::vector<std::pair<double, std::size_t>> limits;
    for (std::size_t i = 0; i < wavelengths_um_.size(); ++i) {
        const double emissivity = surface.emissivity[i], most = surface.absorbedAtMost[i];
        limits.emplace_back(emissivity * mostEmissivity <= most ? never : most / emissivity, i);
    }
    std::ranges::sort(limits);
    std::vector<Group> groups;
    for (const auto& [limit, i] : limits) {
        if (groups.empty() || limit > groups.back().limit * (1.0 + 1e-12))
            groups.emplace_back().limit = limit;
        groups.back().wavelengths.push_back(i);
    }
    return groups;
}

void SceneScaledView::close(Surface& surface, const std::vector<ScalingInput>& inputs) const {
    constexpr std::size_t mostGroups = 16;
    const double mostEmissivity =
        surface.emissivityInput < 0
            ? 1.0
            : inputs[static_cast<std::size_t>(surface.emissivityInput)].most;
    std::vector<Group> groups = groupsOf(surface, mostEmissivity);
    if (groups.size() > mostGroups)
        return;

    for (Group& group : groups) {
        const auto seriesOf = [&](const std::vector<double>& drive) -> std::optional<ScaleSeries> {
            const auto emission = [&](double scale) {
                double sum = 0.0;
                for (const std::size_t i : group.wavelengths)
                    sum += drive[i] * surface.emissivity[i] *
                           planckRadiance_W_m2_sr_um(wavelengths_um_[i],
                                                     scale * surface.temperature_K);
                return sum;
            };
            const double one = surface.temperature_K > 0.0 ? emission(1.0) : 0.0;
            if (surface.temperatureInput < 0 || one == 0.0)
                return ScaleSeries(one);
            const ScalingInput& input = inputs[static_cast<std::size_t>(surface.temperatureInput)];
            return ScaleSeries::fitted(input.least, input.most, emission);
        };
        const auto emission = seriesOf(surface.emitted.intensity);
        const auto onDetector = seriesOf(surface.emitted.irradiance);
        if (!emission || !onDetector)
            return;
        group.emission = *emission;
        group.emissionOnDetector = *onDetector;
        for (const std::size_t i : group.wavelengths) {
            group.reflectedLess.intensity += surface.emissivity[i] * surface.reflected.intensity[i];
            group.reflectedLess.irradiance +=
                surface.emissivity[i] * surface.reflected.irradiance[i];
        }
        group.wavelengths.clear();
    }
    for (std::size_t i = 0; i < wavelengths_um_.size(); ++i) {
        const double white = surface.absorbedAtMost[i];
        surface.reflectedWhite.intensity += white * surface.reflected.intensity[i];
        surface.reflectedWhite.irradiance += white * surface.reflected.irradiance[i];
        if (!(surface.temperature_K > 0.0)) {
            surface.measured.intensity += surface.emitted.intensity[i];
            surface.measured.irradiance += surface.emitted.irradiance[i];
        }
    }
    surface.groups = std::move(groups);
    surface.isClosed = true;
    surface.emitted = surface.reflected = {};
    surface.emissivity.clear();
    surface.absorbedAtMost.clear();
}

SceneScaledView::Pair SceneScaledView::closedSum(const Surface& surface, double scaleT,
                                                 double scaleE) {
    Pair sum{surface.reflectedWhite.intensity + scaleE * surface.measured.intensity,
             surface.reflectedWhite.irradiance + scaleE * surface.measured.irradiance};
    for (const Group& group : surface.groups) {
        const double scale = std::min(scaleE, group.limit);
        sum.intensity += scale * (group.emission.at(scaleT) - group.reflectedLess.intensity);
        sum.irradiance +=
            scale * (group.emissionOnDetector.at(scaleT) - group.reflectedLess.irradiance);
    }
    return sum;
}

void SceneScaledView::add(const Surface& surface, double scaleT, double scaleE,
                          ScaledValues& values) const {
    if (surface.isClosed) {
        const Pair sum = closedSum(surface, scaleT, scaleE);
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
    if (std::ranges::none_of(surfaces_, &Surface::isClosed))
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
        const double scaleT = scaleOf(surface.temperatureInput);
        const double scaleE = scaleOf(surface.emissivityInput);
        if (known == nullptr || !surface.isClosed) {
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
            *found = {scaleT, scaleE, closedSum(surface, scaleT, scaleE)};
        }
        values.intensity[0] += found->sum.intensity;
        values.contrastIntensity[0] += found->sum.intensity;
        values.irradiance[0] += found->sum.irradiance;
    }
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
