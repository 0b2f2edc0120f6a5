#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace irsg {

/// A spectral interval in micrometres, 0 < min_um < max_um.
struct SpectralRange {
    double min_um = 3.0;
    double max_um = 5.0;

    double width_um() const { return max_um - min_um; }
    double centre_um() const { return 0.5 * (min_um + max_um); }
    bool contains(const SpectralRange& other) const {
        return min_um <= other.min_um && max_um >= other.max_um;
    }
    bool operator==(const SpectralRange&) const = default;
};

/// A function of wavelength sampled on its own axis and linear between its nodes.
///
/// A spectrum is either constant (one value, no axis, valid at every wavelength) or has at least
/// two nodes. Outside its axis a sampled spectrum answers with `Outside`: emission and response are
/// zero there, surface properties and transmittance hold their end value.
class Spectrum {
  public:
    enum class Outside { zero, hold };

    /// The constant 0.
    Spectrum() = default;
    static Spectrum constant(double value);

    /// `wavelengths_um` strictly ascending, positive and finite, at least two; `values` finite and
    /// as many. Throws InputError naming the first node that breaks the rule; `name` is how the
    /// message calls the spectrum.
    Spectrum(std::vector<double> wavelengths_um, std::vector<double> values,
             Outside outside = Outside::hold, const std::string& name = "spectrum");

    bool isConstant() const { return wavelengths_um_.empty(); }
    std::size_t size() const { return values_.size(); }
    const std::vector<double>& wavelengths_um() const { return wavelengths_um_; }
    const std::vector<double>& values() const { return values_; }
    Outside outside() const { return outside_; }

    /// Value at a wavelength, linear between nodes.
    double at(double wavelength_um) const;
    /// Values at ascending wavelengths; one sweep, no search per point.
    std::vector<double> sample(std::span<const double> wavelengths_um) const;

    double minimum() const;
    double maximum() const;
    /// The part of the axis that is sampled; a constant spectrum covers everything.
    bool covers(const SpectralRange& range) const;

    /// The same nodes with every value passed through `f`.
    Spectrum mapped(const std::function<double(double)>& f) const;

    bool operator==(const Spectrum&) const = default;

  private:
    /// Index of the upper node of the interval that holds a wavelength, 1 to size() - 1.
    std::size_t upperNode(double wavelength_um) const;
    double valueAt(double wavelength_um, std::size_t upper) const;

    std::vector<double> wavelengths_um_;
    std::vector<double> values_ = {0.0};
    Outside outside_ = Outside::hold;
};

/// All nodes of all axes inside `range`, with both ends of it, ascending and without duplicates.
/// Axes of constant spectra add nothing.
std::vector<double> mergeAxes(std::span<const Spectrum* const> spectra, const SpectralRange& range);

/// Exact integral over `range` of the product of piecewise linear spectra (up to rounding):
/// Gauss-Legendre quadrature of sufficient order on every interval of the merged axis.
double integrateProduct(std::span<const Spectrum* const> factors, const SpectralRange& range);

/// Pointwise sum and product on the merged axis over `range`. The product of two linear pieces is a
/// parabola; `product` refines the axis until the linear pieces follow it to `relativeTolerance`.
Spectrum sum(const Spectrum& a, const Spectrum& b, const SpectralRange& range);
Spectrum product(const Spectrum& a, const Spectrum& b, const SpectralRange& range,
                 double relativeTolerance = 1e-6);

} // namespace irsg
