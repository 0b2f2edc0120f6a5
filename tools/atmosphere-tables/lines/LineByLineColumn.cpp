#include "tools/atmosphere-tables/lines/LineByLineColumn.h"

#include <algorithm>
#include <cmath>

#include "irsg/atmosphere/engine/Continuum.h"
#include "irsg/core/Errors.h"
#include "irsg/radiometry/Planck.h"

namespace irsg::lbl {

namespace {

/// Black body radiance per wavenumber, W m-2 sr-1 / cm-1.
double planckPerWavenumber(double wavenumber_per_cm, double temperature_K) {
    const double wavelength_um = 1e4 / wavenumber_per_cm;
    return planckRadiance_W_m2_sr_um(wavelength_um, temperature_K) * wavelength_um /
           wavenumber_per_cm;
}

/// Continua on a coarse grid, as they vary slowly.
class CoarseContinuum {
  public:
    CoarseContinuum(const AtmosphericState& air, double lower_per_cm, double upper_per_cm)
        : lower_per_cm_(lower_per_cm) {
        for (double nu = lower_per_cm; nu < upper_per_cm + step_per_cm; nu += step_per_cm)
            values_.push_back(continuumAbsorption_per_m(air, nu));
    }
    double at(double wavenumber_per_cm) const {
        const double place = (wavenumber_per_cm - lower_per_cm_) / step_per_cm;
        const auto i = std::min(static_cast<std::size_t>(place), values_.size() - 2);
        const double part = place - static_cast<double>(i);
        return (1.0 - part) * values_[i] + part * values_[i + 1];
    }

  private:
    static constexpr double step_per_cm = 1.0;
    double lower_per_cm_;
    std::vector<double> values_;
};

} // namespace

LineByLineColumn::LineByLineColumn(const std::vector<LineList>& gases,
                                   const PartitionSums& partition, const Profile& profile,
                                   std::vector<double> levels_m, double lower_per_cm,
                                   double upper_per_cm, double step_per_cm)
    : profile_(profile), levels_m_(std::move(levels_m)) {
    if (levels_m_.size() < 2 || !(lower_per_cm < upper_per_cm) || step_per_cm <= 0.0)
        throw LogicError("a column of air has no levels or no spectrum");
    grid_.step_per_cm = step_per_cm;
    grid_.first_per_cm = lower_per_cm + 0.5 * step_per_cm;
    grid_.count =
        static_cast<std::size_t>(std::lround((upper_per_cm - lower_per_cm) / step_per_cm));

    for (const double altitude_m : levels_m_) {
        const AtmosphericState air = profile.at(altitude_m);
        std::vector<double> extinction(grid_.count, 0.0);
        for (const LineList& gas : gases) {
            const double density_per_m3 = air.density_per_m3(gas.gas);
            if (density_per_m3 <= 0.0)
                continue;
            const std::vector<double> cross_cm2 = crossSection_cm2(
                gas, partition, grid_, air.temperature_K, air.pressure_hPa, air.fraction(gas.gas),
                defaultLineShape(gas.gas), negligible_cm2(gas.gas));
            for (std::size_t i = 0; i < grid_.count; ++i)
                extinction[i] += density_per_m3 * 1e-4 * cross_cm2[i];
        }
        const CoarseContinuum continuum(air, lower_per_cm, upper_per_cm);
        std::vector<float> level(grid_.count);
        for (std::size_t i = 0; i < grid_.count; ++i)
            level[i] = static_cast<float>(extinction[i] + continuum.at(grid_.at(i)));
        extinction_per_m_.push_back(std::move(level));
    }
}

LineByLineColumn::Means LineByLineColumn::along(const RayPath& ray, double width_per_cm) const {
    const auto perBin = static_cast<std::size_t>(std::lround(width_per_cm / grid_.step_per_cm));
    const std::size_t bins = grid_.count / perBin;
    Means means{std::vector<double>(bins), std::vector<double>(bins)};

    struct Ends {
        double start_K, end_K;
    };
    std::vector<Ends> ends;
    for (const RaySegment& segment : ray.segments)
        ends.push_back({profile_.at(segment.startAltitude_m).temperature_K,
                        profile_.at(segment.endAltitude_m).temperature_K});

    std::vector<double> startPlanck(ends.size()), endPlanck(ends.size());
    for (std::size_t bin = 0; bin < bins; ++bin) {
        // Black bodies change little over a bin.
        const double centre_per_cm = grid_.first_per_cm - 0.5 * grid_.step_per_cm +
                                     (static_cast<double>(bin) + 0.5) * width_per_cm;
        for (std::size_t s = 0; s < ends.size(); ++s) {
            startPlanck[s] = planckPerWavenumber(centre_per_cm, ends[s].start_K);
            endPlanck[s] = planckPerWavenumber(centre_per_cm, ends[s].end_K);
        }
        for (std::size_t i = bin * perBin; i < (bin + 1) * perBin; ++i) {
            double through = 1.0, radiance = 0.0;
            for (std::size_t s = 0; s < ray.segments.size(); ++s) {
                const RaySegment& segment = ray.segments[s];
                const auto layer = static_cast<std::size_t>(segment.layer);
                const double depth =
                    segment.length_m *
                    ((1.0 - segment.meanFraction) *
                         static_cast<double>(extinction_per_m_[layer][i]) +
                     segment.meanFraction * static_cast<double>(extinction_per_m_[layer + 1][i]));
                // The source is linear in optical depth from the near end to the far one.
                const double passed = std::exp(-depth), absorbed = -std::expm1(-depth);
                const double slope = depth > 1e-4 ? absorbed / depth - passed : 0.5 * depth;
                radiance +=
                    through * (startPlanck[s] * absorbed + (endPlanck[s] - startPlanck[s]) * slope);
                through *= passed;
                if (through < 1e-12)
                    break;
            }
            means.transmittance[bin] += through;
            means.radiance_W_m2_sr_per_cm[bin] += radiance;
        }
        means.transmittance[bin] /= static_cast<double>(perBin);
        means.radiance_W_m2_sr_per_cm[bin] /= static_cast<double>(perBin);
    }
    return means;
}

} // namespace irsg::lbl
