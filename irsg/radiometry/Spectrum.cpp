#include "irsg/radiometry/Spectrum.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "irsg/core/Errors.h"
#include "irsg/core/Interpolation.h"
#include "irsg/radiometry/GaussLegendre.h"

namespace irsg {

namespace {

void check(const std::vector<double>& wavelengths_um, const std::vector<double>& values,
           const std::string& name) {
    if (wavelengths_um.size() != values.size()) {
        throw InputError({name, "",
                          std::to_string(wavelengths_um.size()) + " wavelengths and " +
                              std::to_string(values.size()) + " values",
                          "as many values as wavelengths"});
    }
    if (wavelengths_um.size() < 2) {
        throw InputError(
            {name, "", std::to_string(wavelengths_um.size()) + " nodes", "at least two nodes"});
    }
    for (std::size_t i = 0; i < values.size(); ++i) {
        const std::string position = "node " + std::to_string(i + 1);
        const std::string wavelength = "wavelength " + numberText(wavelengths_um[i]) + " um";
        if (!std::isfinite(wavelengths_um[i]) || wavelengths_um[i] <= 0.0)
            throw InputError({name, position, wavelength, "a positive and finite wavelength"});
        if (i > 0 && wavelengths_um[i] <= wavelengths_um[i - 1]) {
            throw InputError({name, position, wavelength,
                              "more than the " + numberText(wavelengths_um[i - 1]) +
                                  " um before it: wavelengths ascend strictly"});
        }
        if (!std::isfinite(values[i]))
            throw InputError({name, position, "value " + numberText(values[i]), "a finite value"});
    }
}

void checkRange(const SpectralRange& range) {
    if (!(range.min_um > 0.0 && range.min_um < range.max_um && std::isfinite(range.max_um))) {
        throw LogicError("a spectral range from " + numberText(range.min_um) + " to " +
                         numberText(range.max_um) + " um");
    }
}

/// Nodes in the range at which a spectrum that is zero outside its axis jumps: beside each end.
void addJumps(const Spectrum& spectrum, const SpectralRange& range, std::vector<double>& axis) {
    if (spectrum.isConstant() || spectrum.outside() == Spectrum::Outside::hold)
        return;
    const double before_um = std::nextafter(spectrum.wavelengths_um().front(), 0.0);
    const double behind_um = std::nextafter(spectrum.wavelengths_um().back(), HUGE_VAL);
    if (spectrum.values().front() != 0.0 && before_um > range.min_um && before_um < range.max_um)
        axis.push_back(before_um);
    if (spectrum.values().back() != 0.0 && behind_um > range.min_um && behind_um < range.max_um)
        axis.push_back(behind_um);
}

/// The merged axis of two spectra on which both are linear between nodes, jumps included.
std::vector<double> linearAxis(const Spectrum& a, const Spectrum& b, const SpectralRange& range) {
    const Spectrum* const both[] = {&a, &b};
    std::vector<double> axis = mergeAxes(both, range);
    addJumps(a, range, axis);
    addJumps(b, range, axis);
    std::ranges::sort(axis);
    const auto doubled = std::ranges::unique(axis);
    axis.erase(doubled.begin(), doubled.end());
    return axis;
}

bool isZeroOutside(const Spectrum& spectrum) {
    return !spectrum.isConstant() && spectrum.outside() == Spectrum::Outside::zero;
}

} // namespace

Spectrum Spectrum::constant(double value) {
    if (!std::isfinite(value))
        throw InputError({"spectrum", "", "value " + numberText(value), "a finite value"});
    Spectrum spectrum;
    spectrum.values_ = {value};
    return spectrum;
}

Spectrum::Spectrum(std::vector<double> wavelengths_um, std::vector<double> values, Outside outside,
                   const std::string& name)
    : wavelengths_um_(std::move(wavelengths_um)), values_(std::move(values)), outside_(outside) {
    check(wavelengths_um_, values_, name);
}

double Spectrum::valueAt(double wavelength_um, std::size_t upper) const {
    if (outside_ == Outside::zero &&
        (wavelength_um < wavelengths_um_.front() || wavelength_um > wavelengths_um_.back()))
        return 0.0;
    const Bracket place = bracketNear(upper - 1, wavelengths_um_, wavelength_um);
    return lerp(values_[place.below], values_[place.above], place.fraction);
}

std::size_t Spectrum::upperNode(double wavelength_um) const {
    return bracket(wavelengths_um_, wavelength_um).above;
}

double Spectrum::at(double wavelength_um) const {
    return isConstant() ? values_.front() : valueAt(wavelength_um, upperNode(wavelength_um));
}

std::vector<double> Spectrum::sample(std::span<const double> wavelengths_um) const {
    if (isConstant() || wavelengths_um.empty())
        return std::vector<double>(wavelengths_um.size(), values_.front());
    // The first interval is searched, the others are found by walking on from the one before.
    std::vector<double> samples;
    samples.reserve(wavelengths_um.size());
    std::size_t upper = upperNode(wavelengths_um.front());
    double before_um = wavelengths_um.front();
    for (const double wavelength_um : wavelengths_um) {
        if (wavelength_um < before_um)
            throw LogicError("a spectrum was asked for wavelengths that do not ascend");
        before_um = wavelength_um;
        while (upper + 1 < size() && wavelengths_um_[upper] <= wavelength_um)
            ++upper;
        samples.push_back(valueAt(wavelength_um, upper));
    }
    return samples;
}

double Spectrum::minimum() const {
    return *std::ranges::min_element(values_);
}

double Spectrum::maximum() const {
    return *std::ranges::max_element(values_);
}

bool Spectrum::covers(const SpectralRange& range) const {
    return isConstant() ||
           (wavelengths_um_.front() <= range.min_um && wavelengths_um_.back() >= range.max_um);
}

Spectrum Spectrum::mapped(const std::function<double(double)>& f) const {
    std::vector<double> values;
    values.reserve(size());
    for (const double value : values_)
        values.push_back(f(value));
    return isConstant() ? constant(values.front())
                        : Spectrum(wavelengths_um_, std::move(values), outside_);
}

std::vector<double> mergeAxes(std::span<const Spectrum* const> spectra,
                              const SpectralRange& range) {
    checkRange(range);
    std::vector<double> axis = {range.min_um, range.max_um};
    for (const Spectrum* spectrum : spectra) {
        const auto& nodes = spectrum->wavelengths_um();
        const auto first = std::ranges::upper_bound(nodes, range.min_um);
        const auto last = std::ranges::lower_bound(nodes, range.max_um);
        if (first < last)
            axis.insert(axis.end(), first, last);
    }
    std::ranges::sort(axis);
    const auto doubled = std::ranges::unique(axis);
    axis.erase(doubled.begin(), doubled.end());
    return axis;
}

double integrateProduct(std::span<const Spectrum* const> factors, const SpectralRange& range) {
    // n points integrate degree 2 n - 1; the product has the degree of its number of factors.
    const std::vector<double> axis = mergeAxes(factors, range);
    const auto degree = std::ranges::count_if(
        factors, [](const Spectrum* factor) { return !factor->isConstant(); });
    const GaussRule& rule = gaussLegendre(static_cast<int>(degree / 2 + 1));

    // Every point lies inside an interval, so that jumps at the ends of an axis stay between
    // points.
    std::vector<double> points;
    std::vector<double> products;
    for (std::size_t i = 0; i + 1 < axis.size(); ++i) {
        const double width = axis[i + 1] - axis[i];
        for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
            points.push_back(axis[i] + width * rule.nodes[k]);
            products.push_back(width * rule.weights[k]);
        }
    }
    for (const Spectrum* factor : factors) {
        const std::vector<double> samples = factor->sample(points);
        std::ranges::transform(products, samples, products.begin(), std::multiplies<>());
    }

    double integral = 0.0;
    for (const double product : products)
        integral += product;
    return integral;
}

Spectrum sum(const Spectrum& a, const Spectrum& b, const SpectralRange& range) {
    if (a.isConstant() && b.isConstant())
        return Spectrum::constant(a.values().front() + b.values().front());
    std::vector<double> axis = linearAxis(a, b, range);
    std::vector<double> values = a.sample(axis);
    std::ranges::transform(values, b.sample(axis), values.begin(), std::plus<>());
    const bool zero = isZeroOutside(a) && isZeroOutside(b);
    return {std::move(axis), std::move(values),
            zero ? Spectrum::Outside::zero : Spectrum::Outside::hold, "sum"};
}

Spectrum product(const Spectrum& a, const Spectrum& b, const SpectralRange& range,
                 double relativeTolerance) {
    if (a.isConstant() && b.isConstant())
        return Spectrum::constant(a.values().front() * b.values().front());
    const std::vector<double> nodes = linearAxis(a, b, range);
    const std::vector<double> atA = a.sample(nodes);
    const std::vector<double> atB = b.sample(nodes);

    // The chord of a parabola is wrong by |da db| / 4 in its middle, and by 1 / n^2 of that on each
    // of n equal parts.
    std::vector<double> axis;
    std::vector<double> values;
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
        const double largest =
            std::max({std::abs(atA[i] * atB[i]), std::abs(atA[i + 1] * atB[i + 1]),
                      std::abs(0.25 * (atA[i] + atA[i + 1]) * (atB[i] + atB[i + 1]))});
        const double error = 0.25 * std::abs((atA[i + 1] - atA[i]) * (atB[i + 1] - atB[i]));
        const double parts =
            error > 0.0 ? std::ceil(std::sqrt(error / (relativeTolerance * largest))) : 1.0;
        for (double part = 0.0; part < parts; part += 1.0) {
            const double t = part / parts;
            const double wavelength_um = std::lerp(nodes[i], nodes[i + 1], t);
            if (part == 0.0 || (wavelength_um > axis.back() && wavelength_um < nodes[i + 1])) {
                axis.push_back(wavelength_um);
                values.push_back(std::lerp(atA[i], atA[i + 1], t) *
                                 std::lerp(atB[i], atB[i + 1], t));
            }
        }
    }
    axis.push_back(nodes.back());
    values.push_back(atA.back() * atB.back());
    const bool zero = isZeroOutside(a) || isZeroOutside(b);
    return {std::move(axis), std::move(values),
            zero ? Spectrum::Outside::zero : Spectrum::Outside::hold, "product"};
}

} // namespace irsg
