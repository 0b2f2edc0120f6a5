#pragma once

#include <span>
#include <utility>
#include <vector>

#include "irsg/radiometry/Spectrum.h"

namespace irsg {

/// The nodes at which spectral quantities are known, with weights in um that add a quantity up:
/// integral of f = sum of weight times f(node). The quadrature of a band is a sampling, one
/// wavelength or a list of them is one, the quadrature points of wideband-ck are one, and so is the
/// whole axis of a spectrum.
///
/// What is multiplied is multiplied node by node, and added up last. So the quantities at one node
/// must belong together, as they do at one wavelength or for one absorption coefficient of a gas;
/// means over a part of the spectrum do not. A part of the spectrum may have several nodes, even at
/// the same wavelength, that share its weight.
class SpectralSampling {
  public:
    virtual ~SpectralSampling() = default;

    std::size_t size() const { return wavelengths_um_.size(); }
    /// Ascending; neighbours may be equal.
    const std::vector<double>& wavelengths_um() const { return wavelengths_um_; }
    /// They include the response of a sensor where there is one.
    const std::vector<double>& weights_um() const { return weights_um_; }
    /// What the nodes stand for: air answers at them if it holds this range.
    const SpectralRange& range() const { return range_; }

    /// A spectrum at every node: its value there, or its mean over what the node stands for.
    virtual std::vector<double> sampled(const Spectrum& spectrum) const;
    /// Planck radiance at every node, W m-2 sr-1 um-1.
    std::vector<double> planck(double temperature_K) const;

    /// Sum of weight times value; as many values as nodes (LogicError otherwise).
    double integrate(std::span<const double> values) const;
    /// Sum of weight times a times b.
    double integrate(std::span<const double> a, std::span<const double> b) const;
    /// Sum of the weights, um.
    double area_um() const;

  protected:
    SpectralSampling() = default;
    SpectralSampling(std::vector<double> wavelengths_um, std::vector<double> weights_um,
                     const SpectralRange& range);
    SpectralSampling(const SpectralSampling&) = default;
    SpectralSampling(SpectralSampling&&) = default;
    SpectralSampling& operator=(const SpectralSampling&) = default;
    SpectralSampling& operator=(SpectralSampling&&) = default;

    /// LogicError unless wavelengths are positive and ascend, weights are as many, there is at
    /// least one, and the range has a width.
    void setNodes(std::vector<double> wavelengths_um, std::vector<double> weights_um,
                  const SpectralRange& range);

  private:
    void check(std::size_t values) const;

    std::vector<double> wavelengths_um_, weights_um_;
    SpectralRange range_;
};

/// Wavelengths of the caller's choice, ascending.
class SpectralPoints : public SpectralSampling {
  public:
    /// Of weight 1 each. They stand for what lies between the first and the last and for parts in
    /// 1e9 beyond, so that one wavelength alone stands for an interval, too.
    explicit SpectralPoints(std::vector<double> wavelengths_um);
    SpectralPoints(std::vector<double> wavelengths_um, std::vector<double> weights_um,
                   const SpectralRange& range)
        : SpectralSampling(std::move(wavelengths_um), std::move(weights_um), range) {}
};

/// The axis of a spectrum within a range, with both ends of the range: its values there are all
/// there is to know of it. The weights are those of the trapezoidal rule, which integrates a
/// spectrum on this axis exactly (a spectrum that jumps at an end of its axis inside the range
/// excepted).
class SpectralGrid : public SpectralSampling {
  public:
    SpectralGrid(const Spectrum& spectrum, const SpectralRange& range);
};

} // namespace irsg
