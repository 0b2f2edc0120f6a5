#include "irsg/radiance/ScaledSum.h"

#include <algorithm>
#include <limits>

#include "irsg/radiometry/Planck.h"

namespace irsg {

namespace {

/// Places that have series; their sums are as long as this many bands.
constexpr std::size_t mostSeries = 16;

void add(ScaledPair& sum, double factor, const ScaledPair& pair) {
    sum.intensity += factor * pair.intensity;
    sum.irradiance += factor * pair.irradiance;
}

} // namespace

std::vector<ScaledSum::Limited> ScaledSum::sorted(const ScaledSurface& surface,
                                                  double mostEmissivity) {
    constexpr double never = std::numeric_limits<double>::infinity();
    std::vector<Limited> order;
    for (std::size_t i = 0; i < surface.emissivity.size(); ++i) {
        const double emissivity = surface.emissivity[i], most = surface.absorbedAtMost[i];
        order.push_back({emissivity * mostEmissivity <= most ? never : most / emissivity, i});
    }
    std::ranges::stable_sort(order, {}, &Limited::limit);
    return order;
}

std::optional<ScaledSum> ScaledSum::of(const ScaledSurface& surface, PlanckTable& planck,
                                       std::size_t first, const Range& range) {
    ScaledSum sum;
    sum.temperature_K_ = surface.temperature_K;
    const std::vector<Limited> order = sorted(surface, range.mostEmissivity);
    for (std::size_t i = 0; i < order.size() && std::isfinite(order[i].limit); ++i)
        if (sum.limits_.empty() || order[i].limit > sum.limits_.back() * (1.0 + 1e-12)) {
            sum.limits_.push_back(order[i].limit);
            sum.begins_.push_back(i);
        }
    sum.begins_.push_back(static_cast<std::size_t>(
        std::ranges::count_if(order, [](const Limited& one) { return std::isfinite(one.limit); })));

    const bool isBody = surface.temperature_K > 0.0;
    const bool varies = isBody && range.most > range.least;
    for (std::size_t i = 0; i < order.size(); ++i) {
        add(sum.white_, surface.absorbedAtMost[i], surface.reflected.at(i));
        if (!isBody)
            add(sum.measured_, 1.0, surface.emitted.at(i));
    }
    sum.setConstants(surface,
                     isBody && !varies ? planck.at(range.least * surface.temperature_K) : nullptr,
                     first, order);
    if (varies && !sum.setSeries(surface, planck, first, range, order))
        return std::nullopt;
    return sum;
}

void ScaledSum::setConstants(const ScaledSurface& surface, const SharedValues& planck,
                             std::size_t first, const std::vector<Limited>& order) {
    const auto addOf = [&](ScaledPair& sum, const std::vector<double>& absorbed, std::size_t i) {
        add(sum, -absorbed[i], surface.reflected.at(i));
        if (planck)
            add(sum, absorbed[i] * (*planck)[first + i], surface.emitted.at(i));
    };
    // From the last place to the first, and back.
    constants_.resize(limits_.size() + 1);
    for (std::size_t i = begins_.back(); i < order.size(); ++i)
        addOf(constants_.back().above, surface.emissivity, order[i].wavelength);
    for (std::size_t place = limits_.size(); place > 0; --place) {
        constants_[place - 1].above = constants_[place].above;
        for (std::size_t i = begins_[place - 1]; i < begins_[place]; ++i)
            addOf(constants_[place - 1].above, surface.emissivity, order[i].wavelength);
    }
    for (std::size_t place = 1; place <= limits_.size(); ++place) {
        constants_[place].below = constants_[place - 1].below;
        for (std::size_t i = begins_[place - 1]; i < begins_[place]; ++i)
            addOf(constants_[place].below, surface.absorbedAtMost, order[i].wavelength);
    }
}

bool ScaledSum::setSeries(const ScaledSurface& surface, PlanckTable& planck, std::size_t first,
                          const Range& range, const std::vector<Limited>& order) {
    const auto seriesOf = [&](std::size_t begin, std::size_t end,
                              const std::vector<double>& absorbed,
                              const std::vector<double>& drive) {
        std::vector<double> factors;
        for (std::size_t i = begin; i < end; ++i)
            factors.push_back(absorbed[order[i].wavelength] * drive[order[i].wavelength]);
        const auto emission = [&](double scale) {
            const SharedValues radiance = planck.at(scale * surface.temperature_K);
            double sum = 0.0;
            for (std::size_t i = begin; i < end; ++i)
                sum += factors[i - begin] * (*radiance)[first + order[i].wavelength];
            return sum;
        };
        return emission(1.0) == 0.0 ? ScaleSeries()
                                    : ScaleSeries::fitted(range.least, range.most, emission);
    };
    const auto set = [&](SeriesPair& pair, std::size_t begin, std::size_t end,
                         const std::vector<double>& absorbed) {
        const auto intensity = seriesOf(begin, end, absorbed, surface.emitted.intensity);
        const auto irradiance = seriesOf(begin, end, absorbed, surface.emitted.irradiance);
        if (!intensity || !irradiance)
            return false;
        pair = {*intensity, *irradiance};
        return true;
    };
    stride_ = limits_.size() / mostSeries + 1;
    for (std::size_t place = 0; place <= limits_.size(); place += stride_) {
        Series& here = series_.emplace_back();
        if (!set(here.below, 0, begins_[place], surface.absorbedAtMost) ||
            !set(here.above, begins_[place], order.size(), surface.emissivity))
            return false;
    }
    if (stride_ > 1)
        for (std::size_t i = 0; i < begins_.back(); ++i) {
            const std::size_t k = order[i].wavelength;
            singles_.push_back({planck.wavelengths_um()[first + k], surface.emissivity[k],
                                surface.absorbedAtMost[k], surface.emitted.at(k)});
        }
    return true;
}

ScaledPair ScaledSum::at(double scaleT, double scaleE) const {
    const auto place =
        static_cast<std::size_t>(std::ranges::upper_bound(limits_, scaleE) - limits_.begin());
    ScaledPair sum = white_;
    add(sum, scaleE, measured_);
    add(sum, 1.0, constants_[place].below);
    add(sum, scaleE, constants_[place].above);
    if (series_.empty())
        return sum;
    const Series& known = series_[place / stride_];
    add(sum, 1.0, {known.below.intensity.at(scaleT), known.below.irradiance.at(scaleT)});
    add(sum, scaleE, {known.above.intensity.at(scaleT), known.above.irradiance.at(scaleT)});
    for (std::size_t i = begins_[place / stride_ * stride_]; i < begins_[place]; ++i) {
        const Single& one = singles_[i];
        add(sum,
            (one.absorbedAtMost - scaleE * one.emissivity) *
                planckRadiance_W_m2_sr_um(one.wavelength_um, scaleT * temperature_K_),
            one.emitted);
    }
    return sum;
}

} // namespace irsg
