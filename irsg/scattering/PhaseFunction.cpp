#include "irsg/scattering/PhaseFunction.h"

#include <algorithm>
#include <cmath>

#include "irsg/core/Errors.h"
#include "irsg/core/Interpolation.h"
#include "irsg/core/ParallelFor.h"
#include "irsg/radiometry/Units.h"
#include "irsg/scattering/BesselIntegral.h"
#include "irsg/scattering/Mie.h"

namespace irsg {

namespace {

constexpr std::size_t fewestAngles = 1801;
constexpr double anglesOfRing = 16.0;
constexpr double smallestSize = 1e-3;

/// Integral of p sin t over a piece on which p is linear, exactly.
double share(double t0, double t1, double p0, double p1) {
    const double slope = (p1 - p0) / (t1 - t0);
    return p0 * std::cos(t0) - p1 * std::cos(t1) + slope * (std::sin(t1) - std::sin(t0));
}

} // namespace

PhaseFunction::PhaseFunction(std::vector<double> angles_rad, std::vector<double> values)
    : angles_rad_(std::move(angles_rad)), values_(std::move(values)), below_{0.0} {
    if (angles_rad_.size() < 3 || values_.size() != angles_rad_.size() ||
        angles_rad_.front() != 0.0 || std::abs(angles_rad_.back() - pi) > 1e-12)
        throw LogicError("a phase function has values at angles from 0 to pi");
    for (std::size_t i = 0; i + 1 < angles_rad_.size(); ++i)
        below_.push_back(below_.back() +
                         2.0 * pi *
                             share(angles_rad_[i], angles_rad_[i + 1], values_[i], values_[i + 1]));
    const double whole = below_.back();
    for (double& value : values_)
        value /= whole;
    for (double& part : below_)
        part /= whole;

    std::vector<double> forward;
    for (std::size_t i = 0; i < angles_rad_.size(); ++i) {
        const double t = std::min(angles_rad_[i], 0.5 * pi);
        forwardAngles_.push_back(t);
        forward.push_back(t > 0.0 ? at(t) * std::sin(t) / t : at(0.0));
        if (angles_rad_[i] >= 0.5 * pi)
            break;
    }
    atEnd_ = forward.back();
    std::vector<double> slopes{0.0};
    for (std::size_t i = 0; i + 1 < forward.size(); ++i)
        slopes.push_back((forward[i + 1] - forward[i]) /
                         (forwardAngles_[i + 1] - forwardAngles_[i]));
    slopes.push_back(0.0);
    for (std::size_t i = 0; i < forward.size(); ++i)
        turns_.push_back(slopes[i] - slopes[i + 1]);
}

PhaseFunction PhaseFunction::henyeyGreenstein(double asymmetry) {
    constexpr double most = 0.98; // its peak is ten angles wide then
    if (!(std::abs(asymmetry) <= most))
        throw InputError(
            {"", "asymmetry of the scattering", numberText(asymmetry), "-0.98 to 0.98"});
    constexpr std::size_t count = 2 * fewestAngles - 1;
    const double g = asymmetry;
    std::vector<double> angles(count), values(count);
    for (std::size_t i = 0; i < count; ++i) {
        angles[i] = pi * static_cast<double>(i) / static_cast<double>(count - 1);
        values[i] = std::pow(1.0 + g * g - 2.0 * g * std::cos(angles[i]), -1.5);
    }
    return PhaseFunction(std::move(angles), std::move(values));
}

double PhaseFunction::at(double angle_rad) const {
    return interpolate(angles_rad_, values_, angle_rad, Beyond::extrapolate);
}

double PhaseFunction::asymmetry() const {
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < angles_rad_.size(); ++i) {
        // cos t sin t = sin(2t) / 2: the same integral in the doubled angle.
        const double t0 = 2.0 * angles_rad_[i], t1 = 2.0 * angles_rad_[i + 1];
        sum += 0.25 * share(t0, t1, values_[i], values_[i + 1]);
    }
    return 2.0 * pi * sum;
}

double PhaseFunction::forwardFraction() const {
    return transform(0.0);
}

double PhaseFunction::transform(double frequency_per_rad) const {
    const double a = 2.0 * pi * frequency_per_rad;
    const double end = forwardAngles_.back();
    if (a * end < 1e-5) {
        const auto i = static_cast<std::size_t>(std::ranges::lower_bound(angles_rad_, 0.5 * pi) -
                                                angles_rad_.begin());
        const double before = below_[i - 1];
        return before + 2.0 * pi * share(angles_rad_[i - 1], end, values_[i - 1], at(end));
    }
    // By parts, as in HazeFunction; what is left at the end of the half is a term of its own.
    double sum = 0.0;
    for (std::size_t i = 1; i < forwardAngles_.size(); ++i)
        sum += turns_[i] * forwardAngles_[i] * besselOverMean(a * forwardAngles_[i]);
    return 2.0 * pi * (atEnd_ * end * ::j1(a * end) / a + sum / (a * a));
}

double PhaseFunction::cosineAt(double u) const {
    // Uniform in the cosine within a piece, which is narrow beside the rings.
    const Bracket at = bracket(below_, u);
    return lerp(std::cos(angles_rad_[at.below]), std::cos(angles_rad_[at.above]), at.fraction);
}

DropletOptics dropletOptics(const SizeDistribution& sizes, std::complex<double> index,
                            double wavelength_um, const std::function<bool(double)>& tell) {
    const SizeDistribution::Nodes nodes = sizes.nodes();
    const double perRadius = 2.0 * pi / wavelength_um;
    const double largest = perRadius * *std::ranges::max_element(nodes.radii_um);
    if (largest > 2e4)
        throw InputError({"", "droplets", "a size parameter of " + numberText(largest),
                          "at most 20000: smaller droplets or a longer wavelength"});
    const auto count =
        std::max(fewestAngles, static_cast<std::size_t>(anglesOfRing * largest) | 1u);
    std::vector<double> angles(count), cosines(count), sum(count, 0.0);
    for (std::size_t i = 0; i < count; ++i) {
        angles[i] = pi * static_cast<double>(i) / static_cast<double>(count - 1);
        cosines[i] = std::cos(angles[i]);
    }
    double extinction = 0.0, scattering = 0.0;
    constexpr std::size_t blocks = 16;
    for (std::size_t r = 0; r < nodes.radii_um.size(); ++r) {
        if (tell && !tell(static_cast<double>(r) / static_cast<double>(nodes.radii_um.size())))
            throw Cancelled{};
        const double radius = nodes.radii_um[r];
        if (perRadius * radius < smallestSize)
            continue; // scatters as the sixth power of so little
        const MieSphere sphere(index, perRadius * radius);
        const MieEfficiencies of = sphere.efficiencies();
        const double shadow = nodes.numbers[r] * pi * radius * radius;
        extinction += shadow * of.extinction;
        scattering += shadow * of.scattering;
        parallelFor(blocks, [&](std::size_t block) {
            const std::size_t first = beginOfPart(block, blocks, count);
            const std::size_t last = beginOfPart(block + 1, blocks, count);
            const std::vector<MieAmplitudes> amplitudes =
                sphere.amplitudes(std::span(cosines).subspan(first, last - first));
            for (std::size_t i = first; i < last; ++i)
                sum[i] += nodes.numbers[r] * 0.5 *
                          (std::norm(amplitudes[i - first].across) +
                           std::norm(amplitudes[i - first].along));
        });
    }
    return {PhaseFunction(std::move(angles), std::move(sum)), extinction, scattering};
}

} // namespace irsg
