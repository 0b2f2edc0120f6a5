#include "irsg/scattering/HazeFunction.h"

#include <cmath>

#include "irsg/radiometry/Units.h"
#include "irsg/scattering/BesselIntegral.h"

namespace irsg {

namespace {

constexpr int piecesPerInterval = 8;
/// Fall of the last piece, over the whole frequency, from which the end counts as an edge; a part
/// of the energy.
constexpr double sharpEnd = 1e-3;

} // namespace

HazeFunction::HazeFunction(const MtfCurve& curve) {
    const std::vector<double>& nodes = curve.frequencies_per_rad();
    // A curve that begins above 0 is constant below its first frequency.
    if (nodes.front() > 0.0)
        frequencies_.push_back(0.0);
    frequencies_.push_back(nodes.front());
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i)
        for (int k = 1; k <= piecesPerInterval; ++k)
            frequencies_.push_back(k == piecesPerInterval ? nodes[i + 1]
                                                          : nodes[i] + (nodes[i + 1] - nodes[i]) *
                                                                           k / piecesPerInterval);
    std::vector<double> slopes;
    double last = curve.at(0.0);
    energy_ = last - curve.direct();
    for (std::size_t i = 0; i + 1 < frequencies_.size(); ++i) {
        const double next = curve.at(frequencies_[i + 1]);
        slopes.push_back((next - last) / (frequencies_[i + 1] - frequencies_[i]));
        last = next;
    }
    // What ends a piece begins the next one: one term for each end.
    for (std::size_t i = 0; i < frequencies_.size(); ++i)
        turns_.push_back((i > 0 ? slopes[i - 1] : 0.0) - (i < slopes.size() ? slopes[i] : 0.0));
}

bool HazeFunction::endsSharply() const {
    return std::abs(turns_.back()) * frequencies_.back() > sharpEnd * std::abs(energy_);
}

double HazeFunction::density_sr(double angle_rad) const {
    const double a = 2.0 * pi * angle_rad;
    double sum = 0.0;
    for (std::size_t i = 1; i < frequencies_.size(); ++i)
        if (turns_[i] != 0.0)
            sum += turns_[i] * frequencies_[i] * besselOverMean(a * frequencies_[i]);
    return 2.0 * pi / (a * a) * sum;
}

double HazeFunction::energyWithin(double angle_rad) const {
    if (!(angle_rad > 0.0))
        return 0.0;
    const double a = 2.0 * pi * angle_rad;
    double sum = 0.0;
    for (std::size_t i = 1; i < frequencies_.size(); ++i)
        if (turns_[i] != 0.0)
            sum += turns_[i] * integralOfJ0(a * frequencies_[i]);
    return energy_ + sum / a;
}

} // namespace irsg
