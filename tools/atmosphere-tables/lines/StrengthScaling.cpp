#include "tools/atmosphere-tables/lines/StrengthScaling.h"

#include <algorithm>
#include <cmath>

#include "irsg/core/Errors.h"
#include "tools/atmosphere-tables/lines/LineAbsorption.h"

namespace irsg::lbl {

namespace {

constexpr double step_per_cm = 0.02, leastTransmittance = 1e-4, leastDepth = 5e-4;
constexpr int rounds = 8;

/// Optical depths of the mean transmittances over windows.
class WindowMeans {
  public:
    explicit WindowMeans(const ScalingWindows& windows)
        : windows_(windows), sums_(count(), 0.0), members_(count(), 0.0) {}

    std::size_t count() const {
        return static_cast<std::size_t>(
            std::lround((windows_.upper_per_cm - windows_.lower_per_cm) / windows_.width_per_cm));
    }
    void add(double wavenumber_per_cm, double transmittance) {
        if (wavenumber_per_cm < windows_.lower_per_cm || wavenumber_per_cm >= windows_.upper_per_cm)
            return;
        const auto window =
            std::min(static_cast<std::size_t>((wavenumber_per_cm - windows_.lower_per_cm) /
                                              windows_.width_per_cm),
                     count() - 1);
        sums_[window] += transmittance;
        members_[window] += 1.0;
    }
    std::vector<double> depths() const {
        std::vector<double> depths;
        for (std::size_t i = 0; i < count(); ++i) {
            if (members_[i] == 0.0)
                throw LogicError("a window of the spectrum has no known transmittance");
            depths.push_back(-std::log(std::max(sums_[i] / members_[i], leastTransmittance)));
        }
        return depths;
    }

  private:
    ScalingWindows windows_;
    std::vector<double> sums_, members_;
};

std::vector<double> depthsOf(const LineList& list, const KnownPath& path,
                             const ScalingWindows& windows) {
    const WavenumberGrid grid{windows.lower_per_cm + 0.5 * step_per_cm, step_per_cm,
                              static_cast<std::size_t>(std::lround(
                                  (windows.upper_per_cm - windows.lower_per_cm) / step_per_cm))};
    const AtmosphericState& air = path.air;
    const std::vector<double> cross_cm2 =
        crossSection_cm2(list, PartitionSums::rigidRotor(), grid, air.temperature_K,
                         air.pressure_hPa, air.fraction(list.gas), defaultLineShape(list.gas));
    const double column_per_cm2 = air.density_per_m3(list.gas) * 1e-6 * path.length_cm;
    WindowMeans means(windows);
    for (std::size_t i = 0; i < grid.count; ++i)
        means.add(grid.at(i), std::exp(-column_per_cm2 * cross_cm2[i]));
    return means.depths();
}

/// ln of the factor, from its values in the middle of the windows.
double between(const std::vector<double>& lnFactors, const ScalingWindows& windows,
               double nu_per_cm) {
    const double last = static_cast<double>(lnFactors.size() - 1);
    const double place =
        std::clamp((nu_per_cm - windows.lower_per_cm) / windows.width_per_cm - 0.5, 0.0, last);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, lnFactors.size() - 1);
    return std::lerp(lnFactors[below], lnFactors[above], place - static_cast<double>(below));
}

} // namespace

void scaleStrengths(LineList& list, const KnownPath& path, const ScalingWindows& windows) {
    const double parts = (windows.upper_per_cm - windows.lower_per_cm) / windows.width_per_cm;
    if (!(parts >= 1.0) || std::abs(parts - std::round(parts)) > 1e-9)
        throw LogicError("windows of the spectrum do not fill their range");
    WindowMeans known(windows);
    for (std::size_t i = 0; i < path.wavenumbers_per_cm.size(); ++i)
        known.add(path.wavenumbers_per_cm[i], path.transmittances.at(i));
    const std::vector<double> wanted = known.depths();

    const std::vector<Line> original = list.lines;
    std::vector<double> lnFactors(wanted.size(), 0.0);
    for (int round = 0; round < rounds; ++round) {
        const std::vector<double> depths = depthsOf(list, path, windows);
        for (std::size_t i = 0; i < wanted.size(); ++i) {
            if (wanted[i] < leastDepth || depths[i] <= 0.0)
                continue;
            // Absorption of many lines grows between the square root and the first power of K.
            constexpr double growth = 0.7;
            const double most = std::log(3.0);
            lnFactors[i] =
                std::clamp(lnFactors[i] + std::log(wanted[i] / depths[i]) / growth, -most, most);
        }
        for (std::size_t k = 0; k < original.size(); ++k) {
            const double nu_per_cm = original[k].wavenumber_per_cm;
            if (nu_per_cm >= windows.lower_per_cm && nu_per_cm <= windows.upper_per_cm)
                list.lines[k].intensity =
                    original[k].intensity * std::exp(between(lnFactors, windows, nu_per_cm));
        }
    }
}

} // namespace irsg::lbl
