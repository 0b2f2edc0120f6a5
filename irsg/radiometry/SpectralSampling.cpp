#include "irsg/radiometry/SpectralSampling.h"

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>

#include "irsg/core/Errors.h"
#include "irsg/radiometry/Planck.h"

namespace irsg {

namespace {

/// Sum of term(0) to term(count - 1) in four partial sums, which do not wait for each other.
template <typename Term>
double sumOf(std::size_t count, Term term) {
    double partialSums[4] = {0.0, 0.0, 0.0, 0.0};
    std::size_t i = 0;
    for (; i + 4 <= count; i += 4)
        for (std::size_t s = 0; s < 4; ++s)
            partialSums[s] += term(i + s);
    for (; i < count; ++i)
        partialSums[0] += term(i);
    return (partialSums[0] + partialSums[1]) + (partialSums[2] + partialSums[3]);
}

SpectralRange around(const std::vector<double>& wavelengths_um) {
    constexpr double part = 1e-9;
    if (wavelengths_um.empty())
        throw LogicError("a sampling without wavelengths was asked for");
    return {wavelengths_um.front() * (1.0 - part), wavelengths_um.back() * (1.0 + part)};
}

} // namespace

SpectralSampling::SpectralSampling(std::vector<double> wavelengths_um,
                                   std::vector<double> weights_um, const SpectralRange& range) {
    setNodes(std::move(wavelengths_um), std::move(weights_um), range);
}

void SpectralSampling::setNodes(std::vector<double> wavelengths_um, std::vector<double> weights_um,
                                const SpectralRange& range) {
    if (wavelengths_um.empty() || wavelengths_um.size() != weights_um.size())
        throw LogicError("a sampling of " + std::to_string(wavelengths_um.size()) +
                         " wavelengths and " + std::to_string(weights_um.size()) + " weights");
    if (!std::ranges::is_sorted(wavelengths_um) || !(wavelengths_um.front() > 0.0))
        throw LogicError("a sampling whose wavelengths are not positive or do not ascend");
    if (!(range.min_um < range.max_um))
        throw LogicError("a sampling of the range " + numberText(range.min_um) + " to " +
                         numberText(range.max_um) + " um");
    wavelengths_um_ = std::move(wavelengths_um);
    weights_um_ = std::move(weights_um);
    range_ = range;
}

std::vector<double> SpectralSampling::sampled(const Spectrum& spectrum) const {
    return spectrum.sample(wavelengths_um_);
}

std::vector<double> SpectralSampling::planck(double temperature_K) const {
    std::vector<double> radiances(size());
    planckRadiances_W_m2_sr_um(wavelengths_um_, temperature_K, radiances);
    return radiances;
}

void SpectralSampling::check(std::size_t values) const {
    if (values != size())
        throw LogicError("a sampling of " + std::to_string(size()) + " nodes was given " +
                         std::to_string(values) + " values");
}

double SpectralSampling::integrate(std::span<const double> values) const {
    check(values.size());
    return sumOf(size(), [&](std::size_t i) { return weights_um_[i] * values[i]; });
}

double SpectralSampling::integrate(std::span<const double> a, std::span<const double> b) const {
    check(a.size());
    check(b.size());
    return sumOf(size(), [&](std::size_t i) { return weights_um_[i] * a[i] * b[i]; });
}

double SpectralSampling::area_um() const {
    return std::accumulate(weights_um_.begin(), weights_um_.end(), 0.0);
}

SpectralPoints::SpectralPoints(std::vector<double> wavelengths_um) {
    const SpectralRange range = around(wavelengths_um);
    std::vector<double> weights_um(wavelengths_um.size(), 1.0);
    setNodes(std::move(wavelengths_um), std::move(weights_um), range);
}

SpectralGrid::SpectralGrid(const Spectrum& spectrum, const SpectralRange& range) {
    const Spectrum* const one[] = {&spectrum};
    std::vector<double> axis = mergeAxes(one, range);
    std::vector<double> weights_um(axis.size(), 0.0);
    for (std::size_t i = 0; i + 1 < axis.size(); ++i) {
        const double half_um = 0.5 * (axis[i + 1] - axis[i]);
        weights_um[i] += half_um;
        weights_um[i + 1] += half_um;
    }
    setNodes(std::move(axis), std::move(weights_um), range);
}

} // namespace irsg
